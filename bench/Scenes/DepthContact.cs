namespace Gjk.Bench.Scenes;

/// <summary>Two turned bodies and a point of each, from where the body is and in the world's axes. The bodies are put
/// where these points are one. A point of the surface is sunk into its body before. Both points are inside then, so
/// that the bodies overlap whatever they look like, and no query is needed to place them.</summary>
internal readonly struct DepthContact
{
    /// <summary>The share of an edge within which it is met, so that a pair that slides does not leave it.</summary>
    private const float EdgeMiddle = 0.8f;

    private readonly DepthBody _a, _b;
    private readonly RotationD _turnA, _turnB;
    private readonly Quaternion _rotationA, _rotationB;
    private readonly Double3 _onA, _onB;

    private DepthContact(in DepthContact turned, in Double3 onA, in Double3 onB)
    {
        this = turned;
        _onA = onA;
        _onB = onB;
    }

    private DepthContact(DepthBody a, Quaternion rotationA, DepthBody b, Quaternion rotationB)
    {
        (_a, _b, _rotationA, _rotationB) = (a, b, rotationA, rotationB);
        (_turnA, _turnB) = (new RotationD(rotationA), new RotationD(rotationB));
        (_onA, _onB) = (default, default);
    }

    /// <summary>B's lowest point over a face of A. Round bodies without faces are met in a random direction.</summary>
    public static DepthContact AtFace(Prng prng, DepthBody a, DepthBody b)
    {
        if (!a.HasFaces) return AtCorners(prng, a, b);
        DepthContact turned = Turned(prng, a, b);
        Double3 onFace = a.OnFace(prng, out Double3 normal);
        return new DepthContact(turned, turned._turnA.Rotate(onFace), turned.LowestOfB(turned._turnA.Rotate(normal)));
    }

    /// <summary>An edge of a box across an edge of another.</summary>
    public static DepthContact AtEdges(Prng prng, DepthBody a, DepthBody b)
    {
        DepthContact turned = Turned(prng, a, b);
        int axisA = prng.Index(3), axisB = prng.Index(3);
        Double3 across = Double3.Cross(turned._turnA.Rotate(Axis(axisA)), turned._turnB.Rotate(Axis(axisB)));
        Double3 onA = OnEdge(prng, a.Half, turned._turnA.InverseRotate(across), axisA);
        Double3 onB = OnEdge(prng, b.Half, turned._turnB.InverseRotate(-across), axisB);
        return new DepthContact(turned, turned._turnA.Rotate(onA), turned._turnB.Rotate(onB));
    }

    /// <summary>The furthest points in a random direction, which are corners in most cases.</summary>
    public static DepthContact AtCorners(Prng prng, DepthBody a, DepthBody b)
    {
        DepthContact turned = Turned(prng, a, b);
        Double3 direction = prng.UnitVector();
        Double3 onA = turned._turnA.Rotate(a.Furthest(turned._turnA.InverseRotate(direction)));
        return new DepthContact(turned, onA, turned.LowestOfB(direction));
    }

    /// <summary>Points inside, each a random share of the way from its body's middle to the surface.</summary>
    public static DepthContact Inside(Prng prng, DepthBody a, DepthBody b, float mostShareA, float mostShareB)
    {
        DepthContact turned = Turned(prng, a, b);
        Double3 onA = Off(prng, a, mostShareA), onB = Off(prng, b, mostShareB);
        return new DepthContact(turned, turned._turnA.Rotate(onA), turned._turnB.Rotate(onB));
    }

    /// <summary>The same, with both points moved into their bodies by at most half of the way to the middle.</summary>
    public DepthContact Sunk(double depth) =>
        new(this, Into(_turnA.Rotate(_a.Inside), _onA, depth), Into(_turnB.Rotate(_b.Inside), _onB, depth));

    /// <summary>Adds the pair, with A at the given position.</summary>
    /// <param name="scene">Where to add it.</param>
    /// <param name="position">A's position.</param>
    /// <param name="swap">Whether B is the first of the pair.</param>
    public void AddTo(BenchScene scene, Vector3 position, bool swap)
    {
        int a = scene.Add(_a.Shape, new RigidPose(_rotationA, position));
        int b = scene.Add(_b.Shape, new RigidPose(_rotationB, (Vector3)((Double3)position + _onA - _onB)));
        if (swap) scene.AddPair(b, a);
        else scene.AddPair(a, b);
    }

    private static DepthContact Turned(Prng prng, DepthBody a, DepthBody b) =>
        new(a, prng.Rotation(), b, prng.Rotation());

    private static Double3 Off(Prng prng, DepthBody body, float mostShare) =>
        body.Inside + prng.Range(0, mostShare) * (body.Furthest(prng.UnitVector()) - body.Inside);

    private static Double3 Into(in Double3 inside, in Double3 surface, double depth)
    {
        Double3 way = inside - surface;
        double length = way.Length;
        return length > 0 ? surface + way * Math.Min(depth / length, 0.5) : surface;
    }

    private static Double3 Axis(int axis) => new(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);

    private static Double3 OnEdge(Prng prng, Vector3 half, in Double3 direction, int axis)
    {
        float along = prng.Range(-EdgeMiddle, EdgeMiddle);
        return new Double3(
            axis == 0 ? along * half.X : Math.CopySign(half.X, direction.X),
            axis == 1 ? along * half.Y : Math.CopySign(half.Y, direction.Y),
            axis == 2 ? along * half.Z : Math.CopySign(half.Z, direction.Z));
    }

    /// <summary>The point of B furthest against a direction.</summary>
    private Double3 LowestOfB(in Double3 direction) =>
        _turnB.Rotate(_b.Furthest(_turnB.InverseRotate(-direction)));
}
