namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Of shapes that are said to overlap, no plane has one on either side: looked for along many directions and
/// across the faces of both.</summary>
internal static class NoPlaneSeparatesAnOverlap
{
    private const int MostFaces = 200;

    /// <summary>Dot products to spend on the faces of each shape.</summary>
    private const int MostWork = 20_000;

    public static string? Broken(FuzzPair pair)
    {
        if (!pair.Answer.IsOverlapping) return null;
        double widest = Widest(pair), allowed = pair.Band(0) + pair.Noise;
        return widest <= allowed ? null : Say.Line($"a plane leaves {widest} between them");
    }

    /// <summary>The widest gap between planes that was found; negative where each costs a way to part them.</summary>
    public static double Widest(FuzzPair pair)
    {
        double widest = double.NegativeInfinity;
        int faces = Math.Max(
            1, Math.Min(MostFaces, MostWork / Math.Max(1, pair.BodyA.Vertices.Length + pair.BodyB.Vertices.Length)));
        foreach (Double3 n in pair.Truth.IsKnown ? Directions.Few : Directions.Many)
            widest = Math.Max(widest, pair.Gap(n));
        foreach (Double3 n in pair.BodyA.FaceNormals(faces)) widest = Math.Max(widest, pair.Gap(pair.BodyA.Rotate(n)));
        foreach (Double3 n in pair.BodyB.FaceNormals(faces))
            widest = Math.Max(widest, pair.Gap(pair.BodyB.Rotate(-n)));
        double length = pair.Centers.Length;
        return length > 0 ? Math.Max(widest, pair.Gap(pair.Centers * (1 / length))) : widest;
    }
}
