using Gjk.Exact.Fuzz.Families;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Pairs of which one is not convex at least, each kind hard in its own way.</summary>
internal static class ConcaveFamilies
{
    /// <summary>More pairs of parts than these are tried with fewer parts.</summary>
    private const int MostPairs = 20_000;

    /// <summary>The largest motion, in world units: positions stay within floats.</summary>
    private const double Largest = 1e35;

    private static readonly (string Name, int Weight, Func<Rng, ConcavePair> Make)[] s_all =
    [
        ("surfaces", 8, r => Beside(r, RawShapes.Surface(r), RawShapes.Any(r))),
        ("terrain", 4, r => Beside(r, RawShapes.Terrain(r), RawShapes.Any(r))),
        ("heights", 4, r => Beside(r, RawShapes.Heights(r), RawShapes.Any(r))),
        ("convex by surfaces", 6, r => Beside(r, RawShapes.Convex(r), RawShapes.Surface(r))),
        ("solids", 6, r => Beside(r, RawShapes.Surface(r).AsSolid(), RawShapes.Any(r))),
        ("in solids", 4, InSolid),
        ("compounds", 4, r => Beside(r, RawShapes.Compound(r, 2 + r.Below(40)), RawShapes.Any(r))),
        ("many parts", 1, r => Beside(r, RawShapes.Compound(r, (int)r.Magnitude(100, 1001)), RawShapes.Convex(r))),
        ("on a lattice", 6, OnLattice),
        ("plates", 4, Plates),
        ("with itself", 4, WithItself),
        ("interlocked", 4, Interlocked),
        ("the whole range", 4, WholeRange),
        ("ratios", 3, Ratios),
        ("far away", 4, FarAway),
    ];

    private static readonly int s_weights = s_all.Sum(f => f.Weight);

    public static IReadOnlyList<string> Names { get; } = [.. s_all.Select(f => f.Name)];

    /// <summary>The pair of a seed and a number, with its family's name.</summary>
    public static ConcavePair Draw(ulong seed, long index, out string family)
    {
        Rng random = Rng.ForPair(seed ^ 0x434F4E43415645, index);
        int left = random.Below(s_weights), i = 0;
        while (left >= s_all[i].Weight) left -= s_all[i++].Weight;
        family = s_all[i].Name;
        return s_all[i].Make(random);
    }

    /// <summary>In any pose near each other, some of them brought together until they nearly touch.</summary>
    private static ConcavePair Beside(Rng random, RawShape a, RawShape b)
    {
        if (random.OneIn(2)) (a, b) = (b, a);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        Vector3 apart = (Vector3)(random.Direction() * random.Range(0, 2.5));
        return Placed(random, a, poseA, b, new RigidPose(Rotations.Any(random), poseA.Position + apart), 1);
    }

    private static ConcavePair InSolid(Rng random)
    {
        RawShape outer = RawShapes.Surface(random).AsSolid();
        float factor = random.Float(0.01, 0.2);
        RawShape inner = RawShapes.Any(random).Larger(factor);
        return Placed(
            random, outer, RigidPose.Identity, inner,
            new RigidPose(Rotations.Any(random), random.Vector(0.7)), 1, mayMeet: false);
    }

    private static ConcavePair OnLattice(Rng random)
    {
        RawShape a = RawShapes.Lattice(random);
        RawShape b = random.OneIn(3)
            ? RawShape.Convex(new RawPart(ShapeKind.Box, new Vector3(Clouds.LatticeStep)))
            : RawShapes.Lattice(random);
        var turn = random.OneIn(2) ? Quaternion.Identity : new Quaternion(0, 1, 0, 0);
        return Placed(
            random, a, RigidPose.Identity, b, new RigidPose(turn, Clouds.LatticePoint(random, 6)), 1, mayMeet: false);
    }

