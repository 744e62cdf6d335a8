using Gjk.Exact.Cases;

namespace Gjk.Exact.Answers;

/// <summary>The queries whose bits are golden (contract 7), each hashed over every field of every result: the hard
/// pairs of tests/Cases, shapes of all kinds at random, and moving scenes. It uses no arithmetic whose rounding IEEE
/// 754 leaves open, so every runtime asks the same.</summary>
public sealed class GoldenRun
{
    /// <summary>How many pairs of random shapes are asked.</summary>
    private const int RandomPairs = 1500;

    /// <summary>How many rays are sent at each shape of the cases.</summary>
    private const int RaysPerShape = 3;

    /// <summary>How many shapes are in a batch, each of them with each.</summary>
    private const int BatchShapes = 100;

    private readonly CaseFile[] _pairs, _casts;

    /// <param name="folder">Where tests/Cases is.</param>
    public GoldenRun(string folder)
    {
        _pairs = [.. CaseFile.Distances.Concat(CaseFile.Depths).Select(name => CaseFile.Read(folder, name))];
        _casts = [.. CaseFile.Casts.Select(name => CaseFile.Read(folder, name))];
    }

    /// <summary>The families that were read.</summary>
    public IEnumerable<CaseFile> Families => _pairs.Concat(_casts);

    /// <summary>The pairs whose distances, depths and contacts are asked.</summary>
    public IEnumerable<CasePair> Pairs => _pairs.SelectMany(f => f.Pairs);

    /// <summary>What there are hashes of, and how each is made.</summary>
    public IReadOnlyList<(string Name, Func<BitHash> Hash)> Parts =>
    [
        ("distances", Distances), ("depths", Depths), ("contacts", Contacts), ("casts", Casts), ("impacts", Impacts),
        ("rays", Rays), ("shapes", Shapes), ("batches", Batches), ("scenes", SceneRun.Hash),
        ("half-spaces", GoldenKinds.HalfSpaces), ("masses", GoldenKinds.Masses),
    ];

    private BitHash Distances()
    {
        var hash = new BitHash();
        foreach (CasePair c in Pairs)
            hash.Add(ConvexQuery.Distance(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose));
        return hash;
    }

    private BitHash Depths()
    {
        var hash = new BitHash();
        foreach (CasePair c in Pairs)
            hash.Add(ConvexQuery.SignedDistance(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose));
        return hash;
    }

    private BitHash Contacts()
    {
        var hash = new BitHash();
        var manifold = default(ContactManifold);
        foreach (CasePair c in Pairs)
            AddContacts(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose, ref manifold, ref hash);
        return hash;
    }

    private BitHash Casts()
    {
        var hash = new BitHash();
        foreach (CasePair c in _casts.SelectMany(f => f.Pairs))
        {
            hash.Add(
                ConvexQuery.Cast(c.A.Shape, c.A.Pose, c.A.Velocity, c.B.Shape, c.B.Pose, c.B.Velocity, maxFraction: 2));
        }

        return hash;
    }

    /// <summary>The same motions with turns of up to a radian or so.</summary>
    private BitHash Impacts()
    {
        var hash = new BitHash();
        var random = new Rng(1);
        foreach (CasePair c in _casts.SelectMany(f => f.Pairs))
        {
            var motionA = new RigidMotion(c.A.Pose, c.A.Velocity, random.Vector(1));
            var motionB = new RigidMotion(c.B.Pose, c.B.Velocity, random.Vector(1));
            hash.Add(ConvexQuery.TimeOfImpact(c.A.Shape, motionA, c.B.Shape, motionB));
        }

        return hash;
    }

    /// <summary>Rays at points in and about every shape of the cases, from near and far, along axes too.</summary>
    private BitHash Rays()
    {
        var hash = new BitHash();
        var random = new Rng(2);
        foreach (PosedShape o in Families.SelectMany(f => f.Objects))
            for (int i = 0; i < RaysPerShape; i++) AddRay(o.Shape, o.Pose, random, ref hash);
        return hash;
    }

    /// <summary>Every question about pairs of every kind of shape, near each other.</summary>
    private static BitHash Shapes()
    {
        var hash = new BitHash();
        var manifold = default(ContactManifold);
        for (int i = 0; i < RandomPairs; i++)
        {
            Rng random = Rng.ForPair(3, i);
            ConvexShape a = RandomShape.Make(random), b = RandomShape.Make(random);
            var poseA = new RigidPose(random.Rotation(), random.Vector(10));
            double apart = (a.BoundingRadius + b.BoundingRadius) * random.Range(0.2, 1.2);
            Double3 between = random.Direction() * apart;
            var poseB = new RigidPose(random.Rotation(), (Vector3)(poseA.Position + between));
            DistanceResult distance = ConvexQuery.Distance(a, poseA, b, poseB);
            hash.Add(distance);
            hash.Add(distance.Swapped);
            hash.Add(ConvexQuery.Overlaps(a, poseA, b, poseB) ? 1 : 0);
            hash.Add(ConvexQuery.SignedDistance(a, poseA, b, poseB));
            AddContacts(a, poseA, b, poseB, ref manifold, ref hash);
            hash.Add(manifold.Swapped);
            var motion = (Vector3)(between * -random.Range(0, 3));
            CastResult cast = ConvexQuery.Cast(a, poseA, default, b, poseB, motion);
            hash.Add(cast);
            hash.Add(cast.Swapped);
            AddRay(a, poseA, random, ref hash);
        }

        return hash;
    }

    /// <summary>Where a build solves four pairs at once, and where none does.</summary>
    private static BitHash Batches()
    {
        var random = new Rng(6);
        var shapes = new ConvexShape[BatchShapes];
        var poses = new RigidPose[BatchShapes];
        for (int i = 0; i < BatchShapes; i++)
        {
            shapes[i] = RandomShape.Make(random);
            if (random.OneIn(4)) shapes[i] = shapes[i].Scaled(new Vector3((float)random.Of(1e-4, 1e4)));
            poses[i] = new RigidPose(random.Rotation(), random.Vector(2));
        }

        var pairs = new ObjectPair[BatchShapes * BatchShapes];
        for (int i = 0; i < pairs.Length; i++) pairs[i] = new ObjectPair(i / BatchShapes, i % BatchShapes);
        var results = new DistanceResult[pairs.Length];
        PairBatch.Distance(shapes, poses, pairs, results);
        var hash = new BitHash();
        foreach (DistanceResult result in results) hash.Add(result);
        return hash;
    }

    private static void AddContacts(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, ref ContactManifold manifold,
        ref BitHash hash)
    {
        float gap = 0.01f * (float)Math.Max(a.BoundingRadius, b.BoundingRadius);
        hash.Add(ConvexQuery.Contacts(a, poseA, b, poseB, gap, out manifold));
        hash.Add(manifold);
    }

    internal static void AddRay(in ConvexShape shape, in RigidPose pose, Rng random, ref BitHash hash)
    {
        double radius = shape.BoundingRadius > 0 ? shape.BoundingRadius : 1;
        Double3 target = pose.Position + random.Direction() * (radius * random.Unit());
        Double3 direction = random.OneIn(4) ? new Double3(0, random.Sign(), 0) : random.Direction();
        var origin = (Vector3)(target - direction * (radius * random.Of(0.5, 3.0, 1000.0)));
        hash.Add(ConvexQuery.RayCast(shape, pose, origin, (Vector3)direction));
    }
}
