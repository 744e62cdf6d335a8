namespace Gjk.Core.Tests.Concave;

/// <summary>Contacts have no length of their own: bodies scaled by a power of two have the scaled contacts.</summary>
public class ScaledContactTests
{
    /// <summary>Ratio to the size of the bodies: some units of 2^-53, far below a unit of float.</summary>
    private const double Noise = 1e-15;

    private static readonly float[] _gaps = [0, 1f / 64, 1];
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [], _scaled = [];

    public static TheoryData<int> Exponents => new(-90, -40, -20, -14, 20, 90);

    [Theory]
    [MemberData(nameof(Exponents))]
    public void OfTwoBodies(int exponent)
    {
        int found = 0;
        for (int i = 0; i < Budget.Whole(120); i++)
        {
            var random = new Rng((ulong)i);
            int kindA = random.Below(6), kindB = random.Below(6);
            Quaternion turn = random.Rotation();
            Vector3 at = random.Vector(0.9);
            float gap = _gaps[i % 3];
            foreach (float factor in new[] { 1, MathF.ScaleB(1, exponent) })
            {
                List<PairContacts> contacts = factor == 1 ? _contacts : _scaled;
                ConcaveQuery.FindContacts(
                    Body(kindA, factor), RigidPose.Identity, Body(kindB, factor), new RigidPose(turn, at * factor),
                    gap * factor, _scratch, contacts);
            }

            AssertScaled(exponent, $"{i}: {kindA}, {kindB}");
            found += _contacts.Count;
        }

        Assert.InRange(found, Budget.Whole(450), 50000);
    }

    [Theory]
    [MemberData(nameof(Exponents))]
    public void OfStaticTiles(int exponent)
    {
        int found = 0;
        for (int i = 0; i < 60; i++)
        {
            var random = new Rng((ulong)i);
            int kind = random.Below(6), tile = i % 3;
            Quaternion turn = random.Rotation();
            Vector3 at = new(random.Float(-0.3, 0.3), random.Float(0.3, 0.7), random.Float(-0.3, 0.3));
            foreach (float factor in new[] { 1, MathF.ScaleB(1, exponent) })
            {
                var scene = new CollisionScene();
                scene.Add(Body(kind, factor), new RigidPose(turn, at * factor));
                for (int k = 0; k < 16; k++)
                {
                    Vector3 place = new Vector3(0.5f * (k / 4) - 1, 0, 0.5f * (k % 4) - 1) * factor;
                    scene.Add(Tile(tile, factor), new RigidPose(place), new ObjectSettings(isStatic: true));
                }

                scene.FindContacts(factor / 64, factor == 1 ? _contacts : _scaled);
            }

            AssertScaled(exponent, $"{i}: {kind} on {tile}");
            found += _contacts.Count;
        }

        Assert.InRange(found, 100, 20000);
    }

    private static AnyShape Body(int kind, float factor) => kind switch
    {
        0 => AnyShape.Solid(Solids.Scaled(ConcaveShapes.Box(new Vector3(0.5f)), factor)),
        1 => AnyShape.Solid(Solids.Scaled(Solids.Named("ring", 0), factor)),
        2 => AnyShape.Surface(Solids.Scaled(SeamBodies.Plate(2, 2, (x, z) => x * x / 4), factor)),
        3 => AnyShape.Solid(Solids.Scaled(ConcaveShapes.Torus(5, 4), factor)),
        4 => AnyShape.Of(new CompoundShape([.. Floors.Tiles(0).Take(14).Select(tile => new CompoundPart(
            ConvexShape.Box(new Vector3(0.25f, 0.2f, 0.25f) * factor), new RigidPose(tile.Pose.Position * factor)))])),
        _ => AnyShape.Of(ConvexShape.Box(new Vector3(0.5f, 0.25f, 0.4f) * factor)),
    };

    private static AnyShape Tile(int kind, float factor) => kind switch
    {
        0 => AnyShape.Of(ConvexShape.Box(new Vector3(0.25f) * factor)),
        1 => AnyShape.Solid(Solids.Scaled(ConcaveShapes.Box(new Vector3(0.25f)), factor)),
        _ => AnyShape.Surface(TriangleMesh.FromHeights(new float[4], 2, new Vector2(0.5f) * factor)),
    };

    private void AssertScaled(int exponent, string what)
    {
        Assert.True(_contacts.Count == _scaled.Count, $"{what}: {_contacts.Count} contacts, scaled {_scaled.Count}");
        for (int i = 0; i < _contacts.Count; i++)
        {
            PairContacts one = _contacts[i], other = _scaled[i];
            string where = $"{what}: {one}, scaled {other}";
            Assert.True(one.Pair == other.Pair && one.PartA == other.PartA && one.PartB == other.PartB, where);
            Assert.True(IsScaled(one.Manifold.Normal, other.Manifold.Normal, 0), where);
            Assert.True(one.Manifold.Count == other.Manifold.Count, where);
            for (int k = 0; k < one.Manifold.Count; k++)
            {
                ManifoldPoint point = one.Manifold[k], scaled = other.Manifold[k];
                Assert.True(MathF.ScaleB(point.Gap, exponent) == scaled.Gap, where);
                Assert.True(IsScaled(point.PointA, scaled.PointA, exponent), where);
                Assert.True(IsScaled(point.PointB, scaled.PointB, exponent), where);
                Assert.True(IsScaled(point.LocalPointA, scaled.LocalPointA, exponent), where);
                Assert.True(IsScaled(point.LocalPointB, scaled.LocalPointB, exponent), where);
            }
        }
    }

    /// <summary>All bits are the same, but for those of a component that is 0 to double's rounding: far from size 1 a
    /// convex pair is brought to unit size, which rounds in another order.</summary>
    private static bool IsScaled(Vector3 v, Vector3 scaled, int exponent)
    {
        double factor = Math.ScaleB(1, exponent);
        for (int i = 0; i < 3; i++)
            if (Math.Abs(scaled[i] / factor - v[i]) > Noise) return false;
        return true;
    }
}
