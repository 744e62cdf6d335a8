namespace Gjk.Core.Tests.Concave;

/// <summary>A level wheel on a flat floor touches it along its line, however the floor is cut, and at all of that. At
/// the floor's border and at a ridge what is beside the line is real.</summary>
public class TouchLineTests
{
    private const float Off = 1e-3f;

    /// <summary>Floors of static objects.</summary>
    private const string Boxes = "objects that are boxes", Fields = "objects that are fields";

    private static readonly AnyShape Whole = AnyShape.Of(
        ConvexShape.Box(new Vector3(1.5f, 1, 1.5f)).Placed(new RigidPose(new Vector3(1.5f, -1, 1.5f))));

    public static TheoryData<string, string> Pairs
    {
        get
        {
            var pairs = new TheoryData<string, string>();
            string[] floors = ["plate", "doubled", "tiles", "joined boxes", "compound", "turned plate", Boxes, Fields];
            foreach (string floor in floors)
                foreach (string wheel in new[] { "cylinder", "capsule", "rounded box" }) pairs.Add(floor, wheel);
            return pairs;
        }
    }

    [Theory]
    [MemberData(nameof(Pairs))]
    public void AWheelHasItsLineAlone(string floor, string wheel)
    {
        var rng = new Rng((ulong)(floor.Length + wheel.Length));
        int count = Budget.Count(300);
        for (int i = 0; i < count; i++)
        {
            // Where a line ends on a field by less than it is deep, the field's border has the contact.
            float depth = floor == Fields ? rng.Of(-1e-3f, 3e-4f, 2e-3f) : rng.Of(-1e-3f, 3e-4f, 0.02f, 0.1f);
            float maxGap = depth < 0 ? 0.01f : rng.Of(0, 1e-5f, 0.01f);
            RigidPose pose = OnFloor(rng, wheel, depth, 1 + rng.Float(0, 1), 1.5f + rng.Float(-0.03, 0.03));
            List<ManifoldPoint> points = floor is Boxes or Fields
                ? AskScene(floor, wheel, pose, maxGap, i % 2 == 0)
                : Ask(Floor(floor), wheel, pose, maxGap, i % 2 == 0);
            List<ManifoldPoint> line = Ask(Whole, wheel, pose, maxGap, true);
            string record = $"{floor}, {wheel} {i}, {depth} deep at {pose}, gap up to {maxGap}";
            Vector3 axis = Vector3.Transform(Vector3.UnitY, pose.Rotation), across = new(-axis.Z, 0, axis.X);
            foreach (ManifoldPoint point in points)
            {
                float off = Vector3.Dot(point.PointA - pose.Position, across);
                Assert.True(Math.Abs(off) < Off, $"{record}: {point} is {off} off");
                Assert.True(Math.Abs(point.Gap + depth) < 1e-5f, $"{record}: {point}");
            }

            AssertHas(points, line, record);
        }
    }

    [Theory]
    [InlineData("border", "cylinder")]
    [InlineData("border", "capsule")]
    [InlineData("ridge", "cylinder")]
    [InlineData("ridge", "capsule")]
    public void PointsAtABorderOrRidgeStay(string edge, string wheel)
    {
        Vector3[] vertices = [default, new(0, 0, 3), new(3, 0, 0), new(1.5f, -0.3f, -3)];
        int[] indices = edge == "border" ? [0, 1, 2] : [0, 1, 2, 0, 2, 3];
        AnyShape floor = AnyShape.Surface(new TriangleMesh(vertices, indices));
        AnyShape flat = AnyShape.Of(ConvexShape.Triangle(vertices[0], vertices[1], vertices[2]));
        var rng = new Rng(5);
        int beside = 0;
        for (int i = 0; i < 200; i++)
        {
            RigidPose pose = OnFloor(rng, wheel, 0.002f, 1.5f, rng.Float(-0.004, 0.004));
            List<ManifoldPoint> line = Ask(flat, wheel, pose, 0.01f, true);
            AssertHas(Ask(floor, wheel, pose, 0.01f, true), line, $"{edge}, {wheel} {i} at {pose}");
            if (line.Any(p => p.Gap > -0.00199f)) beside++;
        }

        Assert.InRange(beside, 50, 200);
    }

