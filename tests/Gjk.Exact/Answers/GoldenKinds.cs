namespace Gjk.Exact.Answers;

/// <summary>The golden queries of what <see cref="GoldenRun"/>'s pairs leave out: half-spaces, and the mass of each
/// kind.</summary>
internal static class GoldenKinds
{
    /// <summary>How many shapes are asked.</summary>
    private const int Count = 1000;

    /// <summary>Every verb for a half-space and every kind of shape, in both orders, and a solid on it.</summary>
    public static BitHash HalfSpaces()
    {
        var hash = new BitHash();
        for (int i = 0; i < Count; i++)
        {
            Rng random = Rng.ForPair(7, i);
            var normal = (Vector3)(random.Direction() * random.Range(0.1, 10));
            ConvexShape plane = Decorated(random, ConvexShape.HalfSpace(normal, random.Float(-1, 1)));
            ConvexShape other = AnyKind(random);
            RigidPose pose = Pose(random, 3), otherPose = Pose(random, random.Of(2.0, 10, 1000));
            AddPair(plane, pose, other, otherPose, random, ref hash);
            AddPair(other, otherPose, plane, pose, random, ref hash);
            GoldenRun.AddRay(ConvexShape.HalfSpace(Vector3.UnitY, 0), pose, random, ref hash);
            Vector3 origin = random.Vector(5), direction = (Vector3)random.Direction();
            hash.Add(ConvexQuery.RayCast(plane, pose, origin, direction));
            hash.Add(ConvexQuery.RayExit(plane, pose, origin, direction));
            hash.Add(ConvexQuery.SignedDistance(plane, pose, origin));
        }

        AddSolids(ref hash);
        return hash;
    }

    /// <summary>The mass of every kind, decorated and turned, of hulls and of solids. What has no closed form
    /// counts as refused.</summary>
    public static BitHash Masses()
    {
        var hash = new BitHash();
        for (int i = 0; i < Count; i++)
        {
            Rng random = Rng.ForPair(8, i);
            ConvexShape shape = AnyKind(random);
            float density = random.Float(0, 10);
            RigidPose pose = Pose(random, random.Of(1.0, 1000));
            try
            {
                MassProperties mass = shape.GetMassProperties(density);
                hash.Add(mass);
                hash.Add(mass + shape.Placed(pose).GetMassProperties(density));
                hash.Add(mass.At(pose));
            }
            catch (InvalidOperationException)
            {
                hash.Add(0);
            }

            hash.Add(Solid(random).GetMassProperties(density));
        }

        return hash;
    }

    private static void AddPair(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, Rng random, ref BitHash hash)
    {
        var manifold = default(ContactManifold);
        hash.Add(ConvexQuery.Distance(a, poseA, b, poseB));
        hash.Add(ConvexQuery.Distance(a, poseA, b, poseB, random.Float(0, 3)));
        hash.Add(ConvexQuery.Overlaps(a, poseA, b, poseB) ? 1 : 0);
        DistanceResult signed = ConvexQuery.SignedDistance(a, poseA, b, poseB);
        hash.Add(signed);
        hash.Add(ConvexQuery.Contacts(a, poseA, b, poseB, random.Float(0, 5), out manifold));
        hash.Add(manifold);
        var toward = (Vector3)((Double3)signed.Normal * (-signed.Distance * random.Range(-1, 3)) + random.Direction());
        hash.Add(ConvexQuery.Cast(a, poseA, random.Vector(1), b, poseB, toward));
        var motionA = new RigidMotion(poseA, default, random.Vector(1));
        var motionB = new RigidMotion(poseB, toward, random.Vector(3));
        hash.Add(ConvexQuery.TimeOfImpact(a, motionA, b, motionB));
    }

    private static void AddSolids(ref BitHash hash)
    {
        var scratch = new ConcaveScratch();
        var contacts = new List<PairContacts>();
        AnyShape floor = AnyShape.Of(ConvexShape.HalfSpace(Vector3.UnitY, 0.25f));
        for (int i = 0; i < Count / 10; i++)
        {
            Rng random = Rng.ForPair(9, i);
            AnyShape solid = AnyShape.Solid(Solid(random));
            RigidPose pose = Pose(random, 2), at = Pose(random, 2);
            PairDistance distance = ConcaveQuery.SignedDistance(solid, at, floor, pose, scratch);
            hash.Add(distance.Result);
            hash.Add(distance.PartA);
            ConcaveQuery.FindContacts(floor, pose, solid, at, 0.5f, scratch, contacts);
            foreach (PairContacts contact in contacts) hash.Add(contact.Manifold);
            hash.Add(ConcaveQuery.Cast(floor, pose, default, solid, at, random.Vector(4), scratch).Result);
        }
    }

    /// <summary>Any shape, tapered capsules too, which <see cref="RandomShape"/> leaves out.</summary>
    private static ConvexShape AnyKind(Rng random) => random.OneIn(10)
        ? Decorated(
            random,
            ConvexShape.TaperedCapsule(random.Float(0, 1), random.Float(0.1, 1), random.Float(0, 1)))
        : RandomShape.Make(random);

    private static ConvexShape Decorated(Rng random, ConvexShape shape)
    {
        if (random.OneIn(4)) shape = shape.Scaled(Factors(random));
        if (random.OneIn(4)) shape = shape.Rounded(random.Float(0.01, 0.2));
        return random.OneIn(4) ? shape.Placed(Pose(random, 2)) : shape;
    }

    /// <summary>A tetrahedron or an octahedron of any corners, turned outward or inward, scaled or not.</summary>
    private static TriangleMesh Solid(Rng random)
    {
        var corners = new Vector3[6];
        for (int i = 0; i < corners.Length; i++) corners[i] = random.Vector(2);
        int[] indices = random.OneIn(2)
            ? [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2]
            : [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 5, 2, 1, 5, 3, 2, 5, 4, 3, 5, 1, 4];
        var mesh = new TriangleMesh(corners, indices);
        return random.OneIn(2) ? mesh.Scaled(Factors(random)) : mesh;
    }

    private static Vector3 Factors(Rng random) =>
        new(random.Float(0.5, 2), random.Sign() * random.Float(0.5, 2), random.Float(0.5, 2));

    private static RigidPose Pose(Rng random, double far) => new(random.Rotation(), random.Vector(far));
}
