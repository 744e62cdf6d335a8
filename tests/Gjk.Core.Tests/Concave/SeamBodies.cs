namespace Gjk.Core.Tests.Concave;

/// <summary>What slides over seams, and what they are in.</summary>
internal static class SeamBodies
{
    public static AnyShape Named(string name) => AnyShape.Of(name switch
    {
        "ball" => ConvexShape.Sphere(0.3f),
        "box" => ConvexShape.Box(new Vector3(0.5f, 0.2f, 0.3f)),
        "capsule" => ConvexShape.Capsule(0.2f, 0.6f).Placed(
            new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2), Vector3.Zero)),
        _ => ConvexShape.Mesh(Clouds.Prism(7, 0.5f, 0.2f)),
    });

    /// <summary>A plate of cells of unit size, each cut in two along either diagonal.</summary>
    public static TriangleMesh Plate(int n, int cut, Func<float, float, float> height)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i <= n; i++)
            for (int j = 0; j <= n; j++)
            {
                float x = i - n / 2f, z = j - n / 2f;
                points.Add(new Vector3(x, height(x, z), z));
                if (i == n || j == n) continue;
                int p = i * (n + 1) + j, q = p + n + 1;
                bool isOther = cut == 1 || (cut == 2 && (i + j) % 2 == 0) || (cut == 3 && i * 7 % 3 == j * 5 % 3);
                indices.AddRange(
                    isOther ? [p, p + 1, q + 1, p, q + 1, q] : new[] { p, p + 1, q, p + 1, q + 1, q });
            }

        return new TriangleMesh(points, indices);
    }

    public static Quaternion Tilt(Rng random, double most) => Quaternion.Normalize(
        new Quaternion(
            random.Float(-1, 1) * (float)most / 2, random.Float(-1, 1), random.Float(-1, 1) * (float)most / 2, 1));

    /// <summary>A body over the plane y = 0, its lowest point at a height.</summary>
    public static RigidPose Placed(in AnyShape body, Vector3 over, Quaternion own, float height)
    {
        var half = AnyShape.Of(ConvexShape.Box(new Vector3(100, 1, 100)));
        var high = new RigidPose(own, over + new Vector3(0, 3, 0));
        float gap = ConvexQuery.Distance(half.Convex, new RigidPose(-Vector3.UnitY), body.Convex, high).Distance;
        return new RigidPose(own, over + new Vector3(0, 3 - gap + height, 0));
    }
}