    private static void AssertHas(List<ManifoldPoint> points, List<ManifoldPoint> line, string record)
    {
        Assert.True(line.Count > 0, record);
        foreach (ManifoldPoint end in line)
        {
            Assert.True(
                points.Any(p => Vector3.Distance(p.PointA, end.PointA) < Off), $"{record}: nothing at {end.PointA}");
        }
    }

    private static RigidPose OnFloor(Rng rng, string wheel, float depth, float x, float z)
    {
        Quaternion turn = Quaternion.CreateFromAxisAngle(
                Vector3.UnitY, rng.Of(0, MathF.PI / 4, MathF.PI / 2) * (x == 1.5f ? 0 : 1) + rng.Float(-0.06, 0.06))
            * Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        if (wheel == "rounded box") turn *= Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI / 4);
        ConvexQuery.Contacts(
            Whole.Convex, RigidPose.Identity, Wheel(wheel), new RigidPose(turn, new Vector3(1.5f, 1, 1.5f)), 2,
            out ContactManifold manifold);
        float low = 1 - Enumerable.Range(0, manifold.Count).Min(i => manifold[i].Gap);
        return new RigidPose(turn, new Vector3(x, low - depth, z));
    }

    private static List<ManifoldPoint> Ask(
        in AnyShape floor, string wheel, in RigidPose pose, float maxGap, bool isFloorA)
    {
        var contacts = new List<PairContacts>();
        AnyShape body = AnyShape.Of(Wheel(wheel));
        Assert.True(isFloorA
            ? ConcaveQuery.FindContacts(floor, RigidPose.Identity, body, pose, maxGap, new ConcaveScratch(), contacts)
            : ConcaveQuery.FindContacts(body, pose, floor, RigidPose.Identity, maxGap, new ConcaveScratch(), contacts));
        return [.. contacts.SelectMany(
            c => Enumerable.Range(0, c.Manifold.Count).Select(k => isFloorA ? c.Manifold[k] : Swapped(c.Manifold[k])))];
    }

    private static List<ManifoldPoint> AskScene(
        string floor, string wheel, in RigidPose pose, float maxGap, bool isFloorFirst)
    {
        var contacts = new List<PairContacts>();
        var scene = new CollisionScene();
        var still = new ObjectSettings(isStatic: true);
        AnyShape field = AnyShape.Surface(TriangleMesh.FromHeights(new float[9], 3, new Vector2(0.25f)));
        int id = isFloorFirst ? -1 : scene.Add(Wheel(wheel), pose);
        foreach (CompoundPart tile in Floors.Tiles(0))
        {
            if (floor == Boxes) scene.Add(tile.Shape, tile.Pose, still);
            else scene.Add(field, new RigidPose(tile.Pose.Position + new Vector3(-0.25f, 0.2f, -0.25f)), still);
        }

        if (isFloorFirst) id = scene.Add(Wheel(wheel), pose);
        scene.FindContacts(maxGap, contacts);
        return [.. contacts.SelectMany(
            c => Enumerable.Range(0, c.Manifold.Count).Select(
                k => c.Pair.B == id ? c.Manifold[k] : Swapped(c.Manifold[k])))];
    }

    private static ManifoldPoint Swapped(ManifoldPoint p) =>
        new(p.PointB, p.PointA, p.LocalPointB, p.LocalPointA, p.Gap, p.FeatureId);

    private static AnyShape Floor(string name)
    {
        if (name is not ("compound" or "turned plate")) return Floors.Named(name);
        Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI);
        RigidPose pose = name == "compound" ? RigidPose.Identity : new RigidPose(turn, new Vector3(3, 0, 3));
        return AnyShape.Of(new CompoundShape([new CompoundPart(Floors.Named("plate"), pose)]));
    }

    private static ConvexShape Wheel(string name) => name switch
    {
        "cylinder" => ConvexShape.Cylinder(0.3f, 0.3f),
        "capsule" => ConvexShape.Capsule(0.3f, 0.3f),
        _ => ConvexShape.Box(new Vector3(0.2f, 0.3f, 0.2f)).Rounded(0.1f),
    };
}
