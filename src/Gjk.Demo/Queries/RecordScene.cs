namespace Gjk.Demo.Queries;

/// <summary>Reads one query in the text form of the library's <see cref="QueryRecord"/> as a scene of two
/// objects.</summary>
internal static class RecordScene
{
    /// <summary>The input that is read for the text. "-" means standard input, where a record may be longer than a
    /// command line. Any other text needs no file.</summary>
    public static string? InputOf(string text) => text == InputFile.StandardInput ? text : null;

    /// <exception cref="RefusedException">The text is not a record.</exception>
    public static Scene Read(string text, CancellationToken cancel)
    {
        if (text == InputFile.StandardInput) text = Encoding.UTF8.GetString(InputFile.Read(text, cancel));
        if (!QueryRecord.TryParse(text, out QueryRecord record, out string? reason))
            throw new RefusedException("--record: " + reason);
        SceneObject[] objects = [Object("A", record.A, record.MotionA), Object("B", record.B, record.MotionB)];
        return new Scene("record", objects, ScenePairs.All(objects.Length), 1);
    }

    private static SceneObject Object(string name, in ConvexShape shape, in RigidMotion motion) =>
        new(name, shape, motion.Pose, motion.Velocity, motion.AngularVelocity);
}
