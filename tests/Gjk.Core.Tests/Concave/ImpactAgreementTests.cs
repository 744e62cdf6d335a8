namespace Gjk.Core.Tests.Concave;

/// <summary>The tolerance of a time of impact is an accuracy, and the same one whatever a body is made of: a box, its
/// mesh and its halves hit and miss alike, however large it is.</summary>
public sealed class ImpactAgreementTests
{
    private readonly ConcaveScratch _scratch = new();

    /// <summary>Boxes apart that come nearer, pass, part or spin in place, with tolerances below and above their
    /// distance. What passes within the coarsest tolerance may hit or miss, so a few of them may differ.</summary>
    [Fact]
    public void ABoxItsMeshAndItsHalvesHitAlike()
    {
        int count = Budget.Few(1000), hits = 0, asked = 0, differing = 0;
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)(9000 + i));
            Vector3 halfA = rng.Vector(0.2, 1), halfB = rng.Vector(0.2, 1), from = rng.UnitVector() * rng.Float(1, 4);
            var poseA = new RigidPose(rng.Rotation(), rng.Vector(-1, 1));
            var poseB = new RigidPose(rng.Rotation(), poseA.Position + from);
            bool turns = i % 4 != 0;
            var a = new RigidMotion(poseA, rng.Vector(-0.2, 0.2), turns ? rng.Vector(-1, 1) : default);
            Vector3 way = from * rng.Float(-2, 0.5) + rng.Vector(-0.5, 0.5);
            var b = new RigidMotion(poseB, i % 5 == 0 ? default : way, turns ? rng.Vector(-1, 1) : default);
            AnyShape boxA = Box(halfA), boxB = Box(halfB);
            double coarsest = 2e-3 * (halfA.Length() + halfB.Length());
            float gap = ConvexQuery.Distance(boxA.Convex, poseA, boxB.Convex, poseB).Distance;
            if (!(gap > coarsest)) continue;
            CastResult touch = ConvexQuery.TimeOfImpact(boxA.Convex, a, boxB.Convex, b);
            if (touch.IsHit) hits++;
            float tolerance = (i / 5 % 4) switch { 0 => 0.1f, 1 => 1.1f, 2 => 10, _ => float.PositiveInfinity } * gap;
            foreach ((AnyShape x, AnyShape y) in new[]
            {
                (boxA, boxB), (boxA, Mesh(halfB)), (Mesh(halfA), Mesh(halfB)), (Halves(halfA), Mesh(halfB)),
            })
            {
                CastHit r = ConcaveQuery.TimeOfImpact(x, a, y, b, _scratch, tolerance);
                asked++;
                if (r.IsHit != touch.IsHit) differing++;
                if (!r.IsHit) continue;
                double left = ConvexQuery.Distance(
                    boxA.Convex, PartAdvancement.PoseAt(a, r.Result.Fraction), boxB.Convex,
                    PartAdvancement.PoseAt(b, r.Result.Fraction)).Distance;
                string what = $"{i}: {x.Kind} and {y.Kind} {r} of {gap} to {tolerance}, but {touch} and {left}";
                Assert.True(left <= coarsest + 1e-6, what);
                Assert.True(!touch.IsHit || r.Result.Fraction <= touch.Fraction + 1e-4f, what);
            }
        }

        Assert.InRange(hits, 0.25 * count, 0.75 * count);
        Assert.True(differing <= 0.005 * asked, $"{differing} of {asked}");
    }

    /// <summary>Two meshes that do not come near are found to miss without a look at their triangles.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(9)]
    [InlineData(1e30f)]
    [InlineData(float.PositiveInfinity)]
    public void MeshesFarApartCostNothing(float tolerance)
    {
        foreach (bool isSolid in new[] { false, true })
        {
            TriangleMesh ball = Surfaces.Ball(6, 4, (_, _) => 0.5).Build();
            AnyShape a = AnyShape.Surface(ball), b = isSolid ? AnyShape.Solid(ball) : a;
            CastHit r = ConcaveQuery.TimeOfImpact(
                a, new RigidMotion(RigidPose.Identity, default, Vector3.UnitY), b,
                new RigidMotion(new RigidPose(new Vector3(0, 9, 0)), -Vector3.UnitY), _scratch, tolerance);
            Assert.Equal((CastStatus.Miss, 1f), (r.Status, r.Result.Fraction));
            Assert.Equal(0, _scratch.CastSearch.QueryCount);
            Assert.InRange(_scratch.CastSearch.Steps, 0, 8);
        }
    }

    private static AnyShape Box(Vector3 half) => AnyShape.Of(ConvexShape.Box(half));

    private static AnyShape Mesh(Vector3 half) => AnyShape.Surface(ConcaveShapes.Box(half));

    private static AnyShape Halves(Vector3 half)
    {
        Vector3 side = half * new Vector3(0.5f, 1, 1), middle = new(half.X / 2, 0, 0);
        return AnyShape.Of(new CompoundShape(
            [
                new CompoundPart(ConvexShape.Box(side), new RigidPose(middle)),
                new CompoundPart(ConvexShape.Box(side), new RigidPose(-middle)),
            ]));
    }
}
