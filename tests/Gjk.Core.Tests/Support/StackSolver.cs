namespace Gjk.Core.Tests.Support;

/// <summary>A solver of the plainest kind, for bodies that stand on each other: sequential impulses (Catto 2006) over
/// the points that the queries give, begun with the impulses that points of the same name had a frame
/// before.</summary>
/// <param name="iterations">Sweeps over all points, there and back in turn: what a body pushes travels one body further
/// with each.</param>
internal sealed class StackSolver(int iterations = 10)
{
    public const float Step = 1f / 60;

    private const float Gravity = 9.81f, Friction = 0.5f, Slop = 0.005f, Push = 0.2f, MaxGap = 0.02f;

    private readonly List<SolidBody> _bodies = [];
    private readonly List<PairContacts> _contacts = [];
    private readonly ConcaveScratch _scratch = new();
    private readonly Dictionary<(int A, int B), PointState[]> _pairs = [];

    /// <summary>Pairs with contacts in a frame and the frame before, and those of them with the same names.</summary>
    public int Pairs { get; private set; }

    /// <inheritdoc cref="Pairs"/>
    public int PairsWithTheSameNames { get; private set; }

    /// <summary>The fastest body, as any of its points moves.</summary>
    public float Speed => _bodies.Max(b => b.Velocity.Length() + b.Spin.Length() * b.Reach);

    public IReadOnlyList<SolidBody> Bodies => _bodies;

    /// <param name="shape">Without a mass when it is not given.</param>
    /// <param name="pose">Where it is.</param>
    /// <param name="mass">0 for a body that stays.</param>
    /// <param name="inertia">About its axes, for a mass of 1.</param>
    public void Add(ConvexShape shape, RigidPose pose, float mass = 0, Vector3 inertia = default) =>
        Add(AnyShape.Of(shape), pose, mass, inertia);

    /// <inheritdoc cref="Add(ConvexShape, RigidPose, float, Vector3)"/>
    public void Add(AnyShape shape, RigidPose pose, float mass = 0, Vector3 inertia = default) =>
        _bodies.Add(new SolidBody(shape, pose, mass, inertia));

    /// <summary>Solves a frame.</summary>
    public void Advance()
    {
        List<PointState> points = FindPoints();
        foreach (SolidBody body in _bodies)
            if (body.InverseMass > 0) body.Velocity -= Vector3.UnitY * (Gravity * Step);
        foreach (PointState p in points) p.Prepare(Friction);
        for (int i = 0; i < iterations; i++)
            for (int k = 0; k < points.Count; k++) points[i % 2 == 0 ? k : points.Count - 1 - k].Solve(Friction);
        foreach (SolidBody body in _bodies) body.Move(Step);
    }

    public void ForgetNames() => (Pairs, PairsWithTheSameNames) = (0, 0);

    private List<PointState> FindPoints()
    {
        List<PointState> points = [];
        for (int i = 0; i < _bodies.Count; i++)
        {
            for (int k = i + 1; k < _bodies.Count; k++)
            {
                if (_bodies[i].InverseMass + _bodies[k].InverseMass == 0) continue;
                points.AddRange(PointsOf(i, k));
            }
        }

        return points;
    }

    private PointState[] PointsOf(int i, int k)
    {
        SolidBody a = _bodies[i], b = _bodies[k];
        FindContacts(a, b);
        _pairs.TryGetValue((i, k), out PointState[]? before);
        PointState[] points =
        [
            .. from one in _contacts
               from p in Enumerable.Range(0, one.Manifold.Count)
               select MadeOf(a, b, one, one.Manifold[p]),
        ];
        foreach (PointState point in points)
        {
            PointState? last = before?.FirstOrDefault(q => q.Id == point.Id);
            if (last is not null) point.TakeImpulses(last);
        }

        if (before is { Length: > 0 } && points.Length > 0)
        {
            Pairs++;
            if (before.Select(q => q.Id).SequenceEqual(points.Select(q => q.Id))) PairsWithTheSameNames++;
        }

        _pairs[(i, k)] = points;
        return points;
    }

    private void FindContacts(SolidBody a, SolidBody b)
    {
        _contacts.Clear();
        if (Vector3.Distance(a.Pose.Position, b.Pose.Position) >= a.Reach + b.Reach + MaxGap) return;
        if (a.Shape.Kind != AnyShapeKind.Convex || b.Shape.Kind != AnyShapeKind.Convex)
        {
            ConcaveQuery.FindContacts(a.Shape, a.Pose, b.Shape, b.Pose, MaxGap, _scratch, _contacts);
            return;
        }

        DistanceResult result = ConvexQuery.Contacts(
            a.Shape.Convex, a.Pose, b.Shape.Convex, b.Pose, MaxGap, out ContactManifold manifold);
        if (manifold.Count > 0) _contacts.Add(new PairContacts(-1, -1, result, manifold));
    }

