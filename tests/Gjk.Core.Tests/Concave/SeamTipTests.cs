namespace Gjk.Core.Tests.Concave;

/// <summary>A convex body with a corner or tip down at a seam of parts of a compound, where the shortest ways out of
/// the parts lead aside, has the contacts that it has on one box: straight up, and as deep.</summary>
public class SeamTipTests
{
    private static readonly float[] s_beside = [0, 1e-6f, 1e-4f, 1e-3f, 1e-2f];

    private readonly ConcaveScratch _scratch = new();

    private static readonly string[] s_floors =
    [
        "four tiles", "T", "nested", "mixed", "tile and fields", "fields", "thick and thin", "boxes",
    ];

    public static TheoryData<string, float, bool> Places
    {
        get
        {
            var data = new TheoryData<string, float, bool>();
            foreach (string floor in s_floors)
            {
                foreach (float size in new[] { 0.01f, 1, 100 })
                {
                    data.Add(floor, size, false);
                    data.Add(floor, size, true);
                }
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Places))]
    public void ItIsPushedStraightUp(string floor, float size, bool isTurned)
    {
        var shape = AnyShape.Of(new CompoundShape([.. Parts(floor, size)]));
        RigidPose at = isTurned
            ? new(Quaternion.Normalize(new Quaternion(0.3f, 0.5f, -0.2f, 0.8f)), new Vector3(0.3f, -0.2f, 0.7f) * size)
            : RigidPose.Identity;
        var random = new Rng(21);
        List<PairContacts> contacts = [];
        var up = Vector3.Transform(Vector3.UnitY, at.Rotation);
        foreach (ConvexShape own in Bodies())
        {
            var body = AnyShape.Of(own.Scaled(new Vector3(size)));
            for (int i = 0; i < 8 * s_beside.Length; i++)
            {
                float depth = 1e-4f * MathF.Pow(200, random.Float(0, 1)), beside = s_beside[i / 8];
                var tip = new Vector3(
                    beside * random.Float(-1, 1), -depth,
                    i % 2 == 0 ? beside * random.Float(-1, 1) : random.Float(-0.4f, 0.4f));
                RigidPose local = Placed(own, tip, random.Float(-3, 3), size), pose = at * local;
                Assert.True(ConcaveQuery.FindContacts(shape, at, body, pose, 0.01f * size, _scratch, contacts));
                Assert.NotEmpty(contacts);
                Assert.All(contacts, one => Assert.True(
                    one.Result.Distance > 0 || (one.Manifold.Normal - up).Length() < 1e-4f, $"{own} {tip}: {one}"));
                float deepest = contacts.Min(one => one.Result.Distance) / size;
                Assert.True(MathF.Abs(deepest + depth) < 1e-5f, $"{own} at {tip}: {deepest}");
            }
        }
    }

    private static IEnumerable<ConvexShape> Bodies()
    {
        yield return ConvexShape.Mesh(
        [
            new(0, -0.5f, 0), new(0, 0.5f, 0), new(0.9f, 0.1f, 0), new(-0.9f, 0.1f, 0), new(0, 0.1f, 0.9f),
            new(0, 0.1f, -0.9f),
        ]);
        var random = new Rng(5);
        foreach (int corners in new[] { 12, 40 })
        {
            var points = new Vector3[corners];
            for (int i = 0; i < corners; i++) points[i] = 0.7f * Vector3.Normalize(random.Vector(1));
            yield return ConvexShape.Mesh(points);
        }

        yield return ConvexShape.Cone(0.4f, 1).Placed(new(new Quaternion(1, 0, 0, 0), Vector3.Zero));
        yield return ConvexShape.TaperedCapsule(0.4f, 0.02f, 0.6f);
        yield return ConvexShape.Box(new Vector3(0.4f)).Placed(
            new(Quaternion.Normalize(new Quaternion(0.4f, 0.1f, 0.2f, 0.8f)), Vector3.Zero));
    }

    /// <summary>The body turned about the vertical, with its lowest point at a place.</summary>
    private static RigidPose Placed(in ConvexShape own, Vector3 tip, float turn, float size)
    {
        var yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, turn);
        var high = new RigidPose(yaw, new Vector3(0, 5, 0));
        DistanceResult below = ConvexQuery.Distance(
            ConvexShape.Box(new Vector3(50, 1, 50)), new RigidPose(-Vector3.UnitY), own, high);
        return new RigidPose(yaw, (high.Position - below.PointB + tip) * size);
    }

    private static List<CompoundPart> Parts(string name, float size)
    {
        List<CompoundPart> quarters =
        [
            Tile(-1, -1, 1, 0.5f), Tile(1, -1, 1, 0.5f), Tile(-1, 1, 1, 0.5f), Tile(1, 1, 1, 0.5f),
        ];
        return name switch
        {
            "T" => [Tile(-1, 0, 2, 0.5f), quarters[1], quarters[3]],
            "nested" => [quarters[0], new(Nested(), RigidPose.Identity), quarters[3]],
            "mixed" => [quarters[0], Box(1, -1), Box(-1, 1), quarters[3]],
            "tile and fields" => [Tile(-1, 0, 2, 0.5f), Field(0, -4), Field(0, 0)],
            "fields" => [Field(-4, -2), Field(0, -2)],
            "thick and thin" => [quarters[0], Tile(1, -1, 1, 0.3f), Tile(-1, 1, 1, 0.7f), Tile(1, 1, 1, 1)],
            "boxes" => [Box(-1, -1), Box(1, -1), Box(-1, 1), Box(1, 1)],
            _ => quarters,
        };

        AnyShape Nested() => AnyShape.Of(new CompoundShape([quarters[1], quarters[2]]));

        CompoundPart Tile(float x, float z, float along, float half) => new(
            AnyShape.Solid(ConcaveShapes.Box(new Vector3(1, half, along) * size)),
            new RigidPose(new Vector3(x, -half, z) * size));

        CompoundPart Box(float x, float z) => new(
            ConvexShape.Box(new Vector3(1, 0.5f, 1) * size), new RigidPose(new Vector3(x, -0.5f, z) * size));

        CompoundPart Field(float x, float z) =>
            new(Solids.FlatField(5, size, isSolid: true), new RigidPose(new Vector3(x, 0, z) * size));
    }
}
