using System.Globalization;
using System.Text;

namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    /// <summary>True when both are made of the same numbers in the same way; meshes must share their hull.</summary>
    public bool Equals(ConvexShape other)
    {
        ref readonly ShapeParts a = ref _parts, b = ref other._parts;
        return a.Kind == b.Kind && a.A == b.A && a.B == b.B && a.C == b.C && a.Scale == b.Scale
            && a.InnerMargin == b.InnerMargin && a.Rounding == b.Rounding && ReferenceEquals(a.Hull, b.Hull)
            && ScaledLayer.AreEqual(a.Layer, b.Layer) && Placement.AreEqual(a.Placement, b.Placement);
    }

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is ConvexShape other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() =>
        ((_margin.GetHashCode() * 397 ^ _boundingRadius.GetHashCode()) * 397 ^ _center.GetHashCode()) * 397 ^ (int)Kind;

    /// <summary>Equality, as <see cref="Equals(ConvexShape)"/> has it.</summary>
    public static bool operator ==(in ConvexShape a, in ConvexShape b) => a.Equals(b);

    /// <summary>The opposite of equality.</summary>
    public static bool operator !=(in ConvexShape a, in ConvexShape b) => !a.Equals(b);

    /// <summary>The kind and its numbers, for people to read. <see cref="QueryRecord"/> writes a text that can be read
    /// back.</summary>
    public override string ToString()
    {
        ref readonly ShapeParts p = ref _parts;
        var text = new StringBuilder(
            p.Layer is ScaledLayer scaled ? scaled.Inner + " scaled by " + Text(scaled.Factors) : CoreText(p));
        if (p.Scaling is not null)
            text.Append(" scaled by ").Append(Text(p.Scale));
        if (p.Rounding > 0) text.Append(" rounded by ").Append(Text(p.Rounding));
        AppendPoses(text, p.Placement);
        return text.ToString();
    }

    private static void AppendPoses(StringBuilder text, Placement? placement)
    {
        if (placement is null) return;
        AppendPoses(text, placement.Before);
        text.Append(" placed at ").Append(placement.Pose);
    }

    private static string CoreText(in ShapeParts p) => p.Kind switch
    {
        ShapeKind.None => "no shape",
        ShapeKind.Point => "point",
        ShapeKind.Sphere => $"sphere, radius {Text(p.InnerMargin)}",
        ShapeKind.Segment => $"segment {Text(p.A)} {Text(p.B)}",
        ShapeKind.Capsule => $"capsule {Text(p.A)} {Text(p.B)}, radius {Text(p.InnerMargin)}",
        ShapeKind.Triangle => $"triangle {Text(p.A)} {Text(p.B)} {Text(p.C)}",
        ShapeKind.Box => $"box, half extents {Text(p.A)}",
        ShapeKind.Ellipsoid => $"ellipsoid, radii {Text(p.A)}",
        ShapeKind.Mesh => $"mesh of {p.Hull!.VertexCount} vertices",
        ShapeKind.Cylinder => $"cylinder, radius {Text(p.A.X)}, half height {Text(p.A.Y)}",
        ShapeKind.Cone => $"cone, radius {Text(p.A.X)}, half height {Text(p.A.Y)}",
        ShapeKind.TaperedCapsule =>
            $"tapered capsule, radii {Text(p.A.X)} and {Text(p.A.Y)}, half height {Text(p.A.Z)}",
        ShapeKind.HalfSpace => $"half-space, normal {Text(p.A)}, offset {Text(p.B.X)}",
        ShapeKind.Custom => $"custom shape, {p.Layer}",
        _ => $"{p.Kind.ToString().ToLowerInvariant()} {Text(p.A)}",
    };

    private static string Text(double number) => number.ToString("G9", CultureInfo.InvariantCulture);

    private static string Text(in Double3 v) => $"<{Text(v.X)}, {Text(v.Y)}, {Text(v.Z)}>";
}
