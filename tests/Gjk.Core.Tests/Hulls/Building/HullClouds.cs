namespace Gjk.Core.Tests;

/// <summary>Clouds of points, each made again by its seed.</summary>
internal static class HullClouds
{
    public static Vector3[] Sphere(int seed, int count, float radius = 1) =>
        Make(seed, count, rng => radius * rng.UnitVector());

    public static Vector3[] Ball(int seed, int count, float radius = 1) =>
        Make(seed, count, rng => radius * (float)Math.Cbrt(rng.Unit()) * rng.UnitVector());

    public static Vector3[] Box(int seed, int count, float halfSide = 1) =>
        Make(seed, count, rng => halfSide * rng.Vector(1));

    /// <summary>Whole numbers from 0 to side - 1: many repeats, lines and planes.</summary>
    public static Vector3[] SmallIntegers(int seed, int count, int side, float step = 1) =>
        Make(seed, count, rng => step * new Vector3(rng.Below(side), rng.Below(side), rng.Below(side)));

    public static Vector3[] Grid(int side, float step = 1)
    {
        var points = new List<Vector3>();
        for (int x = 0; x < side; x++)
            for (int y = 0; y < side; y++)
                for (int z = 0; z < side; z++)
                    points.Add(step * new Vector3(x, y, z));
        return points.ToArray();
    }

    /// <summary>Bit patterns at random: signs and magnitudes from denormal to the largest float, all equally
    /// likely.</summary>
    public static Vector3[] AnyFloats(int seed, int count) =>
        Make(seed, count, rng => new Vector3(AnyFloat(rng), AnyFloat(rng), AnyFloat(rng)));

    /// <summary>A square full of points, turned and then rounded to floats: flat but for the last bits.</summary>
    public static Vector3[] TurnedSquare(int seed, int count)
    {
        var turn = Quaternion.CreateFromYawPitchRoll(0.7f, 0.4f, 0.9f);
        return Make(seed, count, rng => Vector3.Transform(new Vector3(rng.Float(-1, 1), rng.Float(-1, 1), 0), turn));
    }

    /// <summary>Points of the plane z = x + y, exactly: multiples of 2^-23 around a centre.</summary>
    public static Vector3[] ExactPlane(int seed, int count) => Make(seed, count, rng =>
    {
        int x = rng.Below(4000000) - 2000000, y = rng.Below(4000000) - 2000000;
        return new Vector3(x, y, x + y) / (1 << 23);
    });

    /// <summary>Multiples of (1, 3, 5) from 1 down to 2^-44: on a line exactly, but double rounds their
    /// differences.</summary>
    public static Vector3[] WideLine(int seed, int count) =>
        Make(seed, count, rng => Shrunk(rng, 44) * new Vector3(1, 3, 5));

    /// <summary>Points of the plane z = x + y through the origin, from 1 down to 2^-depth: exactly coplanar, but double
    /// rounds what is computed from them.</summary>
    public static Vector3[] WidePlane(int seed, int count, int depth) => Make(seed, count, rng =>
    {
        float scale = (float)Math.Pow(2, -22 - rng.Below(depth + 1));
        int x = rng.Below(1 << 23) - (1 << 22), y = rng.Below(1 << 23) - (1 << 22);
        return scale * new Vector3(x, y, x + y);
    });

    /// <summary>A plane that holds a coordinate axis: small whole numbers along the other two, any magnitude along it.
    /// A lattice in two of three axes.</summary>
    public static Vector3[] PlaneAlongAxis(int seed, int count) => Make(seed, count, rng =>
    {
        int k = rng.Below(1 << 13), axis = seed % 3;
        float free = Shrunk(rng, 44), three = 3 * k, five = 5 * k;
        return axis == 0 ? new Vector3(free, three, five)
            : axis == 1 ? new Vector3(five, free, three)
            : new Vector3(three, five, free);
    });

    private static float AnyFloat(Rng rng)
    {
        while (true)
        {
            float x = BitConverter.UInt32BitsToSingle((uint)rng.Next());
            if (float.IsFinite(x)) return x;
        }
    }

    /// <summary>21 random bits over 2^21, divided by a power of two up to 2^depth.</summary>
    private static float Shrunk(Rng rng, int depth) =>
        (1 + rng.Below((1 << 21) - 1)) * (float)Math.Pow(2, -21 - rng.Below(depth + 1));

    private static Vector3[] Make(int seed, int count, Func<Rng, Vector3> point)
    {
        var rng = new Rng((ulong)seed);
        var points = new Vector3[count];
        for (int i = 0; i < count; i++) points[i] = point(rng);
        return points;
    }
}
