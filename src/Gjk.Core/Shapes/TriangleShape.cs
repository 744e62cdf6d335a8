namespace Gjk.Core;

/// <summary>A triangle, filled; it may be degenerate (a segment or a point).</summary>
public readonly struct TriangleShape : ISupportMap, ILibraryShape
{
    /// <summary>The first corner.</summary>
    public readonly Vector3 A;

    /// <summary>The second corner.</summary>
    public readonly Vector3 B;

    /// <summary>The third corner.</summary>
    public readonly Vector3 C;

    private readonly Double3 _center;
    private readonly double _radius;

    /// <summary>Makes a triangle.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is NaN or infinite.</exception>
    public TriangleShape(Vector3 a, Vector3 b, Vector3 c)
    {
        A = Guard.Finite(a, nameof(a));
        B = Guard.Finite(b, nameof(b));
        C = Guard.Finite(c, nameof(c));
        _center = Centroid(A, B, C);
        _radius = RadiusAbout(_center, A, B, C);
    }

    /// <inheritdoc/>
    public Double3 Center => _center;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => _radius;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out TriangleCore triangle) => TriangleCore.Make(A, B, C, _center, _radius, 0, out triangle);

    object ILibraryShape.MakeTraits() => new LibraryTraits<TriangleShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Triangle(A, B, C, Center, out form);

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Support(in Double3 direction, out Double3 point)
    {
        double x = A.X, y = A.Y, z = A.Z;
        int id = TriangleCore.Furthest(B.X - x, B.Y - y, B.Z - z, C.X - x, C.Y - y, C.Z - z, direction);
        TryGetVertex(id, out point);
        return id;
    }

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        TriangleCore.Face(A - _center, B - _center, C - _center, direction, ref corners);

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryGetVertex(int id, out Double3 point)
    {
        ref readonly Vector3 corner = ref TriangleCore.Corner(A, id);
        Double3.Write(corner.X - _center.X, corner.Y - _center.Y, corner.Z - _center.Z, out point);
        return TriangleCore.HasVertex(id);
    }

    internal static Double3 Centroid(in Double3 a, in Double3 b, in Double3 c) => (a + b + c) * (1.0 / 3);

    internal static double RadiusAbout(in Double3 center, in Double3 a, in Double3 b, in Double3 c) =>
        Math.Sqrt(
            Math.Max(Math.Max((a - center).LengthSquared, (b - center).LengthSquared), (c - center).LengthSquared));
}
