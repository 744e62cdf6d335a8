namespace Gjk.Exact.Fuzz.Families;

/// <summary>Random shapes of about unit size.</summary>
internal static class Shapes
{
    public static FuzzShape Any(Rng random) => random.Below(4) switch
    {
        0 => Curved(random),
        1 => Primitive(random),
        2 => Polytope(random),
        _ => Scaled(random),
    };

    /// <summary>A mesh as people and programs make it.</summary>
    public static FuzzShape Made(Rng random) => FuzzShape.Mesh(MadeMeshes.Any(random));

    /// <summary>What the exact solver can judge.</summary>
    public static FuzzShape Polytope(Rng random) => random.Below(12) switch
    {
        0 => Primitive(random),
        1 => FuzzShape.Mesh(Clouds.Prism(random)),
        2 => FuzzShape.Mesh(Clouds.Lattice(random)),
        3 => Degenerate(random),
        4 => Needle(random),
        5 => FuzzShape.Mesh(Clouds.Repeated(random, Clouds.InBox(random, 4 + random.Below(6), Vector3.One))),
        6 => FuzzShape.Mesh(Clouds.OnSphere(random, 4 + random.Below(60))),
        7 => ConvexShape.Box(Vector3.Abs(random.Vector(1))),
        8 => LatticeCube(random),
        _ => FuzzShape.Mesh(Clouds.InBox(random, 4 + random.Below(13), Vector3.One)),
    };

    /// <summary>With vertices, and with or without a margin.</summary>
    public static FuzzShape Primitive(Rng random) => random.Below(7) switch
    {
        0 => ConvexShape.Point(),
        1 => ConvexShape.Segment(random.Vector(1), random.Vector(1)),
        2 => ConvexShape.Triangle(random.Vector(1), random.Vector(1), random.Vector(1)),
        3 => ConvexShape.Sphere(random.Float(0, 1)),
        4 => ConvexShape.Capsule(random.Float(0, 0.5), random.Float(0, 1)),
        5 => ConvexShape.Capsule((float)random.Magnitude(1e-6, 1), (float)random.Magnitude(1e-6, 1)),
        _ => ConvexShape.Box(Vector3.Abs(random.Vector(1))),
    };

    /// <summary>With a margin that is a float, or a product of floats.</summary>
    public static FuzzShape Round(Rng random)
    {
        ConvexShape round = random.OneIn(2)
            ? ConvexShape.Sphere(random.Float(0, 1))
            : ConvexShape.Capsule(random.Float(0, 0.5), random.Float(0, 1));
        return random.OneIn(2) ? round : round.Scaled(new Vector3(random.Sign() * random.Float(0.1, 3)));
    }

    public static FuzzShape Curved(Rng random) => random.Below(6) switch
    {
        0 => ConvexShape.Cylinder(random.Float(0, 1), random.Float(0, 1)),
        1 => ConvexShape.Cone(random.Float(0, 1), random.Float(0, 1)),
        2 => ConvexShape.Ellipsoid(Vector3.Abs(random.Vector(1))),
        3 => ConvexShape.Capsule(random.Float(0.1, 0.5), random.Float(0.1, 1)).Scaled(random.Factors(0.2, 2)),
        4 => ConvexShape.Sphere(random.Float(0.1, 1)).Scaled(random.Factors(0.2, 2)),
        _ => ConvexShape.Cone(random.Float(0.1, 1), random.Float(0.1, 1)).Scaled(random.Factors(0.2, 2)),
    };

    /// <summary>With unequal balls, and now and then with equal ones, or one that the other holds.</summary>
    public static FuzzShape Tapered(Rng random)
    {
        float top = random.Float(0, 0.7), bottom = random.OneIn(6) ? top : random.Float(0, 0.7);
        float half = random.OneIn(3) ? MathF.Abs(top - bottom) / 2 : random.Float(0, 1);
        ConvexShape tapered = ConvexShape.TaperedCapsule(top, bottom, half);
        return random.OneIn(3) ? tapered.Scaled(random.Factors(0.2, 2)) : tapered;
    }

    /// <summary>Of about a size, without a scale.</summary>
    public static FuzzShape Curved(Rng random, float size) => random.Below(3) switch
    {
        0 => ConvexShape.Cylinder(random.Float(0.1, 1) * size, random.Float(0.1, 1) * size),
        1 => ConvexShape.Cone(random.Float(0.1, 1) * size, random.Float(0.1, 1) * size),
        _ => ConvexShape.Ellipsoid(Vector3.Abs(random.Vector(1)) * size),
    };

    /// <summary>Scaled unevenly or evenly, mirrored or not.</summary>
    public static FuzzShape Scaled(Rng random)
    {
        Vector3 factors = random.OneIn(2)
            ? random.Factors(0.1, 10)
            : new Vector3(random.Sign() * (float)random.Magnitude(0.1, 10));
        return random.Below(4) switch
        {
            0 => ConvexShape.Box(Vector3.Abs(random.Vector(1))).Scaled(factors),
            1 => Primitive(random).Scaled(factors),
            2 => FuzzShape.Mesh(Clouds.Lattice(random)).Scaled(factors),
            _ => FuzzShape.Mesh(Clouds.InBox(random, 4 + random.Below(13), Vector3.One)).Scaled(factors),
        };
    }

    /// <summary>Flat, straight, or a single point.</summary>
    public static FuzzShape Degenerate(Rng random) => random.Below(5) switch
    {
        0 => FuzzShape.Mesh(Clouds.Flat(random)),
        1 => FuzzShape.Mesh(Clouds.Straight(random)),
        2 => FuzzShape.Mesh(Clouds.Repeated(random, [random.Vector(1)])),
        3 => ConvexShape.Box(Vector3.Abs(random.Vector(1)) * new Vector3(random.Below(2), random.Below(2), 1)),
        _ => ConvexShape.Triangle(random.Vector(1), Vector3.Zero, random.Vector(1) * random.Below(2)),
    };

    /// <summary>Long and thin, or wide and thin, 1:1000 up to 1:1000000.</summary>
    public static FuzzShape Needle(Rng random)
    {
        float thin = (float)random.Magnitude(1e-6, 1e-3);
        Vector3 size = random.OneIn(2) ? new Vector3(1, thin, thin) : new Vector3(1, thin, 1);
        return random.Below(4) switch
        {
            0 => ConvexShape.Box(size),
            1 => ConvexShape.Capsule(thin, 1),
            _ => FuzzShape.Mesh(Clouds.InBox(random, 4 + random.Below(9), size)),
        };
    }

    public static FuzzShape LatticeCube(Rng random)
    {
        float half = Clouds.LatticeStep * (1 + random.Below(6));
        return random.OneIn(2) ? ConvexShape.Box(new Vector3(half)) : FuzzShape.Mesh(Clouds.Box(new Vector3(half)));
    }
}
