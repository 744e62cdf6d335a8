namespace Gjk.Core.Tests.Contacts;

/// <summary>The contacts of (B, A) are those of (A, B), exchanged, to the last bit.</summary>
public class ExchangedContactTests
{
    private static readonly string[] Kinds =
        [.. Generators.AllKinds, .. Generators.LaterKinds, "bigHull", "made", "madeFarOff"];

    [Theory]
    [InlineData(0)]
    [InlineData(1e-3f)]
    [InlineData(0.3f)]
    public void EveryPairHasThoseOfTheExchangedOne(float maxGap)
    {
        int several = 0, count = Budget.Count(4000);
        for (int i = 0; i < count; i++)
        {
            TestPair p = i % 2 == 0
                ? Generators.Pair((ulong)i, Kinds, 0.8)
                : Generators.NearPair((ulong)i, Kinds, -Math.Pow(10, -i % 7));
            var rng = new Rng((ulong)i);
            ConvexShape a = Decorated(rng, p.A.Shape);
            ConvexShape b = i % 5 == 0 ? a : Decorated(rng, p.B.Shape);
            if (Check(a, p.PoseA, b, p.PoseB, maxGap, p.ToString()).Count > 1) several++;
        }

        Assert.InRange(several, count / 10, count);
    }

    /// <summary>What lies, stands and leans on each other, in rows and askew: where which four of many points stay, and
    /// which two edges cross, is a last bit.</summary>
    [Fact]
    public void FlatAndLeaningPairsHaveThoseOfTheExchangedOne()
    {
        int four = 0;
        for (int i = 0; i < 4000; i++)
        {
            var rng = new Rng((ulong)i);
            ConvexShape a = Standing(rng), b = rng.Below(3) == 0 ? a : Standing(rng);
            float tilt = rng.Below(2) * rng.LogFloat(1e-7, 1e-2);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Below(2) * rng.Float(0, 6));
            Quaternion lean = Quaternion.CreateFromAxisAngle(Vector3.Normalize(rng.Vector(-1, 1)), tilt);
            Quaternion turn = Quaternion.Normalize(lean * yaw);
            var at = new Vector3(rng.Float(-0.4, 0.4), 1, rng.Float(-0.4, 0.4)) * (1 - rng.Below(2) * 1e-3f);
            RigidPose ground = rng.Below(2) == 0 ? RigidPose.Identity : Generators.Pose(rng, rng.Vector(-9, 9));
            var pose = new RigidPose(
                Quaternion.Normalize(ground.Rotation * turn), ground.TransformPoint(at * (1 - rng.Below(3) * 0.01f)));
            if (Check(a, ground, b, pose, 0.02f, $"{i}").Count == 4) four++;
        }

