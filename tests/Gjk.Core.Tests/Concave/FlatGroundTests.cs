namespace Gjk.Core.Tests.Concave;

/// <summary>Over a flat ground only the ground's face is near, however its parts are cut: what lies on it is lifted
/// straight and by no more than it is deep.</summary>
public class FlatGroundTests
{
    private const float MaxGap = 0.02f;

    /// <summary>Cosines: what tilts a normal by 2e-3, more than a body that is rocked by 1e-4 does.</summary>
    private const float Straight = 1 - 2e-6f;

    private static readonly string[] Sheets = ["two triangles", "field", "compound of two", "compound of a field"];

    public static TheoryData<string, string> Pairs
    {
        get
        {
            var pairs = new TheoryData<string, string>();
            foreach (string ground in Sheets.Concat(["box", "tiles", "planks", "plates"]))
                foreach (string body in new[] { "solid", "surface", "flush boxes", "box" })
                    if (body != "surface" || !Sheets.Contains(ground)) pairs.Add(ground, body);
            return pairs;
        }
    }

    [Theory]
    [MemberData(nameof(Pairs))]
    public void WhatLiesOnFlatGroundIsLiftedStraight(string ground, string body)
    {
        AnyShape floor = Ground(ground);
        var scratch = new ConcaveScratch();
        var contacts = new List<PairContacts>();
        var rng = new Rng((ulong)(ground.Length + 100 * body.Length));
        bool isSheet = Sheets.Contains(ground);
        float[] tilts = isSheet ? [1e-7f, 1e-6f, 1e-5f] : [1e-6f, 1e-3f, 0.1f, 3];
        int count = Budget.Count(isSheet ? 60 : 12);

        // A corner that is deeper than it is far from the joints of a tile has no tile that pushes it straight up. Of
        // bodies that lean by up to 3, 1 in 50 is then pushed along a leaning face, or by another depth.
        float[] depths = ground == "tiles" && body is ("solid" or "surface")
            ? [-1e-4f, 1e-4f, 5e-3f] : [-1e-4f, 1e-4f, 5e-3f, 0.03f, 0.05f];
        foreach (float tilt in tilts)
            foreach (float depth in depths)
                for (int i = 0; i < count; i++)
                {
                    (AnyShape shape, Vector3[] points) = Body(body, 3 + i % 6);
                    var lean = Quaternion.CreateFromAxisAngle(
                        Vector3.Normalize(new Vector3(rng.Float(-1, 1), 0, rng.Float(-1, 1))), rng.Float(0, tilt));
                    Quaternion turn = Quaternion.Normalize(
                        lean * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6)));
                    float lowest = points.Min(p => Vector3.Transform(p, turn).Y);
                    var pose = new RigidPose(turn, new Vector3(rng.Float(-2, 2), -lowest - depth, rng.Float(-2, 2)));
                    bool isGroundA = i % 2 == 0;
                    Assert.True(isGroundA
                        ? ConcaveQuery.FindContacts(floor, RigidPose.Identity, shape, pose, MaxGap, scratch, contacts)
                        : ConcaveQuery.FindContacts(shape, pose, floor, RigidPose.Identity, MaxGap, scratch, contacts));
                    string what = $"{ground}, {body} {i}, {depth} deep at {pose}";
                    float deepest = float.PositiveInfinity;
                    foreach (PairContacts contact in contacts)
                    {
                        float up = isGroundA ? contact.Manifold.Normal.Y : -contact.Manifold.Normal.Y;
                        Assert.True(up > Straight, $"{what}: {contact}");
                        for (int k = 0; k < contact.Manifold.Count; k++)
                            deepest = Math.Min(deepest, contact.Manifold[k].Gap);
                    }

                    Assert.True(Math.Abs(deepest + depth) < 0.02f * Math.Abs(depth) + 1e-5f, $"{what}: {deepest}");
                }
    }

    /// <summary>Its triangles as parts, placed a second time where they were.</summary>
    private static AnyShape InCompound(in AnyShape sheet)
    {
        var turn = new Quaternion(0, 0.6f, 0, 0.8f);
        var inner = new CompoundShape([new CompoundPart(sheet, new RigidPose(turn, Vector3.Zero))]);
        return AnyShape.Of(
            new CompoundShape(
                [new CompoundPart(AnyShape.Of(inner), new RigidPose(Quaternion.Conjugate(turn), Vector3.Zero))]));
    }

    private static AnyShape Ground(string name) => name switch
    {
        "two triangles" => AnyShape.Surface(new TriangleMesh(
            [new(-5, 0, -5), new(5, 0, -5), new(-5, 0, 5), new(5, 0, 5)], [0, 2, 1, 1, 2, 3])),
        "field" => AnyShape.Surface(ConcaveShapes.Grid(12).Scaled(new Vector3(5, 1, 5))),
        "compound of two" => InCompound(Ground("two triangles")),
        "compound of a field" => InCompound(Ground("field")),
        "box" => AnyShape.Of(ConvexShape.Box(new Vector3(5, 3, 5)).Placed(new RigidPose(new Vector3(0, -3, 0)))),
        "tiles" => Tiles(0.25f, 0.25f, 0.5f),
        "planks" => Tiles(2.5f, 0.5f, 4),
        _ => Tiles(1, 1, 0.2f),
    };

    private static AnyShape Tiles(float width, float length, float thick)
    {
        var parts = new List<CompoundPart>();
        var half = new Vector3(width / 2, thick, length / 2);
        for (float x = -5; x < 5; x += width)
            for (float z = -5; z < 5; z += length)
                parts.Add(new(ConvexShape.Box(half), new RigidPose(new Vector3(x + half.X, -half.Y, z + half.Z))));
        return AnyShape.Of(new CompoundShape(parts));
    }

    private static (AnyShape Shape, Vector3[] Points) Body(string name, int sides)
    {
        var half = new Vector3(0.3f, 0.2f, 0.25f);
        Vector3[] corners = Clouds.Box(half);
        if (name == "box") return (AnyShape.Of(ConvexShape.Box(half)), corners);
        if (name == "flush boxes")
        {
            Vector3[] ats = [new(-half.X, 0, 0), new(half.X, 0, 0)];
            var shape = new CompoundShape(
                [.. ats.Select(at => new CompoundPart(ConvexShape.Box(half), new RigidPose(at)))]);
            return (AnyShape.Of(shape), [.. ats.SelectMany(at => corners.Select(c => c + at))]);
        }

        TriangleMesh prism = Prism(sides, 0.5f, 0.3f);
        Vector3[] points = [.. Enumerable.Range(0, prism.VertexCount).Select(prism.GetVertex)];
        return (name == "solid" ? AnyShape.Solid(prism) : AnyShape.Surface(prism), points);
    }

    private static TriangleMesh Prism(int sides, float radius, float half)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < sides; i++)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i / sides);
            points.Add(new((float)(radius * cos), -half, (float)(radius * sin)));
            points.Add(new((float)(radius * cos), half, (float)(radius * sin)));
            int low = 2 * i, next = 2 * ((i + 1) % sides);
            indices.AddRange([low, low + 1, next, next, low + 1, next + 1]);
            if (i > 0 && i < sides - 1) indices.AddRange([0, low, next, 1, next + 1, low + 1]);
        }

        return new TriangleMesh(points, indices);
    }
}
