namespace Gjk.Demo.Queries;

/// <summary>Casts every pair of a scene: its objects move by their velocities over one frame, and turn where they have
/// an angular velocity, and the first touch is written as CSV.</summary>
internal static class CastCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="table">The table to write.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns>The exit code.</returns>
    public static int Run(Scene scene, PairTable table, CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        var scratch = new ConcaveScratch();
        return table.Write(
            CsvWriter.Casts,
            (rows, a, b) =>
            {
                CastResult answer = Answer(objects[a], objects[b], scratch);
                rows.Write(a, b, answer, table.IsChecked ? Check(objects[a], objects[b], answer) : default);
            },
            cancel);
    }

    /// <summary>Two witnesses prove nothing of a path that turns, or of other parts: the answer stays open.</summary>
    private static CheckStatus Check(SceneObject a, SceneObject b, in CastResult answer) =>
        Turns(a, b) || !a.IsConvex || !b.IsConvex
        ? CheckStatus.Open
        : AnswerCheck.Cast(a.Shape, a.Pose, a.Velocity, b.Shape, b.Pose, b.Velocity, answer).Status;

    private static bool Turns(SceneObject a, SceneObject b) =>
        a.AngularVelocity != Vector3.Zero || b.AngularVelocity != Vector3.Zero;

    /// <summary>A pair that does not turn is answered to the last bit, one that does to a tolerance.</summary>
    private static CastResult Answer(SceneObject a, SceneObject b, ConcaveScratch scratch) => (!Turns(a, b)
        ? ConcaveQuery.Cast(a.Any, a.Pose, a.Velocity, b.Any, b.Pose, b.Velocity, scratch)
        : ConcaveQuery.TimeOfImpact(a.Any, MotionOf(a), b.Any, MotionOf(b), scratch)).Result;

    private static RigidMotion MotionOf(SceneObject o) => new(o.Pose, o.Velocity, o.AngularVelocity);
}
