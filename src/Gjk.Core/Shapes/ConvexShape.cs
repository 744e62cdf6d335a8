namespace Gjk.Core;

/// <summary>Any of the library's shapes as one type, scaled, rounded and placed in any order: what a scene stores, and
/// the one closed instantiation of the queries that an ahead-of-time compiler needs.</summary>
/// <remarks>Immutable. Scales are multiplied in where the product is exact (points, segments, triangles, boxes,
/// ellipsoids); a mesh, cylinder, cone or tapered capsule, and a capsule scaled unevenly, keep their factors and apply
/// them to each support.</remarks>
public readonly partial struct ConvexShape
    : ISupportMap, IPlacedShape<ConvexShape>, IEquatable<ConvexShape>
{
    private readonly ShapeParts _parts;
    private readonly double _margin;

    /// <summary>Those of the core, in its own axes.</summary>
    private readonly Double3 _center;

    /// <inheritdoc cref="_center"/>
    private readonly double _boundingRadius;

    /// <summary>Whether the core's support is the shape's: not scaled, not placed.</summary>
    private readonly bool _isPlain;
    private readonly FormKind _core;

    internal ConvexShape(in ShapeParts parts)
    {
        _parts = parts;
        if (parts.Layer is not null)
        {
            _center = parts.Layer.Center;
            _margin = parts.Layer.Margin + parts.Rounding;
            _boundingRadius = parts.Layer.BoundingRadius + parts.Rounding;
            if (parts.Layer is not ScaledLayer)
            {
                // A user's radius may be generous, and tolerances follow that of this type.
                _parts.Placement = null;
                _boundingRadius = Math.Min(_boundingRadius, CoreExtent.Radius(ref this) + _margin);
                _parts.Placement = parts.Placement;
            }

            _core = parts.Placement is null ? FormKind.None : FormKind.Moved;
            return;
        }

        _parts.Curve = CurveOf(parts);
        _isPlain = parts.Scaling is null && parts.Placement is null;
        _core = parts.Scaling is not null ? FormKind.None
            : parts.Kind == ShapeKind.Box ? FormKind.Box
            : parts.Kind is ShapeKind.Segment or ShapeKind.Capsule or ShapeKind.Point or ShapeKind.Sphere
                ? FormKind.Segment
            : parts.Kind == ShapeKind.Triangle ? FormKind.Triangle
            : parts.Kind != ShapeKind.Mesh ? FormKind.None
            : parts.Hull!.IsExactBox ? FormKind.Box : FormKind.Hull;
        if (_parts.Curve is not null) _parts.InnerMargin = _parts.Curve.Margin;
        double margin = _parts.InnerMargin;
        _center = CoreCenter(_parts);
        _margin = margin + parts.Rounding;
        _boundingRadius = _parts.Curve is null ? CoreRadius(parts, _center) + margin : _parts.Curve.BoundingRadius;
        if (parts.Scaling is not null)
        {
            var scaling = new ShapeScale(parts.Scale, _center);
            _parts.Scaling = scaling;
            _center = scaling.Center;
            _margin = scaling.Axes.Margin(margin) + parts.Rounding;
            _boundingRadius = _boundingRadius * scaling.Axes.Largest + scaling.CenterError.Length;
            if (!scaling.Axes.KeepsBalls)
            {
                _parts.Placement = null;
                _boundingRadius = Math.Min(_boundingRadius, CoreExtent.Radius(ref this));
                _parts.Placement = parts.Placement;
            }
        }

        _boundingRadius += parts.Rounding;
        if (parts.Placement is not null) _core |= FormKind.Moved;
    }

    /// <summary>The same core, elsewhere.</summary>
    private ConvexShape(in ConvexShape core, Placement? placement)
    {
        this = core;
        _parts.Placement = placement;
        _isPlain = _parts.Layer is null && _parts.Scaling is null && placement is null;
        _core = core._core & ~FormKind.Moved | (placement is null ? FormKind.None : FormKind.Moved);
    }

    /// <summary>What the constructor was given.</summary>
    internal ShapeParts Parts => _parts;

    /// <summary>What this is, or was before it was rounded, placed or scaled.</summary>
    public ShapeKind Kind => _parts.Kind;

    /// <summary>The hull of a mesh, else null.</summary>
    public ConvexHull? Hull => _parts.Layer is null ? _parts.Hull : (_parts.Layer as ScaledLayer)?.Inner.Hull;

    /// <summary>The factors that are still applied to each support; 1 where the scale was multiplied in.</summary>
    public Vector3 Scale => (Vector3)_parts.Scale;

    /// <summary>True when the shape is rounded or placed, or was before it was scaled, so that <see cref="Kind"/>,
    /// <see cref="Hull"/> and <see cref="Scale"/> do not say all about it.</summary>
    public bool IsDecorated => _parts.Layer is not null || _parts.Placement is not null || _parts.Rounding > 0;

    /// <inheritdoc/>
    public Double3 Center => _parts.Placement is null ? _center : _parts.Placement.Center;

    /// <inheritdoc/>
    public double Margin => _margin;

    /// <summary>As <see cref="ISupportMap.BoundingRadius"/>; infinite for a half-space; NaN in a <c>default</c>
    /// struct, which no query accepts.</summary>
    public double BoundingRadius => _parts.Kind == ShapeKind.None ? double.NaN
        : _parts.Placement is null ? _boundingRadius
        : _parts.Placement.Radius(_boundingRadius, _margin);

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        if (_isPlain)
        {
            int id = CoreSupport(direction, out point);
            Double3.Write(point.X - _center.X, point.Y - _center.Y, point.Z - _center.Z, out point);
            return id;
        }

        if (_parts.Placement is not null) return PlacedSupport(direction, out point);
        return _parts.Layer is null
            ? ScaledSupport(direction, out point)
            : _parts.Layer.Support(direction, out point);
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        if (_isPlain)
        {
            bool found = CoreVertex(id, out point);
            Double3.Write(point.X - _center.X, point.Y - _center.Y, point.Z - _center.Z, out point);
            return found;
        }

        if (_parts.Placement is not null) return TryGetPlacedVertex(id, out point);
        return _parts.Layer is null
            ? TryGetScaledVertex(id, out point)
            : _parts.Layer.TryGetVertex(id, out point);
    }

    /// <summary>What a query may unwrap this to.</summary>
    internal FormKind Core => _core;

    /// <summary>The core's centre, in the core's axes.</summary>
    internal Double3 CenterInCore =>
        _parts.Placement is null ? _center : _parts.Placement.CenterInCore;

    /// <summary>The bounding radius about it.</summary>
    internal double RadiusOfCore => _boundingRadius;

    /// <summary>Where the core is in the shape's frame; null where the shape is not placed.</summary>
    internal Placement? Placement => _parts.Placement;

    Placement? IPlacedShape<ConvexShape>.Placement => _parts.Placement;

    ConvexShape IPlacedShape<ConvexShape>.InCoreAxes() => InCoreAxes();

    /// <inheritdoc cref="IPlacedShape{T}.InCoreAxes"/>
    private ConvexShape InCoreAxes() => _parts.Placement is null ? this : new ConvexShape(this, null);

    /// <summary>This, known to be a box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Get(out BoxCore box)
    {
        ConvexHull? hull = _parts.Hull;
        if (hull is null) BoxCore.Make(_parts.A, _center, BoxCorners.Plain, _boundingRadius, _margin, out box);
        else BoxCore.Make(hull.Cells.Stretch, _center, hull.Cells.Corners, _boundingRadius, _margin, out box);
    }

    /// <summary>This, known to be a mesh.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Get(out HullCore hull) => hull = new HullCore(_parts.Hull!, _boundingRadius, _margin);

    /// <summary>This, known to be a segment, a capsule, a point or a sphere.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Get(out SegmentCore segment)
    {
        int count = _parts.Kind is ShapeKind.Segment or ShapeKind.Capsule ? 2 : 1;
        SegmentCore.Make(_parts.A, _parts.B, count, _center, _boundingRadius, _margin, out segment);
    }

    /// <summary>This, known to be a triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Get(out TriangleCore triangle) => TriangleCore.Make(
        _parts.A, _parts.B, _parts.C, _center, _boundingRadius, _margin, out triangle);

    /// <summary>This, known to be a half-space.</summary>
    internal HalfSpaceCore AsHalfSpace => new(_parts.A, _parts.C, _parts.B);

    /// <summary>The half-space on the other side of a half-space's plane.</summary>
    internal ConvexShape Complement => Make(AsHalfSpace.Complement);

    private static Double3 CoreCenter(in ShapeParts parts) => parts.Kind switch
    {
        ShapeKind.Segment or ShapeKind.Capsule => (parts.A + parts.B) * 0.5,
        ShapeKind.Triangle => TriangleShape.Centroid(parts.A, parts.B, parts.C),
        ShapeKind.Mesh => parts.Hull!.Center,
        _ => parts.Curve is null ? default : parts.Curve.Center,
    };

    private static double CoreRadius(in ShapeParts parts, in Double3 center) => parts.Kind switch
    {
        ShapeKind.Segment or ShapeKind.Capsule => (parts.B - parts.A).Length * 0.5,
        ShapeKind.Triangle => TriangleShape.RadiusAbout(center, parts.A, parts.B, parts.C),
        ShapeKind.Box => parts.A.Length,
        ShapeKind.Mesh => parts.Hull!.BoundingRadius,
        ShapeKind.HalfSpace => double.PositiveInfinity,
        _ => 0,
    };

    /// <summary>The support of the core before the scale, in the local frame.</summary>
    private int CoreSupport(in Double3 direction, out Double3 point) => _parts.Kind switch
    {
        ShapeKind.Mesh => HullSupport.Find(_parts.Hull!.Cells, direction, out point),
        ShapeKind.Box => BoxSupport.Furthest(_parts.A, direction, out point),
        ShapeKind.Point or ShapeKind.Sphere => PrimitiveSupport.Point(out point),
        ShapeKind.Segment or ShapeKind.Capsule => PrimitiveSupport.Segment(_parts.A, _parts.B, direction, out point),
        ShapeKind.Triangle => PrimitiveSupport.Triangle(_parts.A, _parts.B, _parts.C, direction, out point),
        ShapeKind.TaperedCapsule => TaperedSupport(direction, out point),
        _ => _parts.Curve is null ? PrimitiveSupport.Nowhere(out point) : _parts.Curve.Support(direction, out point),
    };

    private bool CoreVertex(int id, out Double3 point) => _parts.Kind switch
    {
        ShapeKind.Mesh => _parts.Hull!.TryGetVertex(id, out point),
        ShapeKind.Box => BoxSupport.TryGetVertex(_parts.A, id, out point),
        ShapeKind.Point or ShapeKind.Sphere => PrimitiveSupport.Point(out point) == id,
        ShapeKind.Segment or ShapeKind.Capsule => PrimitiveSupport.Two(_parts.A, _parts.B, id, out point),
        ShapeKind.Triangle => PrimitiveSupport.Three(_parts.A, _parts.B, _parts.C, id, out point),
        ShapeKind.TaperedCapsule => TryGetTaperedVertex(id, out point),
        _ => PrimitiveSupport.NoVertex(out point),
    };

    /// <summary>The struct measures from its centre, which is not the local origin where one ball holds the
    /// other.</summary>
    private int TaperedSupport(in Double3 direction, out Double3 point)
    {
        int id = _parts.Curve!.Support(direction, out point);
        point += _parts.Curve.Center;
        return id;
    }

    private bool TryGetTaperedVertex(int id, out Double3 point)
    {
        bool found = _parts.Curve!.TryGetVertex(id, out point);
        point += _parts.Curve.Center;
        return found;
    }
}