    private static PointState MadeOf(SolidBody a, SolidBody b, in PairContacts one, in ManifoldPoint contact)
    {
        float away = contact.Gap > 0 ? -contact.Gap / Step : Push / Step * MathF.Max(-contact.Gap - Slop, 0);
        return new PointState(a, b, contact, one.Manifold.Normal, away, (one.PartA, one.PartB, contact.FeatureId));
    }

    /// <summary>A contact point of a frame and its impulses.</summary>
    private sealed class PointState(
        SolidBody a, SolidBody b, ManifoldPoint contact, Vector3 normal, float away, (int, int, long) id)
    {
        private readonly Vector3 _fromA = contact.PointA - a.Pose.Position, _fromB = contact.PointB - b.Pose.Position;
        private readonly Vector3 _first = Across(normal), _second = Vector3.Cross(normal, Across(normal));
        private float _push, _alongFirst, _alongSecond;

        public (int PartA, int PartB, long Feature) Id => id;

        public void TakeImpulses(PointState last) =>
            (_push, _alongFirst, _alongSecond) = (last._push, last._alongFirst, last._alongSecond);

        public void Prepare(float friction)
        {
            _alongFirst = Math.Clamp(_alongFirst, -friction * _push, friction * _push);
            _alongSecond = Math.Clamp(_alongSecond, -friction * _push, friction * _push);
            Apply(normal * _push + _first * _alongFirst + _second * _alongSecond);
        }

        public void Solve(float friction)
        {
            Slide(_first, ref _alongFirst, friction * _push);
            Slide(_second, ref _alongSecond, friction * _push);
            float push = MathF.Max(_push + (away - Closing(normal)) / Weight(normal), 0);
            Apply(normal * (push - _push));
            _push = push;
        }

        private void Slide(Vector3 along, ref float impulse, float most)
        {
            float wanted = Math.Clamp(impulse - Closing(along) / Weight(along), -most, most);
            Apply(along * (wanted - impulse));
            impulse = wanted;
        }

        /// <summary>How fast B leaves A at the point, along a direction.</summary>
        private float Closing(Vector3 along) => Vector3.Dot(
            along, b.Velocity + Vector3.Cross(b.Spin, _fromB) - a.Velocity - Vector3.Cross(a.Spin, _fromA));

        private float Weight(Vector3 along) => a.Give(_fromA, along) + b.Give(_fromB, along);

        private void Apply(Vector3 impulse)
        {
            a.Apply(-impulse, _fromA);
            b.Apply(impulse, _fromB);
        }

        private static Vector3 Across(Vector3 n)
        {
            Vector3 axis = MathF.Abs(n.X) < 0.6f ? Vector3.UnitX : Vector3.UnitZ;
            return Vector3.Normalize(Vector3.Cross(n, axis));
        }
    }
}

/// <summary>A body of a <see cref="StackSolver"/>.</summary>
internal sealed class SolidBody(AnyShape shape, RigidPose pose, float mass, Vector3 inertia)
{
    private readonly Vector3 _inverseInertia = mass > 0 ? Vector3.One / (inertia * mass) : Vector3.Zero;

    public Vector3 Velocity, Spin;

    public AnyShape Shape => shape;

    public RigidPose Pose { get; private set; } = pose;

    public float InverseMass { get; } = mass > 0 ? 1 / mass : 0;

    public float Reach { get; } = mass > 0 ? RadiusOf(shape) : 1e3f;

    public void Apply(Vector3 impulse, Vector3 at)
    {
        Velocity += impulse * InverseMass;
        Spin += Turned(Vector3.Cross(at, impulse));
    }

    /// <summary>How fast a point moves along a direction under a unit impulse there.</summary>
    public float Give(Vector3 at, Vector3 along)
    {
        Vector3 arm = Vector3.Cross(at, along);
        return InverseMass + Vector3.Dot(arm, Turned(arm));
    }

    public void Move(float step)
    {
        if (InverseMass == 0) return;
        Quaternion q = Pose.Rotation;
        q += new Quaternion(Spin * (0.5f * step), 0) * q;
        Pose = new RigidPose(Quaternion.Normalize(q), Pose.Position + Velocity * step);
    }

    private static float RadiusOf(in AnyShape shape) => shape.Mesh is not { } mesh
        ? (float)shape.Convex.BoundingRadius
        : Enumerable.Range(0, mesh.VertexCount).Max(i => (mesh.GetVertex(i) * mesh.Scale).Length());

    private Vector3 Turned(Vector3 v) => Vector3.Transform(
        Vector3.Transform(v, Quaternion.Conjugate(Pose.Rotation)) * _inverseInertia, Pose.Rotation);
}
