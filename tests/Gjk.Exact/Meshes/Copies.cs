namespace Gjk.Exact.Meshes;

/// <summary>A cloud with more points than it needs, or with each of them a little off.</summary>
public static class Copies
{
    /// <summary>Each point several times more, every copy's coordinates up to one float away.</summary>
    public static Vector3[] OneFloatApart(Rng random, Vector3[] cloud, int times)
    {
        var copies = new List<Vector3>(cloud);
        for (int i = 0; i < times; i++)
            copies.AddRange(
                cloud.Select(p => new Vector3(Beside(random, p.X), Beside(random, p.Y), Beside(random, p.Z))));
        return [.. copies];
    }

    /// <summary>Each point once for every triangle that meets there: from two to six times, in no order.</summary>
    public static Vector3[] Unwelded(Rng random, Vector3[] cloud) =>
        Shuffled(random, [.. cloud.SelectMany(p => Enumerable.Repeat(p, 2 + random.Below(5)))]);

    /// <summary>The points in another order.</summary>
    public static Vector3[] Shuffled(Rng random, Vector3[] cloud)
    {
        Vector3[] copy = [.. cloud];
        for (int i = copy.Length - 1; i > 0; i--)
        {
            int k = random.Below(i + 1);
            (copy[i], copy[k]) = (copy[k], copy[i]);
        }

        return copy;
    }

    /// <summary>Without repeats, to the last bit.</summary>
    public static Vector3[] Welded(Vector3[] cloud) => [.. cloud.Distinct()];

    /// <summary>Measured, with an error of a given size.</summary>
    public static Vector3[] Scanned(Rng random, Vector3[] cloud, double noise) =>
        Array.ConvertAll(cloud, p => (Vector3)((Double3)p + Error(random, noise)));

    private static Double3 Error(Rng random, double noise) =>
        new(random.Range(-noise, noise), random.Range(-noise, noise), random.Range(-noise, noise));

    private static float Beside(Rng random, float x) =>
        random.Below(3) switch { 0 => x, 1 => MathF.BitIncrement(x), _ => MathF.BitDecrement(x) };
}
