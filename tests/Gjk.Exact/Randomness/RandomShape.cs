namespace Gjk.Exact.Randomness;

/// <summary>Shapes of every kind, bare or decorated, about a unit large.</summary>
internal static class RandomShape
{
    private const int Kinds = 10;

    /// <summary>Count: more than a hull that is scanned as a whole has.</summary>
    private const int MostCorners = 200;

    public static ConvexShape Make(Rng random)
    {
        ConvexShape shape = Bare(random, random.Below(Kinds));
        if (random.OneIn(4))
            shape = shape.Scaled(new Vector3(random.Float(0.5, 2), random.Float(0.5, 2), random.Float(-2, -0.5)));
        if (random.OneIn(4)) shape = shape.Rounded(random.Float(0.01, 0.2));
        return random.OneIn(4)
            ? shape.Placed(new RigidPose(random.Rotation(), random.Vector(2)))
            : shape;
    }

    private static ConvexShape Bare(Rng random, int kind) => kind switch
    {
        0 => ConvexShape.Point(),
        1 => ConvexShape.Segment(random.Vector(1), random.Vector(1)),
        2 => ConvexShape.Triangle(random.Vector(1), random.Vector(1), random.Vector(1)),
        3 => ConvexShape.Sphere(random.Float(0.1, 1)),
        4 => ConvexShape.Capsule(random.Float(0.1, 1), random.Float(0.1, 1)),
        5 => ConvexShape.Box(new Vector3(random.Float(0.1, 1), random.Float(0.1, 1), random.Float(0.1, 1))),
        6 => ConvexShape.Cylinder(random.Float(0.1, 1), random.Float(0.1, 1)),
        7 => ConvexShape.Cone(random.Float(0.1, 1), random.Float(0.1, 1)),
        8 => ConvexShape.Ellipsoid(new Vector3(random.Float(0.1, 1), random.Float(0.1, 1), random.Float(0.1, 1))),
        _ => Mesh(random),
    };

    private static ConvexShape Mesh(Rng random)
    {
        var points = new Vector3[4 + random.Below(random.OneIn(4) ? MostCorners : 20)];
        for (int i = 0; i < points.Length; i++) points[i] = (Vector3)random.Direction();
        return ConvexShape.Mesh(points);
    }
}
