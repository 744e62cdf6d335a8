namespace Gjk.Core.Tests;

/// <summary>Clouds of points, each made again by its seed.</summary>
internal static class HullClouds
{
    public static Vector3 OnSphere(Random random)
    {
        while (true)
        {
            double x = 2 * random.NextDouble() - 1, y = 2 * random.NextDouble() - 1, z = 2 * random.NextDouble() - 1;
            double length = Math.Sqrt(x * x + y * y + z * z);
            if (length is > 0.1 and < 1)
                return new Vector3((float)(x / length), (float)(y / length), (float)(z / length));
        }
    }

    public static Vector3[] Sphere(int seed, int count, float radius = 1)
    {
        var random = new Random(seed);
        return Make(count, _ => radius * OnSphere(random));
    }

    public static Vector3[] Ball(int seed, int count, float radius = 1)
    {
        var random = new Random(seed);
        return Make(count, _ => radius * (float)Math.Cbrt(random.NextDouble()) * OnSphere(random));
    }

    public static Vector3[] Box(int seed, int count, float halfSide = 1)
    {
        var random = new Random(seed);
        return Make(count, _ => halfSide * new Vector3(Signed(random), Signed(random), Signed(random)));
    }

    /// <summary>Whole numbers from 0 to side - 1: many repeats, lines and planes.</summary>
    public static Vector3[] SmallIntegers(int seed, int count, int side, float step = 1)
    {
        var random = new Random(seed);
        return Make(count, _ => step * new Vector3(random.Next(side), random.Next(side), random.Next(side)));
    }

    public static Vector3[] Grid(int side, float step = 1)
    {
        var points = new List<Vector3>();
        for (int x = 0; x < side; x++)
            for (int y = 0; y < side; y++)
                for (int z = 0; z < side; z++)
                    points.Add(step * new Vector3(x, y, z));
        return points.ToArray();
    }

    /// <summary>A sphere as a spiral from pole to pole, evenly dense.</summary>
    public static Vector3[] Spiral(int count, float radius = 1) => Make(count, i =>
    {
        double z = 1 - (2 * i + 1.0) / count, r = Math.Sqrt(1 - z * z), angle = i * Math.PI * (3 - Math.Sqrt(5));
        return radius * new Vector3((float)(r * Math.Cos(angle)), (float)(r * Math.Sin(angle)), (float)z);
    });

    /// <summary>Bit patterns at random: signs and magnitudes from denormal to the largest float, all equally
    /// likely.</summary>
    public static Vector3[] AnyFloats(int seed, int count)
    {
        var random = new Random(seed);
        return Make(count, _ => new Vector3(AnyFloat(random), AnyFloat(random), AnyFloat(random)));
    }

    public static float AnyFloat(Random random)
    {
        while (true)
        {
            float x = BitConverter.Int32BitsToSingle(random.Next() ^ random.Next() << 16);
            if (float.IsFinite(x)) return x;
        }
    }

    /// <summary>A square full of points, turned and then rounded to floats: flat but for the last bits.</summary>
    public static Vector3[] TurnedSquare(int seed, int count)
    {
        var random = new Random(seed);
        var turn = Quaternion.CreateFromYawPitchRoll(0.7f, 0.4f, 0.9f);
        return Make(count, _ => Vector3.Transform(new Vector3(Signed(random), Signed(random), 0), turn));
    }

    /// <summary>Points of the plane z = x + y, exactly: multiples of 2^-23 around a centre.</summary>
    public static Vector3[] ExactPlane(int seed, int count)
    {
        var random = new Random(seed);
        return Make(count, _ =>
        {
            int x = random.Next(-2000000, 2000000), y = random.Next(-2000000, 2000000);
            return new Vector3(x, y, x + y) / (1 << 23);
        });
    }

    /// <summary>Multiples of (1, 3, 5) from 1 down to 2^-44: on a line exactly, but double rounds their
    /// differences.</summary>
    public static Vector3[] WideLine(int seed, int count)
    {
        var random = new Random(seed);
        return Make(count, _ => Shrunk(random, 44) * new Vector3(1, 3, 5));
    }

    /// <summary>Points of the plane z = x + y through the origin, from 1 down to 2^-depth: exactly coplanar, but double
    /// rounds what is computed from them.</summary>
    public static Vector3[] WidePlane(int seed, int count, int depth)
    {
        var random = new Random(seed);
        return Make(count, _ =>
        {
            float scale = (float)Math.Pow(2, -22 - random.Next(depth + 1));
            int x = random.Next(-(1 << 22), 1 << 22), y = random.Next(-(1 << 22), 1 << 22);
            return scale * new Vector3(x, y, x + y);
        });
    }

    /// <summary>A plane that holds a coordinate axis: small whole numbers along the other two, any magnitude along it.
    /// A lattice in two of three axes.</summary>
    public static Vector3[] PlaneAlongAxis(int seed, int count)
    {
        var random = new Random(seed);
        int axis = random.Next(3);
        return Make(count, _ =>
        {
            int k = random.Next(1 << 13);
            float free = Shrunk(random, 44), three = 3 * k, five = 5 * k;
            return axis == 0 ? new Vector3(free, three, five)
                : axis == 1 ? new Vector3(five, free, three)
                : new Vector3(three, five, free);
        });
    }

    public static Vector3[] Permuted(Vector3[] cloud, int seed)
    {
        var random = new Random(seed);
        var copy = (Vector3[])cloud.Clone();
        for (int i = copy.Length - 1; i > 0; i--)
        {
            int j = random.Next(i + 1);
            (copy[i], copy[j]) = (copy[j], copy[i]);
        }

        return copy;
    }

    /// <summary>21 random bits over 2^21, divided by a power of two up to 2^depth.</summary>
    private static float Shrunk(Random random, int depth) =>
        random.Next(1, 1 << 21) * (float)Math.Pow(2, -21 - random.Next(depth + 1));

    private static float Signed(Random random) => (float)(2 * random.NextDouble() - 1);

    private static Vector3[] Make(int count, Func<int, Vector3> point)
    {
        var points = new Vector3[count];
        for (int i = 0; i < count; i++) points[i] = point(i);
        return points;
    }
}