    /// <summary>Flush, or a little apart, turned alike.</summary>
    private static ConcavePair Plates(Rng random)
    {
        RawShape plate = RawShape.Surface(Surfaces.Grid(1 + random.Below(7)));
        RawShape other = random.OneIn(3) ? RawShapes.Terrain(random) : plate;
        Quaternion turn = random.OneIn(2) ? Quaternion.Identity : random.Rotation();
        var pose = new RigidPose(turn, random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        float gap = random.OneIn(3) ? 0 : random.Sign() * (float)random.Magnitude(1e-8, 1e-2);
        Vector3 local = new(random.Float(-0.5, 0.5), gap, random.Float(-0.5, 0.5));
        return Placed(
            random, plate, pose, other, new RigidPose(turn, pose.TransformPoint(local)), 1, mayMeet: false);
    }

    private static ConcavePair WithItself(Rng random)
    {
        RawShape shape = RawShapes.Decorated(random, RawShapes.Surface(random));
        Quaternion turn = Rotations.Any(random);
        Vector3 shift = random.OneIn(4) ? Vector3.Zero : (Vector3)(random.Direction() * random.Magnitude(1e-9, 1e-3));
        Quaternion other = random.OneIn(2) ? turn : Rotations.Nudged(random, turn);
        return Placed(
            random, shape, new RigidPose(turn, Vector3.Zero), shape, new RigidPose(other, shift), 1, mayMeet: false);
    }

    /// <summary>Screw in nut, links of a chain, teeth in teeth.</summary>
    private static ConcavePair Interlocked(Rng random)
    {
        int around = 4 + random.Below(8), along = 4 + random.Below(8);
        float small = random.OneIn(3) ? 0 : (float)random.Magnitude(1e-6, 0.05);
        TriangleSoup ring = Surfaces.Torus(around, along, 1, random.Range(0.1, 0.3));
        TriangleSoup comb = Surfaces.Comb(1 + random.Below(5), 0.25f), gear = Surfaces.Gear(around, 0.2);
        var crossed = new Quaternion(MathF.Sqrt(0.5f), 0, 0, MathF.Sqrt(0.5f));
        (TriangleSoup a, TriangleSoup b, RigidPose pose) = random.Below(4) switch
        {
            0 => (Surfaces.Thread(around, along, 0), Surfaces.Thread(around, along, small),
                new RigidPose(new Vector3(0, small, 0))),
            1 => (ring, ring, new RigidPose(crossed, new Vector3(1 + small, 0, 0))),
            2 => (comb, comb.Moved(p => p with { Y = -p.Y }), new RigidPose(new Vector3(small, 0.3f, 0))),
            _ => (gear, gear, new RigidPose(new Vector3(1.9f + small, 0, 0))),
        };
        return Placed(
            random, RawShape.Surface(a), RigidPose.Identity, RawShape.Surface(b), pose, 1,
            mayMeet: random.OneIn(3));
    }

    private static ConcavePair WholeRange(Rng random)
    {
        double size = random.Magnitude(1e-30, 1e30);
        RawShape a = RawShapes.Any(random).Larger((float)size), b = RawShapes.Surface(random).Larger((float)size);
        var pose = new RigidPose(Rotations.Any(random), (Vector3)(random.Direction() * (random.Range(0, 2) * size)));
        return Placed(random, a, new RigidPose(Rotations.Any(random), Vector3.Zero), b, pose, size);
    }

    private static ConcavePair Ratios(Rng random)
    {
        double size = random.Magnitude(1e-9, 1e-2);
        RawShape small = RawShapes.Any(random).Larger((float)size), large = RawShapes.Surface(random);
        if (random.OneIn(2)) (small, large) = (large, small);
        return Placed(
            random, large, new RigidPose(Rotations.Any(random), Vector3.Zero), small,
            new RigidPose(Rotations.Any(random), random.Vector(1)), 1);
    }

    /// <summary>A hundred kilometres away, where a float position has steps of a centimetre.</summary>
    private static ConcavePair FarAway(Rng random)
    {
        Vector3 away = (Vector3)(random.Direction() * 1e5);
        RawShape a = RawShapes.Surface(random), b = RawShapes.Any(random);
        if (random.OneIn(3)) a = a.Moved(p => p + away);
        Vector3 there = a.Triangles!.Points[0].LengthSquared() > 1e8f ? Vector3.Zero : away;
        var poseB = new RigidPose(Rotations.Any(random), away + random.Vector(1.5));
        return Placed(random, a, new RigidPose(there), b, poseB, 1, mayMeet: random.OneIn(2));
    }

    private static ConcavePair Placed(
        Rng random, RawShape a, RigidPose poseA, RawShape b, RigidPose poseB, double size, bool mayMeet = true)
    {
        while (a.PartCount * b.PartCount > MostPairs)
        {
            if (a.PartCount > b.PartCount) a = a.Without(0, a.PartCount / 2);
            else b = b.Without(0, b.PartCount / 2);
        }

        var pair = new ConcavePair(a, poseA, b, poseB, default, random.Next());
        DistanceResult r = pair.Answer.Result;
        if (mayMeet && r.Distance > 0 && float.IsFinite(r.Distance) && random.OneIn(2))
        {
            double way = r.Distance - Placement.AnyGap(random) * size;
            poseB = new RigidPose(poseB.Rotation, poseB.Position - (Vector3)((Double3)r.Normal * way));
        }

        Double3 between = (Double3)poseA.Position - poseB.Position, aside = random.Direction() * size;
        Double3 relative = random.Below(4) switch
        {
            0 => (Double3)r.Normal * (-random.Range(0.5, 2) * Math.Max(r.Distance, 0.1 * size)),
            1 => aside * random.Magnitude(1e-6, 3),
            _ => (between + aside * 0.5) * random.Range(0.3, 2),
        };
        if (!(relative.Length < Largest)) relative = default;
        Vector3 shared = random.OneIn(3) ? (Vector3)(random.Direction() * size) : Vector3.Zero;
        return pair.At(poseA, poseB, new PairMotion(shared, shared + (Vector3)relative));
    }
}
