using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Worst;

/// <summary>Measures the supports of a hull, separately for each direction.</summary>
internal static class SupportClock
{
    private const int Directions = 500;

    /// <summary>Supports per sample. They take some microseconds, which is long compared with the cost of reading the
    /// clock.</summary>
    private const int Repeats = 32;

    /// <summary>Samples per direction. The fastest one counts, because a disturbance can only add time.</summary>
    private const int Samples = 5;

    private const ulong Seed = 41;

    /// <summary>The least power of ten by which a direction differs from a normal. The powers go up to -1.</summary>
    private const int LeastOffset = -18;

    public static SupportCost AlongRandom(ConvexHull hull)
    {
        var prng = new Prng(Seed);
        return Measure(hull, _ => prng.Direction());
    }

    public static SupportCost AlongNormals(ConvexHull hull)
    {
        var prng = new Prng(Seed);
        return Measure(hull, _ => Normal(hull, prng));
    }

    public static SupportCost NearNormals(ConvexHull hull)
    {
        var prng = new Prng(Seed);
        return Measure(hull, i =>
        {
            Double3 normal = Normal(hull, prng);
            return normal + normal.Length * Math.Pow(10, LeastOffset + i % -LeastOffset) * (Double3)prng.Direction();
        });
    }

    private static SupportCost Measure(ConvexHull hull, Func<int, Double3> direction)
    {
        double sum = 0, worst = 0;
        var mesh = new ConvexMesh(hull);
        for (int i = 0; i < Directions; i++)
        {
            double nanoseconds = Nanoseconds(mesh, direction(i));
            sum += nanoseconds;
            worst = Math.Max(worst, nanoseconds);
        }

        return new SupportCost(sum / Directions, worst);
    }

    private static double Nanoseconds(in ConvexMesh mesh, in Double3 direction)
    {
        double best = double.PositiveInfinity;
        long ids = 0;
        for (int sample = 0; sample < Samples; sample++)
        {
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < Repeats; i++) ids += mesh.Support(direction, out _);
            best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalNanoseconds / Repeats);
        }

        return ids < 0 ? throw new FactorCheckException("A support had no id") : best;
    }

    /// <summary>The normal of a random triangle in double. A hull without triangles gets a random direction.</summary>
    private static Double3 Normal(ConvexHull hull, Prng prng)
    {
        if (hull.TriangleCount == 0) return prng.Direction();
        hull.GetTriangle(prng.Index(hull.TriangleCount), out int a, out int b, out int c);
        Double3 origin = hull.GetVertex(a);
        Double3 normal = Double3.Cross(hull.GetVertex(b) - origin, hull.GetVertex(c) - origin);
        return normal.LengthSquared > 0 ? normal : prng.Direction();
    }
}
