namespace Gjk.Core.Tests.Concave;

/// <summary>The contacts of (B, A) are those of (A, B), exchanged, to the last bit, of shapes of every kind.</summary>
public class ExchangedPairTests
{
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [], _exchanged = [];

    [Fact]
    public void EveryPairHasThoseOfTheExchangedOne()
    {
        int touching = 0, several = 0, count = Budget.Count(1200);
        for (int i = 0; i < count; i++)
        {
            Rng random = Rng.ForPair(47, i);
            AnyShape a = Any(random), b = random.OneIn(6) ? a : Any(random);
            var poseA = new RigidPose(
                random.OneIn(2) ? Quaternion.Identity : random.Rotation(),
                random.OneIn(2) ? default : random.Vector(5));
            var turn = random.OneIn(2)
                ? Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6)) : random.Rotation();
            var poseB = new RigidPose(
                Quaternion.Normalize(poseA.Rotation * turn), poseA.TransformPoint(random.Vector(1.5)));
            PairDistance apart = ConcaveQuery.Distance(a, poseA, b, poseB, _scratch);
            if (apart.Distance > 0 && float.IsFinite(apart.Distance))
            {
                float gap = random.Of(0, 1e-2f, -1e-4f, -1e-2f, -0.1f);
                poseB = new RigidPose(
                    poseB.Rotation, poseB.Position - (apart.Distance - gap) * apart.Result.Normal);
            }

            bool isValid = ConcaveQuery.FindContacts(a, poseA, b, poseB, 0.02f, _scratch, _contacts);
            Assert.Equal(isValid, ConcaveQuery.FindContacts(b, poseB, a, poseA, 0.02f, _scratch, _exchanged));
            Compare($"{i}: {a}, {b}");
            if (_contacts.Count > 0) touching++;
            if (_contacts.Count > 1) several++;
        }

        Assert.InRange(touching, count / 2, count);
        Assert.InRange(several, count / 4, count);
    }

    /// <summary>What stands on flat floors, deep in some: where seams are left out, and stand-ins found.</summary>
    [Theory]
    [InlineData("doubled")]
    [InlineData("slivers of 1e-6")]
    [InlineData("filled T-junctions")]
    public void BodiesOnFloorsHaveThoseOfTheExchangedPair(string name)
    {
        AnyShape floor = Floors.Named(name);
        for (int i = 0; i < 60; i++)
        {
            Rng random = Rng.ForPair(48, i);
            AnyShape body = SeamBodies.Named(random.Of("ball", "box", "capsule", "hull"));
            var over = new Vector3(random.Float(0.5, 2.5), 0, random.Float(0.5, 2.5));
            RigidPose at = SeamBodies.Placed(
                body, over, SeamBodies.Tilt(random, random.Of(0, 0.01, 1)), random.Of(0.01f, -1e-3f, -0.1f));
            ConcaveQuery.FindContacts(floor, RigidPose.Identity, body, at, 0.02f, _scratch, _contacts);
            ConcaveQuery.FindContacts(body, at, floor, RigidPose.Identity, 0.02f, _scratch, _exchanged);
            Compare($"{name} {i}: {body}");
        }
    }

    private void Compare(string name)
    {
        Assert.True(_contacts.Count == _exchanged.Count, $"{name}: {_contacts.Count} and {_exchanged.Count}");
        for (int i = 1; i < _exchanged.Count; i++) Assert.True(_exchanged[i - 1].CompareTo(_exchanged[i]) < 0, name);
        foreach (PairContacts one in _contacts)
        {
            PairContacts other = _exchanged.Single(e => (e.PartB, e.PartA) == (one.PartA, one.PartB));
            Assert.Equal(one.Result, other.Result.Swapped);
            ContactManifold m = one.Manifold, n = other.Manifold.Swapped;
            Assert.True((m.Count, m.Normal) == (n.Count, n.Normal), $"{name}: {one}, {other}");
            for (int i = 0; i < m.Count; i++) Assert.True(m[i].Equals(n[i]), $"{name}, point {i}: {one}, {other}");
        }
    }

    private static AnyShape Any(Rng random) => random.Below(10) switch
    {
        0 => AnyShape.Of(Generators.Shape(new Rng(random.Next()), random.Of(Generators.AllKinds)).Shape),
        1 => SeamBodies.Named(random.Of("ball", "box", "capsule", "hull")),
        2 => AnyShape.Of(ConvexShape.Cylinder(0.4f, 0.3f)),
        3 => AnyShape.Surface(SeamBodies.Plate(4, random.Below(4), (_, _) => 0)),
        4 => AnyShape.Surface(SeamBodies.Plate(4, random.Below(4), (_, _) => random.Float(-0.3f, 0.3f))),
        5 => AnyShape.Solid(Solids.Named(random.Of("gear", "ring", "rock"), random.Below(9))),
        6 => AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.5f, 0.3f, 0.4f))),
        7 => AnyShape.Of(ConcaveShapes.Compound(random, 4)),
        8 => AnyShape.Of(
            new CompoundShape(
            [
                new CompoundPart(ConvexShape.Box(new Vector3(0.5f)), new RigidPose(new Vector3(-0.5f, 0, 0))),
                new CompoundPart(ConvexShape.Box(new Vector3(0.5f)), new RigidPose(new Vector3(0.5f, 0, 0))),
            ])),
        _ => AnyShape.Of(ConvexShape.HalfSpace(random.Vector(1), random.Float(-0.2f, 0.2f))),
    };
}
