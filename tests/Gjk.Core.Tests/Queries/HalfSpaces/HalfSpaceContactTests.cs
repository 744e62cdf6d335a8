namespace Gjk.Core.Tests.Queries;

/// <summary>What stands on a half-space has the points that it has on a box that is large enough.</summary>
public class HalfSpaceContactTests
{
    private static readonly ConvexShape Floor = ConvexShape.HalfSpace(Vector3.UnitY, 0);
    private static readonly ConvexShape Block = ConvexShape.Box(new Vector3(8, 4, 8));
    private static readonly RigidPose UnderFloor = new(new Vector3(0, -4, 0));

    /// <summary>Kinds with so few corners that no four are chosen among many that are about as good.</summary>
    private static readonly string[] Plain =
        ["point", "segment", "triangle", "sphere", "capsule", "box", "scaledBox", "mirroredCapsule"];

    public static TheoryData<string> PlainKinds => [.. Plain];

    public static TheoryData<string> Kinds =>
        [.. Generators.PolytopeKinds, .. Generators.CurvedKinds, .. Generators.LaterKinds];

    [Fact]
    public void ABoxStandsOnItsFourCorners()
    {
        ContactManifold m = Ask(ConvexShape.Box(new Vector3(1, 2, 3)), new RigidPose(new Vector3(9, 2.125f, 0)), 0.25f);
        Assert.Equal((4, Vector3.UnitY), (m.Count, m.Normal));
        var ids = new HashSet<long>();
        for (int i = 0; i < m.Count; i++)
        {
            Assert.Equal(0.125f, m[i].Gap, 1e-6f);
            Assert.Equal((1f, 3f), (Math.Abs(m[i].PointA.X - 9), Math.Abs(m[i].PointA.Z)));
            Assert.Equal((0f, 0.125f), (m[i].PointA.Y, m[i].PointB.Y));
            Assert.Equal(m[i].PointA, m[i].LocalPointA);
            Assert.Equal(-2, m[i].LocalPointB.Y);
            Assert.Equal(0, m[i].FeatureId >> 32);
            Assert.True(ids.Add(m[i].FeatureId));
        }

        Assert.Equal(0, Ask(ConvexShape.Box(new(1)), new RigidPose(new Vector3(0, 1.5f, 0)), 0.25f).Count);
    }

