namespace Gjk.Core.Tests.Support;

/// <summary>Polytopes on a lattice that touch exactly: with a corner of B on a corner of A, in a direction in which
/// neither reaches further. Faces, edges and corners lie on each other as it happens; no float rounds.</summary>
internal static class TouchingPairs
{
    /// <summary>Turned by a quarter, which floats hold exactly, since q and -q's parts are the same number.</summary>
    private static readonly Quaternion[] Quarters =
    [
        Quaternion.Identity, new(0.70710677f, 0, 0, 0.70710677f), new(0, 0.70710677f, 0, 0.70710677f),
        new(0.5f, 0.5f, 0.5f, 0.5f),
    ];

    public static TestPair Make(ulong seed)
    {
        var rng = new Rng(seed);
        TestShape a = Shape(rng), b = Shape(rng);
        Quaternion turnA = Quarters[rng.Below(4)], turnB = Quarters[rng.Below(4)];
        Vector3 direction = Lattice(rng, 1);
        if (direction == Vector3.Zero) direction = Vector3.UnitY;
        Vector3 onA = Furthest(a, turnA, direction), onB = Furthest(b, turnB, -direction);
        Vector3 at = Lattice(rng, 9);
        return new TestPair(
            $"touching {seed}", a, new RigidPose(turnA, at), b, new RigidPose(turnB, at + onA - onB));
    }

    /// <summary>A motion along lattice directions, of any length.</summary>
    public static Vector3 Motion(Rng rng) => Lattice(rng, 2) * (float)Math.ScaleB(1, rng.Below(9) - 5);

    private static TestShape Shape(Rng rng) => rng.Below(5) switch
    {
        0 => TestShape.Box(Positive(rng)),
        1 => TestShape.Segment(Lattice(rng, 2), new Vector3(3, 1, 0)),
        2 => TestShape.Triangle(Lattice(rng, 2), new Vector3(3, 0, 1), new Vector3(0, 3, -1)),
        3 => TestShape.Point(),
        _ => TestShape.Mesh(
            [.. Enumerable.Range(0, 5 + rng.Below(5)).Select(_ => Lattice(rng, 3)), new(4, 0, 0), new(0, 4, 1)]),
    };

    private static Vector3 Furthest(TestShape shape, Quaternion turn, Vector3 direction)
    {
        var body = new Body<ConvexShape>(shape.Shape, new RigidPose(turn, Vector3.Zero));
        return shape.Vertices!.Select(v => Rounded(body.Rotate(v))).MaxBy(v => Vector3.Dot(v, direction));
    }

    private static Vector3 Rounded(in Double3 v) =>
        new((float)Math.Round(v.X), (float)Math.Round(v.Y), (float)Math.Round(v.Z));

    private static Vector3 Lattice(Rng rng, int most) =>
        new(rng.Below(2 * most + 1) - most, rng.Below(2 * most + 1) - most, rng.Below(2 * most + 1) - most);

    private static Vector3 Positive(Rng rng) => new(1 + rng.Below(3), 1 + rng.Below(3), 1 + rng.Below(3));
}
