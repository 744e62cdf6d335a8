namespace Gjk.Core.Tests.Concave;

/// <summary>Corners and round sides that dig into a surface beside a seam are held by the face under them.</summary>
public class TipContactTests
{
    private const float Reach = 0.01f;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    [Theory]
    [InlineData("ellipsoid", 0.1f)]
    [InlineData("ellipsoid", 0.25f)]
    [InlineData("swollen ball", 0.1f)]
    [InlineData("cone", 1f)]
    [InlineData("cone", 0.1f)]
    [InlineData("corner", 1f)]
    [InlineData("corner", 0.3f)]
    [InlineData("rim", 0.1f)]
    public void TheDeepestPointHasItsContact(string name, float cell)
    {
        var ground = AnyShape.Surface(TriangleMesh.FromHeights(new float[41 * 41], 41, new Vector2(cell, cell)));
        for (int seed = 0; seed < 400; seed++)
        {
            var random = new Rng((ulong)seed);
            float depth = random.Of(0, 1e-3f, 1e-2f), radius = random.Float(0.3f, 1.2f);
            AnyShape body = AnyShape.Of(Named(name, radius));
            Quaternion own = Quaternion.Normalize(
                Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6)) * Lean(name, random));
            Vector3 over = new(random.Float(15, 25) * cell, 0, random.Float(15, 25) * cell);
            RigidPose at = SeamBodies.Placed(body, over, own, -depth);
            Assert.True(ConcaveQuery.FindContacts(ground, RigidPose.Identity, body, at, Reach, _scratch, _contacts));
            float least = float.PositiveInfinity;
            foreach (PairContacts one in _contacts)
            {
                Assert.True((one.Manifold.Normal - Vector3.UnitY).Length() < 3e-6f, $"{seed}: {one}");
                for (int i = 0; i < one.Manifold.Count; i++)
                {
                    ManifoldPoint point = one.Manifold[i];
                    Assert.True((point.PointA + point.Gap * Vector3.UnitY - point.PointB).Length() < 1e-5f);
                    Assert.True(Math.Abs(point.PointA.Y) < 1e-5f);
                    least = Math.Min(least, point.Gap);
                }
            }

            // Corners that almost coincide share a point, which is a little less deep.
            Assert.True(-least > 0.9f * depth - 2e-6f && -least < depth + 2e-6f, $"{seed}: {least} for {-depth}");
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(8)]
    public void BesideABoxNoFacePushesRightThroughIt(int cells)
    {
        AnyShape mesh = AnyShape.Surface(Grid(cells));
        ConvexShape box = ConvexShape.Box(Vector3.One);
        int found = 0;
        for (int seed = 0; seed < 600; seed++)
        {
            var random = new Rng((ulong)seed);
            ConvexShape body = random.Of(
                ConvexShape.Cylinder(0.4f, 0.7f), ConvexShape.Box(new Vector3(0.7f, 0.3f, 0.4f)),
                ConvexShape.Cone(0.5f, 0.6f), SeamBodies.Named("hull").Convex);
            Quaternion own = seed % 3 == 0 ? Quaternion.Identity : random.Rotation();
            var at = new RigidPose(own, 4 * Vector3.Normalize(random.Vector(1)) + random.Vector(1));
            DistanceResult apart = ConvexQuery.Distance(box, RigidPose.Identity, body, at);
            if (apart.IsOverlapping) continue;
            at = new RigidPose(own, at.Position - apart.Normal * (apart.Distance + (seed % 2 == 0 ? 1e-3f : 2e-2f)));
            float depth = -ConvexQuery.SignedDistance(box, RigidPose.Identity, body, at).Distance;
            ConcaveQuery.FindContacts(
                mesh, RigidPose.Identity, AnyShape.Of(body), at, 0.005f, _scratch, _contacts);
            if (_contacts.Count > 0) found++;
            foreach (PairContacts one in _contacts)
                Assert.True(-one.Result.Distance < 10 * depth, $"{seed}: {one.Result} for {depth}");
        }

        Assert.InRange(found, 590, 600);
    }

    [Fact]
    public void TheyAreSortedByTheirParts()
    {
        AnyShape ground = AnyShape.Surface(SeamBodies.Plate(20, 2, (x, z) => 0.1f * MathF.Sin(3 * x) * MathF.Cos(z)));
        AnyShape body = AnyShape.Of(ConvexShape.Ellipsoid(new Vector3(3, 2, 4)));
        for (int i = 0; i < 50; i++)
        {
            var at = new RigidPose(new Rng((ulong)i).Rotation(), new Vector3(0.1f * i - 2, 1.9f, 0.3f));
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, body, at, Reach, _scratch, _contacts);
            Assert.NotEmpty(_contacts);
            for (int k = 1; k < _contacts.Count; k++) Assert.True(_contacts[k - 1].PartA < _contacts[k].PartA);
        }
    }

    private static ConvexShape Named(string name, float radius) => name switch
    {
        "ellipsoid" => ConvexShape.Ellipsoid(new Vector3(radius, 0.7f * radius, 1.3f * radius)),
        "swollen ball" => ConvexShape.Sphere(radius).Scaled(new Vector3(1, 0.7f, 1.3f)),
        "cone" => ConvexShape.Cone(radius, 0.8f),
        "rim" => ConvexShape.Cylinder(radius, 0.5f),
        _ => ConvexShape.Box(new Vector3(radius, 0.6f, radius)),
    };

    private static Quaternion Lean(string name, Rng random) => name switch
    {
        "cone" => Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI),
        "corner" => Quaternion.CreateFromYawPitchRoll(0.2f, random.Float(0.5f, 1), random.Float(0.5f, 1)),
        "rim" => Quaternion.CreateFromAxisAngle(Vector3.UnitZ, random.Float(0.3f, 1.2f)),
        _ => Quaternion.Identity,
    };

    /// <summary>A box of half side 1, each side cut into cells and these in two.</summary>
    private static TriangleMesh Grid(int cells)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int side = 0; side < 6; side++)
        {
            int first = points.Count, sign = side < 3 ? 1 : -1, axis = side % 3;
            for (int i = 0; i <= cells; i++)
                for (int j = 0; j <= cells; j++)
                {
                    float u = 2f * i / cells - 1, v = sign * (2f * j / cells - 1);
                    points.Add(axis == 0 ? new(sign, u, v) : axis == 1 ? new(v, sign, u) : new(u, v, sign));
                    if (i == cells || j == cells) continue;
                    int p = first + i * (cells + 1) + j, q = p + cells + 1;
                    indices.AddRange([p, q, q + 1, p, q + 1, p + 1]);
                }
        }

        return new TriangleMesh(points, indices);
    }
}