    [Fact]
    public void EdgesRoundSidesAndBallsHaveTheirPoints()
    {
        var side = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        var edge = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 4);
        Assert.Equal(2, Ask(ConvexShape.Box(new(1)), new(edge, new(0, 1.4142135f, 0)), 0.01f).Count);
        Assert.Equal(2, Ask(ConvexShape.Cylinder(1, 2), new(side, new(0, 1, 0)), 0.01f).Count);
        Assert.Equal(4, Ask(ConvexShape.Cylinder(1, 2), new(new Vector3(0, 2, 0)), 0.01f).Count);
        Assert.Equal(2, Ask(ConvexShape.Capsule(1, 2), new(side, new(0, 1, 0)), 0.01f).Count);
        Assert.Equal(1, Ask(ConvexShape.Capsule(1, 2), new(new Vector3(0, 3, 0)), 0.01f).Count);
        Assert.Equal(1, Ask(ConvexShape.Sphere(1), new(new Vector3(0, 0.5f, 0)), 0.01f).Count);
        Assert.Equal(-0.5f, Ask(ConvexShape.Sphere(1), new(new Vector3(0, 0.5f, 0)), 0.01f)[0].Gap);
        Assert.Equal(4, Ask(ConvexShape.Box(new(1)).Rounded(0.5f), new(new Vector3(0, 1.5f, 0)), 0.01f).Count);
    }

    /// <summary>All of a feature's points are there that are within the gap, also of a tilted face.</summary>
    [Fact]
    public void ATiltedFaceKeepsWhatIsWithinTheGap()
    {
        var tilt = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, 0.1f);
        ConvexShape box = ConvexShape.Box(new Vector3(1));
        float lowest = MathF.Cos(0.1f) + MathF.Sin(0.1f);
        RigidPose at = new(tilt, new Vector3(0, lowest, 0));
        Assert.Equal(2, Ask(box, at, 0.19f).Count);
        Assert.Equal(4, Ask(box, at, 0.21f).Count);
    }

    [Theory]
    [MemberData(nameof(PlainKinds))]
    public void TheyAreThoseOnALargeBox(string kind)
    {
        for (ulong seed = 1; seed <= 150; seed++)
        {
            (ConvexShape shape, RigidPose pose) = Resting(new Rng(seed), kind);
            ContactManifold found = Ask(shape, pose, 0.05f);
            ConvexQuery.Contacts(Block, UnderFloor, shape, pose, 0.05f, out ContactManifold expected);
            string message = $"{kind}, seed {seed}: {found} for {expected}";
            Assert.True(found.Count == expected.Count, message);
            for (int i = 0; i < found.Count; i++)
            {
                Assert.True(found[i].FeatureId == expected[i].FeatureId, message);
                Assert.Equal(expected[i].Gap, found[i].Gap, 2e-5f);
                Assert.True((expected[i].PointB - found[i].PointB).Length() < 1e-4f, message);
            }
        }
    }

    /// <summary>Each point is on the plane and on the shape, and one of them is the deepest.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheyLieOnBothSurfaces(string kind)
    {
        for (ulong seed = 1; seed <= 150; seed++)
        {
            (ConvexShape shape, RigidPose pose) = Resting(new Rng(seed), kind);
            DistanceResult signed = ConvexQuery.Contacts(
                Floor, RigidPose.Identity, shape, pose, 0.05f, out ContactManifold found);
            string message = $"{kind}, seed {seed}: {found}";
            Assert.True(ResultBits.AreSame(
                signed, ConvexQuery.SignedDistance(Floor, RigidPose.Identity, shape, pose)), message);
            Assert.True(found.Count > 0, message);
            float least = float.PositiveInfinity;
            for (int i = 0; i < found.Count; i++)
            {
                ManifoldPoint p = found[i];
                least = Math.Min(least, p.Gap);
                Assert.Equal(0, p.PointA.Y, 1e-6f);
                Assert.Equal(p.Gap, p.PointB.Y, 1e-6f);
                Assert.InRange(p.Gap, signed.Distance, 0.05f);
                Assert.Equal(0, ConvexQuery.SignedDistance(shape, pose, p.PointB).Distance, 1e-5f);
                Assert.True((pose.TransformPoint(p.LocalPointB) - p.PointB).Length() < 4e-6f, message);
            }

            Assert.Equal(signed.Distance, least, 1e-5f);
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheExchangedPairHasTheExchangedPoints(string kind)
    {
        for (ulong seed = 1; seed <= 50; seed++)
        {
            (ConvexShape shape, RigidPose pose) = Resting(new Rng(seed), kind);
            ConvexQuery.Contacts(Floor, RigidPose.Identity, shape, pose, 0.05f, out ContactManifold one);
            ConvexQuery.Contacts(shape, pose, Floor, RigidPose.Identity, 0.05f, out ContactManifold other);
            other = other.Swapped;
            Assert.Equal((one.Count, one.Normal), (other.Count, other.Normal));
            for (int i = 0; i < one.Count; i++)
            {
                Assert.Equal(
                    (one[i].PointA, one[i].PointB, one[i].LocalPointA, one[i].LocalPointB, one[i].Gap),
                    (other[i].PointA, other[i].PointB, other[i].LocalPointA, other[i].LocalPointB, other[i].Gap));
                Assert.Equal(one[i].FeatureId, other[i].FeatureId);
            }
        }
    }

    /// <summary>A body on or near the floor, mostly a little turned.</summary>
    private static (ConvexShape Shape, RigidPose Pose) Resting(Rng rng, string kind)
    {
        ConvexShape shape = Generators.Shape(rng, kind).Shape;
        if (rng.Below(3) == 0) shape = shape.Placed(new RigidPose(rng.Rotation(), rng.Vector(-1, 1)));
        if (rng.Below(3) == 0) shape = shape.Rounded(rng.Float(0.01, 0.3));
        Quaternion turn = rng.Below(3) == 0 ? Quaternion.Identity
            : Quaternion.CreateFromAxisAngle(Vector3.Normalize(rng.Vector(-1, 1)), rng.LogFloat(1e-4, 3));
        var pose = new RigidPose(turn, rng.Vector(-2, 2));
        DistanceResult at = ConvexQuery.SignedDistance(Floor, RigidPose.Identity, shape, pose);
        Vector3 up = Vector3.UnitY * (rng.Float(-0.02, 0.03) - at.Distance);
        return (shape, new RigidPose(turn, pose.Position + up));
    }

    private static ContactManifold Ask(in ConvexShape shape, in RigidPose pose, float maxGap)
    {
        ConvexQuery.Contacts(Floor, RigidPose.Identity, shape, pose, maxGap, out ContactManifold manifold);
        return manifold;
    }
}
