namespace Gjk.Exact.Fuzz.Shrinking;

/// <summary>One posed shape of a record with its motion, as its words: what shrinking changes. Immutable.</summary>
/// <param name="Kind">The shape's name.</param>
/// <param name="Numbers">Its numbers; of a mesh three for each corner.</param>
/// <param name="Scale">Three factors, or none.</param>
/// <param name="Pose">Rotation and position, seven numbers.</param>
/// <param name="Motion">Velocity and angular velocity, six numbers, or none.</param>
internal sealed record ShapeWords(
    string Kind, IReadOnlyList<string> Numbers, IReadOnlyList<string> Scale, IReadOnlyList<string> Pose,
    IReadOnlyList<string> Motion)
{
    public const string Mesh = "mesh";

    /// <summary>Of a shape without a pose of interest.</summary>
    public static ShapeWords Of(in ConvexShape shape)
    {
        string[] words = new QueryRecord(
            shape, RigidPose.Identity, ConvexShape.Point(), RigidPose.Identity).ToString().Split(' ');
        return Read(new Queue<string>(words.Skip(1)));
    }

    public static ShapeWords Read(Queue<string> words)
    {
        string kind = words.Dequeue();
        if (kind == Mesh) words.Dequeue();
        List<string> numbers = UntilSign(words), scale = [];
        if (words.Dequeue() == "*")
        {
            scale = UntilSign(words);
            words.Dequeue();
        }

        string[] pose = Next(words, 7), motion = [];
        if (words.TryPeek(out string? sign) && sign == "~")
        {
            words.Dequeue();
            motion = Next(words, 6);
        }

        return new ShapeWords(kind, numbers, scale, pose, motion);
    }

    public override string ToString()
    {
        var words = new List<string> { Kind };
        if (Kind == Mesh) words.Add((Numbers.Count / 3).ToString(System.Globalization.CultureInfo.InvariantCulture));
        words.AddRange(Numbers);
        if (Scale.Count > 0) words.Add("*");
        words.AddRange(Scale);
        words.Add("@");
        words.AddRange(Pose);
        if (Motion.Count > 0) words.Add("~");
        words.AddRange(Motion);
        return string.Join(' ', words);
    }

    private static string[] Next(Queue<string> words, int count)
    {
        var next = new string[count];
        for (int i = 0; i < count; i++) next[i] = words.Dequeue();
        return next;
    }

    private static List<string> UntilSign(Queue<string> words)
    {
        var numbers = new List<string>();
        while (words.Peek() is not ("*" or "@")) numbers.Add(words.Dequeue());
        return numbers;
    }
}
