using System;
using System.Collections.Generic;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// Any of the library's shapes, scaled or not, as one type: what a scene stores, and the one closed instantiation of the
/// queries that an ahead-of-time compiler needs.
/// </summary>
/// <remarks>
/// Immutable. Scales are multiplied in where the product is exact (points, boxes, ellipsoids); a mesh, cylinder, cone or a capsule
/// scaled unevenly keeps its factors and applies them to each support.
/// </remarks>
public readonly struct ConvexShape : ISupportMap
{
    private readonly ConvexHull? _hull;
    private readonly Vector3D _a, _b, _c;
    private readonly AxisScale _scale;
    private readonly double _innerMargin;
    private readonly double _margin;
    private readonly Vector3D _center;
    private readonly double _boundingRadius;
    private readonly ShapeKind _kind;
    private readonly bool _plain;

    private ConvexShape(ShapeKind kind, in Vector3D a, in Vector3D b, in Vector3D c, double innerMargin, ConvexHull? hull, in AxisScale scale)
    {
        _kind = kind;
        _a = a;
        _b = b;
        _c = c;
        _hull = hull;
        _scale = scale;
        _innerMargin = innerMargin;
        _margin = scale.Margin(innerMargin);
        _plain = scale.Factors == new Vector3D(1, 1, 1);
        Vector3D center = CoreCenter(kind, a, b, c, hull);
        _center = Vector3D.Multiply(scale.Factors, center);
        _boundingRadius = (CoreRadius(kind, a, b, c, center, hull) + innerMargin) * scale.Largest;
        if (!scale.KeepsBalls) _boundingRadius = Math.Min(_boundingRadius, CoreExtent.RadiusAbout(_center, ref this));
    }

    internal ConvexShape(in ShapeParts parts)
        : this(parts.Kind, parts.A, parts.B, parts.C, parts.InnerMargin, parts.Hull, new AxisScale(parts.Scale))
    {
    }

    /// <summary>What the private constructor was given.</summary>
    internal ShapeParts Parts => new() { Kind = _kind, A = _a, B = _b, C = _c, InnerMargin = _innerMargin, Hull = _hull, Scale = _scale.Factors };

    /// <summary>What this is.</summary>
    public ShapeKind Kind => _kind;

    /// <summary>The hull of a mesh, else null.</summary>
    public ConvexHull? Hull => _hull;

    /// <summary>The factors that are still applied to each support; 1 where the scale was multiplied in.</summary>
    public Vector3 Scale => (Vector3)_scale.Factors;

    /// <inheritdoc/>
    public Vector3D Center => _center;

    /// <inheritdoc/>
    public double Margin => _margin;

    /// <summary>As <see cref="ISupportMap.BoundingRadius"/>; NaN in a <c>default</c> struct, which no query accepts.</summary>
    public double BoundingRadius => _kind == ShapeKind.None ? double.NaN : _boundingRadius;

    private static AxisScale One => new(new Vector3D(1, 1, 1));

    /// <summary>The local origin.</summary>
    public static ConvexShape Point() => new(ShapeKind.Point, default, default, default, 0, null, One);

    /// <summary>A segment between two points.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is NaN or infinite.</exception>
    public static ConvexShape Segment(Vector3 a, Vector3 b) =>
        new(ShapeKind.Segment, Guard.Finite(a, nameof(a)), Guard.Finite(b, nameof(b)), default, 0, null, One);

    /// <summary>A triangle.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is NaN or infinite.</exception>
    public static ConvexShape Triangle(Vector3 a, Vector3 b, Vector3 c) =>
        new(ShapeKind.Triangle, Guard.Finite(a, nameof(a)), Guard.Finite(b, nameof(b)), Guard.Finite(c, nameof(c)), 0, null, One);

    /// <summary>A sphere about the local origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative, NaN or infinite.</exception>
    public static ConvexShape Sphere(float radius) =>
        new(ShapeKind.Point, default, default, default, Guard.NonNegative(radius, nameof(radius)), null, One);

    /// <summary>A capsule along the local y axis; the half height does not include the caps.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape Capsule(float radius, float halfHeight) =>
        new(ShapeKind.Segment, new Vector3D(0, Guard.NonNegative(halfHeight, nameof(halfHeight)), 0), new Vector3D(0, -(double)halfHeight, 0), default,
            Guard.NonNegative(radius, nameof(radius)), null, One);

    /// <summary>A box about the local origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A half extent is negative, NaN or infinite.</exception>
    public static ConvexShape Box(Vector3 halfExtents) =>
        new(ShapeKind.Box, Guard.NonNegative(halfExtents, nameof(halfExtents)), default, default, 0, null, One);

    /// <summary>A cylinder about the local y axis.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape Cylinder(float radius, float halfHeight) =>
        new(ShapeKind.Cylinder, RadiusAndHeight(radius, halfHeight), default, default, 0, null, One);

    /// <summary>A cone about the local y axis, its apex at +halfHeight.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape Cone(float radius, float halfHeight) =>
        new(ShapeKind.Cone, RadiusAndHeight(radius, halfHeight), default, default, 0, null, One);

    /// <summary>An ellipsoid about the local origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A radius is negative, NaN or infinite.</exception>
    public static ConvexShape Ellipsoid(Vector3 radii) =>
        new(ShapeKind.Ellipsoid, Guard.NonNegative(radii, nameof(radii)), default, default, 0, null, One);

    /// <summary>A convex mesh from a hull that was built before.</summary>
    /// <exception cref="ArgumentNullException">The hull is null.</exception>
    public static ConvexShape Mesh(ConvexHull hull) =>
        new(ShapeKind.Mesh, default, default, default, 0, Guard.NotNull(hull, nameof(hull)), One);

    /// <summary>A convex mesh; builds the hull of the vertices.</summary>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The list is empty, or a coordinate is NaN or infinite.</exception>
    public static ConvexShape Mesh(IReadOnlyList<Vector3> vertices) => Mesh(new ConvexHull(vertices));

    /// <summary>The same shape with another scale; the factors replace those of an earlier call where these were kept, and multiply them elsewhere.</summary>
    /// <param name="scale">Along the local axes; negative factors mirror.</param>
    /// <exception cref="ArgumentOutOfRangeException">A factor is 0, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">This is a <c>default</c> struct, or it is scaled already.</exception>
    public ConvexShape Scaled(Vector3 scale)
    {
        var factors = new AxisScale(Guard.Scale(scale, nameof(scale)));
        if (_kind == ShapeKind.None) throw new InvalidOperationException("A default ConvexShape cannot be scaled.");
        if (!_plain) throw new InvalidOperationException("The shape is scaled already; multiply the factors and scale the original.");
        if (_kind == ShapeKind.Point && !factors.KeepsBalls)
        {
            return new(ShapeKind.Ellipsoid, new Vector3D(_innerMargin * Math.Abs(factors.Factors.X), _innerMargin * Math.Abs(factors.Factors.Y), _innerMargin * Math.Abs(factors.Factors.Z)),
                default, default, 0, null, One);
        }

        bool multiplied = _kind is ShapeKind.Point or ShapeKind.Segment or ShapeKind.Triangle or ShapeKind.Box or ShapeKind.Ellipsoid
            && (_innerMargin == 0 || factors.KeepsBalls);
        if (!multiplied) return new(_kind, _a, _b, _c, _innerMargin, _hull, factors);

        Vector3D f = factors.Factors;
        if (_kind is ShapeKind.Box or ShapeKind.Ellipsoid) f = new Vector3D(Math.Abs(f.X), Math.Abs(f.Y), Math.Abs(f.Z));
        return new(_kind, Vector3D.Multiply(f, _a), Vector3D.Multiply(f, _b), Vector3D.Multiply(f, _c), factors.Margin(_innerMargin), null, One);
    }

    /// <inheritdoc/>
    public int Support(in Vector3D direction, int hint, out Vector3D point)
    {
        if (_plain) return CoreSupport(direction, out point);
        Vector3D inward = _scale.Inward(direction);
        int id = CoreSupport(inward, out point);
        return _scale.Outward(id, _innerMargin, inward, ref point);
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Vector3D point)
    {
        if (!_plain && _innerMargin > 0 && !_scale.KeepsBalls)
        {
            point = default;
            return false;
        }

        bool found = CoreVertex(id, out point);
        if (!_plain) point = Vector3D.Multiply(_scale.Factors, point);
        return found;
    }

    /// <summary>The mesh that this is, when it is one and not scaled.</summary>
    internal bool TryGetMesh(out ConvexMesh mesh)
    {
        bool isMesh = _kind == ShapeKind.Mesh && _plain;
        mesh = isMesh ? new ConvexMesh(_hull!) : default;
        return isMesh;
    }

    /// <summary>The box that this is, when it is one.</summary>
    internal bool TryGetBox(out BoxCore box)
    {
        bool isBox = _kind == ShapeKind.Box && _plain;
        box = isBox ? new BoxCore(_a, _boundingRadius) : default;
        return isBox;
    }

    private static Vector3D RadiusAndHeight(float radius, float halfHeight) =>
        new(Guard.NonNegative(radius, nameof(radius)), Guard.NonNegative(halfHeight, nameof(halfHeight)), 0);

    private static Vector3D CoreCenter(ShapeKind kind, in Vector3D a, in Vector3D b, in Vector3D c, ConvexHull? hull) => kind switch
    {
        ShapeKind.Segment => (a + b) * 0.5,
        ShapeKind.Triangle => TriangleShape.Centroid(a, b, c),
        ShapeKind.Mesh => hull!.Center,
        _ => default,
    };

    private static double CoreRadius(ShapeKind kind, in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D center, ConvexHull? hull) => kind switch
    {
        ShapeKind.Segment => (b - a).Length * 0.5,
        ShapeKind.Triangle => TriangleShape.RadiusAbout(center, a, b, c),
        ShapeKind.Box or ShapeKind.Cylinder or ShapeKind.Cone => a.Length,
        ShapeKind.Ellipsoid => Math.Max(Math.Max(a.X, a.Y), a.Z),
        ShapeKind.Mesh => hull!.BoundingRadius,
        _ => 0,
    };

    private int CoreSupport(in Vector3D direction, out Vector3D point)
    {
        switch (_kind)
        {
            case ShapeKind.Mesh:
                return HullSupport.Find(_hull!, direction, out point);
            case ShapeKind.Box:
                return PrimitiveSupport.Box(_a, direction, out point);
            case ShapeKind.Point:
                point = default;
                return 0;
            case ShapeKind.Segment:
                return PrimitiveSupport.Segment(_a, _b, direction, out point);
            case ShapeKind.Triangle:
                return PrimitiveSupport.Triangle(_a, _b, _c, direction, out point);
            case ShapeKind.Cylinder:
                point = PrimitiveSupport.Cylinder(_a.X, _a.Y, direction);
                return -1;
            case ShapeKind.Cone:
                point = PrimitiveSupport.Cone(_a.X, _a.Y, direction);
                return -1;
            case ShapeKind.Ellipsoid:
                point = PrimitiveSupport.Ellipsoid(_a, direction);
                return -1;
            default:
                point = new Vector3D(double.NaN, double.NaN, double.NaN);
                return -1;
        }
    }

    private bool CoreVertex(int id, out Vector3D point)
    {
        switch (_kind)
        {
            case ShapeKind.Mesh when (uint)id < (uint)_hull!.VertexCount:
                _hull.GetVertex(id, out point);
                return true;
            case ShapeKind.Box:
                return PrimitiveSupport.TryBoxVertex(_a, id, out point);
            case ShapeKind.Point:
                point = default;
                return id == 0;
            case ShapeKind.Segment:
                return PrimitiveSupport.Two(_a, _b, id, out point);
            case ShapeKind.Triangle:
                point = id == 0 ? _a : id == 1 ? _b : _c;
                return (uint)id < 3u;
            default:
                point = default;
                return false;
        }
    }
}
