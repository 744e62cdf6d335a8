namespace Gjk.Exact.Fuzz.Families;

/// <summary>Pairs whose difficulty is where they touch, or nearly do.</summary>
internal static class ContactFamilies
{
    /// <summary>Cubes and grid polytopes that meet in faces, edges and corners.</summary>
    public static FuzzPair Lattice(Rng random)
    {
        FuzzShape a = OnLattice(random), b = OnLattice(random);
        Quaternion q = random.OneIn(2) ? Quaternion.Identity : Rotations.Any(random);
        Vector3 position = random.OneIn(2) ? Vector3.Zero : Clouds.LatticePoint(random, 8);
        return new FuzzPair(
            a, new RigidPose(q, position), b, new RigidPose(q, position + Clouds.LatticePoint(random, 8)));
    }

    /// <summary>Boxes and prisms, face against face, whole or in part, a gap apart.</summary>
    public static FuzzPair ParallelFaces(Rng random)
    {
        FuzzShape a = WithFaces(random), b = WithFaces(random);
        Quaternion q = Rotations.Any(random), turnB = q;
        if (random.OneIn(3))
            turnB = Rotations.Times(q, new Quaternion(0, (float)Math.Sqrt(0.5), 0, (float)Math.Sqrt(0.5)));
        var poseA = new RigidPose(q, random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        var bodyA = new PosedShape(a, poseA);
        Double3 up = bodyA.Rotate(new Double3(0, random.Sign(), 0));
        FuzzPair stacked = Placement.Gap(a, poseA, b, turnB, up, Placement.AnyGap(random));
        Double3 aside = bodyA.Rotate(
            new Double3(random.Of(0, 0.5, random.Range(-2, 2)), 0, random.Of(0, 0.5, random.Range(-2, 2))));
        return stacked.At(poseA, new RigidPose(stacked.PoseB.Rotation, (Vector3)(stacked.PoseB.Position + aside)));
    }

    /// <summary>Any shapes, a gap apart along any direction, or along one across a face.</summary>
    public static FuzzPair Touching(Rng random) =>
        Placement.Touching(random, Shapes.Any(random), Shapes.Any(random));

    /// <summary>A lies below the plane x = 0 and B above it, both in one rotation, and B's position is the gap itself:
    /// so gaps down to 1e-15 are exactly what floats can hold nowhere else.</summary>
    public static FuzzPair AtTheOrigin(Rng random)
    {
        FuzzShape a = Below(random, -1), b = Below(random, 1);
        Quaternion q = random.OneIn(2) ? Quaternion.Identity : Rotations.Any(random);
        var body = new PosedShape(a, new RigidPose(q, Vector3.Zero));
        Double3 direction = random.OneIn(2) ? new Double3(1, 0, 0) : random.Direction();
        Double3 gap = body.Rotate(direction) * Placement.AnyGap(random);
        Quaternion turnB = random.Below(4) switch
        {
            0 => Rotations.Nudged(random, q),
            1 => Rotations.Drifted(random, q),
            _ => q,
        };
        return new FuzzPair(a, new RigidPose(q, Vector3.Zero), b, new RigidPose(turnB, (Vector3)gap));
    }

    /// <summary>A shape against itself, moved and turned by next to nothing.</summary>
    public static FuzzPair NearlyTheSame(Rng random)
    {
        FuzzShape shape = random.OneIn(4) ? Shapes.Made(random) : Shapes.Any(random);
        Quaternion q = Rotations.Any(random), turned = random.OneIn(2) ? q : Rotations.Nudged(random, q);
        Vector3 position = random.OneIn(2) ? Vector3.Zero : random.Vector(1);
        Vector3 moved = position + (Vector3)(random.Direction() * (random.OneIn(3) ? 0 : random.Magnitude(1e-15, 2)));
        return new FuzzPair(shape, new RigidPose(q, position), shape, new RigidPose(turned, moved));
    }

    /// <summary>Centres on each other, or nearly.</summary>
    public static FuzzPair Concentric(Rng random)
    {
        Double3 centers = random.Direction() * (random.OneIn(2) ? 0 : random.Magnitude(1e-15, 1e-3));
        return Placement.Between(
            Shapes.Any(random), new RigidPose(Rotations.Any(random), Vector3.Zero), Shapes.Any(random),
            Rotations.Any(random), centers);
    }

    private static FuzzShape OnLattice(Rng random) =>
        random.OneIn(3) ? FuzzShape.Mesh(Clouds.Lattice(random)) : Shapes.LatticeCube(random);

    private static FuzzShape WithFaces(Rng random) => random.Below(4) switch
    {
        0 => ConvexShape.Box(Vector3.Abs(random.Vector(1))),
        1 => Shapes.LatticeCube(random),
        2 => ConvexShape.Cylinder(random.Float(0.1, 1), random.Float(0.1, 1)),
        _ => FuzzShape.Mesh(Clouds.Prism(random)),
    };

    /// <summary>A cloud on one side of x = 0 that reaches it with one to four of its points.</summary>
    private static FuzzShape Below(Rng random, int side)
    {
        Vector3[] cloud = random.Below(3) switch
        {
            0 => Clouds.Lattice(random),
            1 => Clouds.Flat(random),
            _ => Clouds.InBox(random, 4 + random.Below(9), Vector3.One),
        };
        int contacts = 1 + random.Below(Math.Min(4, cloud.Length));
        bool atOrigin = random.OneIn(3);
        for (int i = 0; i < cloud.Length; i++)
        {
            cloud[i].X = i < contacts ? 0 : side * Math.Abs(cloud[i].X);
            if (i == 0 && atOrigin) cloud[i] = Vector3.Zero;
        }

        return FuzzShape.Mesh(cloud);
    }
}
