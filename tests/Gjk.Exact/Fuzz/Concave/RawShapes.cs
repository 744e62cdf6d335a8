namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Random shapes of about unit size that are not convex, and convex ones to put beside them.</summary>
internal static class RawShapes
{
    public static RawShape Any(Rng random) => random.Below(8) switch
    {
        0 => Compound(random, 2 + random.Below(20)),
        1 => Convex(random),
        2 => random.OneIn(2) ? Terrain(random) : Heights(random),
        _ => Decorated(random, Surface(random)),
    };

    /// <summary>Never convex, and no compound.</summary>
    public static RawShape Surface(Rng random) => RawShape.Surface(random.Below(13) switch
    {
        0 => Bumpy(random),
        1 => Surfaces.Torus(Count(random), Count(random), 1, random.Range(0.1, 0.6)),
        2 => Rock(random),
        3 => Surfaces.Grid(1 + random.Below(6), (_, _) => random.Float(-0.2, 0.2)),
        4 => Surfaces.Washer(Count(random), 1 + random.Below(3), random.Range(0.01, 0.1)),
        5 => Surfaces.Comb(1 + random.Below(5), 0.5f),
        6 => Surfaces.Thread(Count(random), 4 + random.Below(8), 0),
        7 => Surfaces.Gear(3 + random.Below(8), random.Range(0.05, 0.4)),
        8 => Surfaces.Moebius(2 * Count(random), 1 + random.Below(3)),
        9 => Surfaces.Book(random, 2 + random.Below(8)),
        10 => Slivers(random),
        11 => Uneven(random),
        _ => Surfaces.Soup(random, 1 + random.Below(60), random.Magnitude(0.01, 1)),
    });

    /// <summary>Corners on a lattice, so that faces, edges and corners meet exactly.</summary>
    public static RawShape Lattice(Rng random)
    {
        const float Step = Clouds.LatticeStep;
        TriangleSoup lattice = random.Below(4) switch
        {
            0 => Surfaces.Box(new Vector3(1 + random.Below(3), 1 + random.Below(3), 1) * Step),
            1 => Surfaces.Grid(4, (_, _) => random.OneIn(3) ? Step : 0),
            2 => Surfaces.Comb(2, Step),
            _ => new TriangleSoup(
                [.. Enumerable.Range(0, 9).Select(_ => Clouds.LatticePoint(random, 3))],
                [.. Enumerable.Range(0, 30).Select(_ => random.Below(9))]),
        };
        return random.OneIn(2) ? RawShape.Surface(lattice).AsSolid() : RawShape.Surface(lattice);
    }

    public static RawShape Compound(Rng random, int parts)
    {
        double size = 0.5 / Math.Cbrt(parts);
        return RawShape.Compound(
        [
            .. Enumerable.Range(0, parts).Select(
                _ => Part(random, size) with { Pose = new RigidPose(Rotations.Any(random), random.Vector(1)) }),
        ]);
    }

    public static RawShape Convex(Rng random)
    {
        RawShape shape = RawShape.Convex(Part(random, random.Magnitude(0.05, 1)));
        return random.OneIn(4) ? shape.Scaled(random.Factors(0.3, 3)) : shape;
    }

    /// <summary>Rows and columns of heights.</summary>
    public static RawShape Terrain(Rng random)
    {
        int columns = 2 + random.Below(7), rows = 2 + random.Below(7);
        float rough = random.OneIn(4) ? 0 : random.Float(0, 0.3);
        return RawShape.Heights(new RawField(
            [.. Enumerable.Range(0, rows * columns).Select(_ => random.Float(-rough, rough))], columns,
            new Vector2(random.OneIn(2) ? 0.25f : random.Float(0.1, 0.3))));
    }

    /// <summary>The same with holes, a base and z up, each in part of them.</summary>
    public static RawShape Heights(Rng random)
    {
        int columns = 2 + random.Below(5), rows = 2 + random.Below(5), oneIn = random.Of(2, 5, int.MaxValue);
        float rough = random.OneIn(3) ? 0 : random.Float(0, 0.3);
        bool[] isHole = [.. Enumerable.Range(0, (columns - 1) * (rows - 1)).Select(_ => random.OneIn(oneIn))];
        isHole[random.Below(isHole.Length)] = false;
        RawShape shape = RawShape.Heights(new RawField(
            [.. Enumerable.Range(0, rows * columns).Select(_ => random.OneIn(3) ? 0 : random.Float(-rough, rough))],
            columns, random.OneIn(2) ? new Vector2(0.25f) : new Vector2(random.Float(0.1, 0.3), random.Float(0.1, 0.3)),
            isHole, random.OneIn(2), random.OneIn(3) ? null : -random.Float(0.31, 0.6)));
        return Decorated(random, shape);
    }

    /// <summary>A solid where it can be one, scaled, or both, or as it is.</summary>
    public static RawShape Decorated(Rng random, RawShape shape)
    {
        if (random.OneIn(2)) shape = shape.AsSolid();
        return random.OneIn(5) ? shape.Scaled(random.Factors(0.3, 3)) : shape;
    }

    private static TriangleSoup Bumpy(Rng random)
    {
        double bumps = 1 + random.Below(5), high = random.Range(0.02, 0.3);
        return Surfaces.Ball(
            Count(random), Count(random), (a, b) => 1 + high * Math.Sin(bumps * a) * Math.Sin((bumps + 1) * b));
    }

    private static TriangleSoup Rock(Rng random) =>
        Surfaces.Ball(Count(random), Count(random), (_, _) => random.Range(0.6, 1));

    /// <summary>A million times as long as wide.</summary>
    private static TriangleSoup Slivers(Rng random)
    {
        float thin = (float)random.Magnitude(1e-6, 1e-3);
        Vector3 flat = random.OneIn(2) ? new Vector3(1, thin, 1) : new Vector3(1, thin, thin);
        TriangleSoup soup = random.OneIn(2)
            ? Surfaces.Torus(Count(random), Count(random))
            : Surfaces.Soup(random, 1 + random.Below(30), 1);
        return soup.Moved(p => p * flat);
    }

    /// <summary>One triangle that is far larger than the others.</summary>
    private static TriangleSoup Uneven(Rng random)
    {
        float size = (float)random.Magnitude(10, 1e6);
        return Surfaces.Soup(random, 1 + random.Below(40), random.Magnitude(0.01, 0.3)).And(
            new TriangleSoup([random.Vector(size), random.Vector(size), random.Vector(size)], [0, 1, 2]));
    }

    private static RawPart Part(Rng random, double size)
    {
        float s = random.Float(0.3, 1) * (float)size, t = random.Float(0.3, 1) * (float)size;
        return random.Below(9) switch
        {
            0 => new(ShapeKind.Sphere, new Vector3(s)),
            1 => new(ShapeKind.Capsule, new Vector3(s, t, 0)),
            2 => new(ShapeKind.Cylinder, new Vector3(s, t, 0)),
            3 => new(ShapeKind.Cone, new Vector3(s, t, 0)),
            4 => new(ShapeKind.Ellipsoid, new Vector3(s, t, s)),
            5 => new(ShapeKind.Triangle, random.Vector(s), random.Vector(s), random.Vector(s)),
            6 => new(ShapeKind.Point, Vector3.Zero),
            7 => new(ShapeKind.Mesh, Clouds.InBox(random, 4 + random.Below(9), new Vector3(s))),
            _ => new(ShapeKind.Box, new Vector3(s, t, random.Float(0.3, 1) * (float)size)),
        };
    }

    private static int Count(Rng random) => 3 + random.Below(7);
}
