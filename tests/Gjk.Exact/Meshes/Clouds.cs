namespace Gjk.Exact.Meshes;

/// <summary>Random clouds of points of about unit size, for meshes.</summary>
public static class Clouds
{
    /// <summary>Length: a power of two, so that lattice points and their sums are floats.</summary>
    public const float LatticeStep = 0.25f;

    public static Vector3[] InBox(Rng random, int count, Vector3 size)
    {
        var cloud = new Vector3[count];
        for (int i = 0; i < count; i++) cloud[i] = random.Vector(1) * size;
        return cloud;
    }

    public static Vector3[] OnSphere(Rng random, int count)
    {
        var cloud = new Vector3[count];
        for (int i = 0; i < count; i++) cloud[i] = (Vector3)random.Direction();
        return cloud;
    }

    public static Vector3[] Box(Vector3 half)
    {
        var cloud = new Vector3[8];
        for (int i = 0; i < 8; i++)
            cloud[i] = half * new Vector3((i & 1) == 0 ? 1 : -1, (i & 2) == 0 ? 1 : -1, (i & 4) == 0 ? 1 : -1);
        return cloud;
    }

    /// <summary>A step of a quarter unit in each direction, so that faces, edges and corners of lattice cubes
    /// meet.</summary>
    public static Vector3 LatticePoint(Rng random, int reach) =>
        new Vector3(
            random.Below(2 * reach + 1) - reach, random.Below(2 * reach + 1) - reach,
            random.Below(2 * reach + 1) - reach) * LatticeStep;

    /// <summary>Corners on a coarse grid: many parallel edges and coplanar faces.</summary>
    public static Vector3[] Lattice(Rng random)
    {
        var cloud = new Vector3[4 + random.Below(12)];
        for (int i = 0; i < cloud.Length; i++) cloud[i] = LatticePoint(random, 4);
        return cloud;
    }

    /// <summary>A regular prism about y, by sine and cosine in float: a corner above and the one below, in
    /// turn.</summary>
    public static Vector3[] Prism(int sides, float radius, float half)
    {
        var cloud = new Vector3[2 * sides];
        var t = new Trigonometry(InFloat: true);
        for (int i = 0; i < cloud.Length; i++) cloud[i] = t.OnRing(radius, i % 2 == 0 ? half : -half, i / 2, sides);
        return cloud;
    }

    /// <summary>A polygon of up to eight corners and its copy, a face each, moved straight or askew.</summary>
    public static Vector3[] Prism(Rng random)
    {
        int corners = 3 + random.Below(6);
        var cloud = new Vector3[2 * corners];
        float height = random.Float(0.1, 1), shear = random.OneIn(2) ? 0 : random.Float(-1, 1);
        for (int i = 0; i < corners; i++)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i / corners);
            cloud[i] = new Vector3((float)cos, -height, (float)sin);
            cloud[corners + i] = new Vector3((float)cos + shear, height, (float)sin);
        }

        return cloud;
    }

    /// <summary>In a coordinate plane, or in one through the origin that floats cannot hold exactly.</summary>
    public static Vector3[] Flat(Rng random)
    {
        Vector3[] cloud = InBox(random, 3 + random.Below(8), new Vector3(1, 0, 1));
        float slope = random.OneIn(2) ? 0 : random.Float(-1, 1);
        for (int i = 0; i < cloud.Length; i++) cloud[i].Y = cloud[i].X * slope;
        return cloud;
    }

    public static Vector3[] Straight(Rng random)
    {
        Vector3 along = random.OneIn(2) ? new Vector3(1, 0, 0) : random.Vector(1);
        var cloud = new Vector3[2 + random.Below(5)];
        for (int i = 0; i < cloud.Length; i++) cloud[i] = along * random.Float(-1, 1);
        return cloud;
    }

    /// <summary>The points, some of them more than once.</summary>
    public static Vector3[] Repeated(Rng random, Vector3[] cloud)
    {
        var repeated = new Vector3[cloud.Length * 3];
        for (int i = 0; i < repeated.Length; i++)
            repeated[i] = i < cloud.Length ? cloud[i] : cloud[random.Below(cloud.Length)];
        return repeated;
    }

    /// <summary>Moved and resized, as far as floats allow.</summary>
    public static Vector3[] Placed(Vector3[] cloud, float size, Vector3 offset) =>
        Array.ConvertAll(cloud, p => p * size + offset);

    /// <summary>Resized so that the largest coordinate has a given magnitude.</summary>
    public static Vector3[] Fitted(Vector3[] cloud, double size)
    {
        float largest = 0;
        foreach (Vector3 p in cloud)
            largest = Math.Max(largest, Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
        return Array.ConvertAll(cloud, p => (Vector3)((Double3)p * (size / largest)));
    }
}
