namespace Gjk.Core;

/// <summary>What is known of a shape's extent in its own frame, so that its bounds in the world cost a few dozen
/// operations at any pose: the smallest box around the core with its margin, and a ball about the box's
/// centre.</summary>
/// <remarks>Immutable. For those who use a broad phase alone; a <see cref="CollisionScene"/> does it by
/// itself.</remarks>
public readonly struct ShapeBounds
{
    /// <summary>Ratio to the coordinates, outward: four times float's rounding, 2^-24. One covers the bound's own
    /// rounding, one that of a margin added to it in a broad phase, and the rest what shapes may be apart and still
    /// touch. Pinned by ShapeBoundsTests.</summary>
    private const double FloatSlack = 4.0 / (1 << 24);

    /// <summary>Ratio to the position and to the local centre, outward: what rounding in double does to the rotated
    /// centre, 26 roundings at most (proofs/world-bounds.g), and as much again.</summary>
    private const double DoubleSlack = 64.0 / (1L << 53);

    /// <summary>Ratio to the ball's radius, outward: five times how far apart curved shapes still touch. Pinned by
    /// ShapeBoundsTests.</summary>
    private const double TouchSlack = 5 * GjkTolerances.TouchCurved;

    private readonly Double3 _center;
    private readonly Double3 _half;
    private readonly double _margin;
    private readonly double _radius;
    private readonly double _offset;

    /// <summary>Measures a shape; do it once per shape.</summary>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct.</exception>
    public ShapeBounds(in ConvexShape shape)
    {
        if (shape.Kind == ShapeKind.None)
            throw new ArgumentException("A default ConvexShape has no extent.", nameof(shape));
        if (shape.Kind == ShapeKind.HalfSpace)
        {
            this = default;
            _radius = HalfSpaceCore.Endless;
            _half = new Double3(_radius, _radius, _radius);
            return;
        }

        ConvexShape copy = shape;
        CoreExtent.Box(ref copy, out Double3 low, out Double3 high);
        Double3 middle = (low + high) * 0.5;
        _center = shape.Center + middle;
        _half = (high - low) * 0.5;
        _margin = shape.Margin;
        _radius = Math.Min(_half.Length + _margin, shape.BoundingRadius + middle.Length);
        _offset = _center.Length;
    }

    /// <summary>Measures a shape that need not be convex; do it once per shape.</summary>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct.</exception>
    public ShapeBounds(in AnyShape shape)
    {
        if (shape.Kind == AnyShapeKind.Convex)
        {
            this = new ShapeBounds(AnyShape.ConvexOf(shape));
            return;
        }

        if (shape.Kind == AnyShapeKind.None)
            throw new ArgumentException("A default AnyShape has no extent.", nameof(shape));
        PartBox box = PartBox.Around(shape.Mesh is not null ? shape.Mesh : shape.Compound!);
        this = new ShapeBounds((box.Min + box.Max) * 0.5, (box.Max - box.Min) * 0.5);
    }

    /// <summary>Measures the box of a tree, which may be a little larger than its parts, without reading
    /// these.</summary>
    internal ShapeBounds(PartTree tree)
        : this(tree.Origin + tree.Read(0) * tree.Unit, tree.ReachOf(0) * tree.Unit)
    {
    }

    private ShapeBounds(in Double3 center, in Double3 half)
    {
        (_center, _half, _margin) = (center, half, 0);
        (_radius, _offset) = (half.Length, center.Length);
    }

    /// <summary>The radius of a ball about the centre of <see cref="BoxAt"/> that holds the shape.</summary>
    internal double Radius => _radius;

    /// <summary>Whether a box holds everything, as a half-space's does.</summary>
    internal static bool IsEndless(in Aabb box) =>
        box.Min == new Vector3(-float.MaxValue) && box.Max == new Vector3(float.MaxValue);

    /// <summary>A box that holds the shape at a pose: the box around the turned local box, or that around the ball,
    /// whichever is narrower along each axis; rounded outward. That of a half-space holds all floats.</summary>
    public Aabb BoxAt(in RigidPose pose)
    {
        var rotation = new RotationD(pose.Rotation);
        Double3 center = (_offset > 0 ? rotation.Rotate(_center) : default) + pose.Position;
        double x = Math.Abs(rotation.M00) * _half.X + Math.Abs(rotation.M01) * _half.Y
            + Math.Abs(rotation.M02) * _half.Z + _margin;
        double y = Math.Abs(rotation.M10) * _half.X + Math.Abs(rotation.M11) * _half.Y
            + Math.Abs(rotation.M12) * _half.Z + _margin;
        double z = Math.Abs(rotation.M20) * _half.X + Math.Abs(rotation.M21) * _half.Y
            + Math.Abs(rotation.M22) * _half.Z + _margin;
        return Around(center, new Double3(Math.Min(x, _radius), Math.Min(y, _radius), Math.Min(z, _radius)));
    }

    private Aabb Around(in Double3 center, in Double3 half)
    {
        double rounding = DoubleSlack * (_offset + _radius) + TouchSlack * _radius;
        double x = half.X + FloatSlack * (Math.Abs(center.X) + half.X) + rounding;
        double y = half.Y + FloatSlack * (Math.Abs(center.Y) + half.Y) + rounding;
        double z = half.Z + FloatSlack * (Math.Abs(center.Z) + half.Z) + rounding;
        return new Aabb(
            Clamped(center.X - x), Clamped(center.Y - y), Clamped(center.Z - z),
            Clamped(center.X + x), Clamped(center.Y + y), Clamped(center.Z + z));
    }

    /// <summary>Clamps to finite floats. All positions are finite, so nothing is met beyond.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Clamped(double x) =>
        x > float.MaxValue ? float.MaxValue : x < -float.MaxValue ? -float.MaxValue : (float)x;
}