        Assert.InRange(four, 1000, 4000);
    }

    /// <summary>Each order has a start of its own, which remembers vertices or, of curved shapes, a normal.</summary>
    [Fact]
    public void AKeptStartGivesThoseOfTheExchangedPair()
    {
        for (int i = 0; i < 300; i++)
        {
            TestPair p = Generators.NearPair((ulong)i, Kinds, -Math.Pow(10, -i % 4));
            var rng = new Rng((ulong)i);
            WarmStart warm = default, exchanged = default;
            RigidPose pose = p.PoseB;
            for (int frame = 0; frame < 10; frame++)
            {
                DistanceResult r = ConvexQuery.Contacts(
                    p.A.Shape, p.PoseA, p.B.Shape, pose, ref warm, 0.1f, out ContactManifold m);
                DistanceResult s = ConvexQuery.Contacts(
                    p.B.Shape, pose, p.A.Shape, p.PoseA, ref exchanged, 0.1f, out ContactManifold n);
                Assert.Equal(r, s.Swapped);
                AssertSame(m, n.Swapped, $"{p} in frame {frame}");
                Quaternion turn = Quaternion.CreateFromYawPitchRoll(0.01f, rng.Float(-0.01, 0.01), 0);
                pose = new RigidPose(
                    Quaternion.Normalize(turn * pose.Rotation), pose.Position + rng.Vector(-0.01, 0.01));
            }
        }
    }

    /// <summary>What contacts remember is as good a start for the distance as what a depth leaves, in either
    /// order.</summary>
    [Theory]
    [InlineData("cylinder")]
    [InlineData("ellipsoid")]
    [InlineData("bigHull")]
    public void AStartThatContactsKeptServesTheDistance(string kind)
    {
        int usual = 0, after = 0;
        for (int i = 0; i < 100; i++)
        {
            TestPair p = Generators.NearPair((ulong)i, [kind], 0.05);
            foreach (TestPair pair in new[] { p, p.Swapped })
            {
                WarmStart warm = default, own = default;
                ConvexQuery.Contacts(
                    pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref warm, 0.1f, out ContactManifold _);
                ConvexQuery.SignedDistance(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref own);
                after += ConvexQuery.Distance(
                    pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref warm).Iterations;
                usual += ConvexQuery.Distance(
                    pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref own).Iterations;
            }
        }

        Assert.InRange(after, 1, usual + usual / 20);
    }

    /// <summary>The types of their own have the bits of the one type, and the order too.</summary>
    [Fact]
    public void TypesOfTheirOwnHaveThoseOfTheExchangedPair()
    {
        for (int i = 0; i < 500; i++)
        {
            var rng = new Rng((ulong)i);
            var box = new BoxShape(rng.Vector(0.3, 1));
            var cylinder = new CylinderShape(rng.Float(0.3, 1), rng.Float(0.3, 1));
            RigidPose a = Generators.Pose(rng, default), b = Generators.Pose(rng, rng.Vector(-1, 1));
            Check(box, a, cylinder, b, 0.1f, $"{i}");
            Check(box, a, box, b, 0.1f, $"{i}");
            Check(cylinder, b, new Rounded<BoxShape>(box, 0.1f), a, 0.1f, $"{i}");
        }
    }

    [Fact]
    public void AHalfSpaceHasThoseOfTheExchangedPair()
    {
        for (int i = 0; i < 500; i++)
        {
            var rng = new Rng((ulong)i);
            ConvexShape body = Decorated(rng, Generators.Shape(rng, Kinds[rng.Below(Kinds.Length)]).Shape);
            ConvexShape ground = ConvexShape.HalfSpace(rng.Vector(-1, 1), rng.Float(-1, 1));
            Check(
                body, Generators.Pose(rng, rng.Vector(-1, 1)), ground, Generators.Pose(rng, rng.Vector(-1, 1)), 0.5f,
                $"{i}");
        }
    }

    private static ContactManifold Check<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxGap, string name)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        DistanceResult r = ConvexQuery.Contacts(a, poseA, b, poseB, maxGap, out ContactManifold m);
        DistanceResult s = ConvexQuery.Contacts(b, poseB, a, poseA, maxGap, out ContactManifold n);
        Assert.Equal(r, s.Swapped);
        AssertSame(m, n.Swapped, name);
        return m;
    }

    private static void AssertSame(in ContactManifold one, in ContactManifold other, string name)
    {
        Assert.True((one.Count, one.Normal) == (other.Count, other.Normal), $"{name}: {one}, {other}");
        for (int i = 0; i < one.Count; i++)
            Assert.True(one[i].Equals(other[i]), $"{name}, point {i}: {one[i]}, {other[i]}");
    }

    private static ConvexShape Decorated(Rng rng, ConvexShape shape)
    {
        if (rng.Below(4) == 0) shape = shape.Rounded(rng.Float(0.01, 0.2));
        return rng.Below(4) == 0 ? shape.Placed(Generators.Pose(rng, rng.Vector(-0.3, 0.3))) : shape;
    }

    /// <summary>Of height 1, more or less.</summary>
    private static ConvexShape Standing(Rng rng) => rng.Below(6) switch
    {
        0 => ConvexShape.Box(new Vector3(0.5f)),
        1 => ConvexShape.Box(new Vector3(rng.Float(0.2, 1), 0.5f, rng.Float(0.2, 1))),
        2 => ConvexShape.Cylinder(rng.Float(0.2, 1), 0.5f),
        3 => ConvexShape.Cone(rng.Float(0.2, 1), 0.5f),
        4 => ConvexShape.Cylinder(rng.Float(0.2, 0.9), 0.4f).Rounded(0.1f),
        _ => ConvexShape.Box(new Vector3(0.4f)).Rounded(0.1f),
    };
}
