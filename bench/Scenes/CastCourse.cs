namespace Gjk.Bench.Scenes;

/// <summary>Two turned bodies, A at the origin, and where B begins and ends. No query is needed to know whether they
/// meet: B's inner point goes through A, or a plane stays between them.</summary>
internal readonly struct CastCourse
{
    private readonly DepthBody _a, _b;
    private readonly RotationD _turnA, _turnB;
    private readonly Quaternion _rotationA, _rotationB;

    public CastCourse(DepthBody a, Quaternion rotationA, DepthBody b, Quaternion rotationB)
    {
        (_a, _b, _rotationA, _rotationB) = (a, b, rotationA, rotationB);
        (_turnA, _turnB) = (new RotationD(rotationA), new RotationD(rotationB));
    }

    /// <summary>Any rotations.</summary>
    public CastCourse(Prng prng, DepthBody a, DepthBody b)
        : this(a, prng.Rotation(), b, prng.Rotation())
    {
    }

    /// <summary>At this distance of the bodies' inner points they are apart, however they are turned.</summary>
    public double Reach => RadiusOf(_a) + RadiusOf(_b);

    private Double3 MiddleA => _turnA.Rotate(_a.Inside);

    private Double3 MiddleB => _turnB.Rotate(_b.Inside);

    /// <summary>From any side, the bodies apart by up to a number of units, at a point of A or beside it, and
    /// on.</summary>
    /// <param name="scene">Where to add it.</param>
    /// <param name="prng">The source.</param>
    /// <param name="aside">How far beside A's inner point B's one passes, as a share of the way to A's surface: up to 1
    /// they meet.</param>
    /// <param name="apart">The most that they are apart at the start.</param>
    /// <param name="share">How far B goes, 1 being to that point.</param>
    public void Aim(CastScene scene, Prng prng, float aside, float apart, float share)
    {
        Double3 from = prng.UnitVector();
        Double3 start = from * (Reach + prng.Range(0.05f, 1) * apart);
        Double3 outward = _turnA.Rotate(_a.Furthest(_turnA.InverseRotate((Double3)prng.UnitVector()))) - MiddleA;
        Add(scene, start, (outward * aside - start) * share);
    }

    /// <summary>Past A, along a plane across a direction: B's lowest point passes over A's highest one, a gap above it.
    /// With a gap of less than 0 they meet there.</summary>
    public void Pass(CastScene scene, Prng prng, double gap)
    {
        Double3 up = prng.UnitVector(), along = Double3.Cross(up, prng.UnitVector());
        along *= (Reach + prng.Range(0, 1)) / along.Length;
        Add(scene, Above(up, gap) - along, along * 2);
    }

    /// <summary>In A, a point a little inside A's highest one where the same point of B's lowest one is, and on to any
    /// side.</summary>
    public void Sink(CastScene scene, Prng prng, double depth, double way)
    {
        Double3 up = prng.UnitVector();
        Double3 onA = HighestOf(_a, _turnA, up) - MiddleA, onB = HighestOf(_b, _turnB, -up) - MiddleB;
        onA *= 1 - Math.Min(0.5, depth / onA.Length);
        onB *= 1 - Math.Min(0.5, depth / onB.Length);
        Add(scene, onA - onB, prng.UnitVector() * (float)way);
    }

    /// <summary>From a gap above A down by a way, B's lowest point onto A's highest one; a way less than 0 leads
    /// away.</summary>
    public void Drop(CastScene scene, Prng prng, double gap, double way)
    {
        Double3 up = prng.UnitVector();
        Add(scene, Above(up, gap), up * -way);
    }

    /// <summary>From where the inner points are the given vector apart.</summary>
    public void Add(CastScene scene, in Double3 middles, in Double3 motion) =>
        scene.Add(
            _a.Shape, new RigidPose(_rotationA, Vector3.Zero), _b.Shape,
            new RigidPose(_rotationB, (Vector3)(MiddleA + middles - MiddleB)), (Vector3)motion);

    /// <summary>Where B's inner point is from A's when its lowest point is a gap above A's highest.</summary>
    private Double3 Above(in Double3 up, double gap) =>
        HighestOf(_a, _turnA, up) - MiddleA + up * gap - (HighestOf(_b, _turnB, -up) - MiddleB);

    private static Double3 HighestOf(DepthBody body, in RotationD turn, in Double3 up) =>
        turn.Rotate(body.Furthest(turn.InverseRotate(up)));

    private static double RadiusOf(DepthBody body) =>
        (body.Shape.Center - body.Inside).Length + body.Shape.BoundingRadius;
}
