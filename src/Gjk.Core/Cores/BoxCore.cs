namespace Gjk.Core;

/// <summary>Any of the library's shapes that is a box, with or without a margin: a box, or a mesh whose vertices are
/// the eight corners of its bounds.</summary>
internal struct BoxCore : ISupportMap, IPlainBody
{
    /// <summary>Half the side lengths: in double, since a scale may have been multiplied into them.</summary>
    public LaneVector Half;

    /// <summary>The ids of the corners.</summary>
    public BoxCorners Corners;

    private Double3 _center;
    private double _margin, _radius;

    /// <summary>Written where it is to be, without a copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make(
        in Double3 half, in Double3 center, BoxCorners corners, double radius, double margin, out BoxCore box)
    {
        Double3.Write(half.X, half.Y, half.Z, out box.Half.Xyz);
        box.Half.End = 0;
        Double3.Write(center.X, center.Y, center.Z, out box._center);
        box.Corners = corners;
        box._margin = margin;
        box._radius = radius;
    }

    public readonly Double3 Center => _center;

    public readonly double Margin => _margin;

    public readonly double BoundingRadius => _radius;

    readonly object ILibraryShape.MakeTraits() => new PlainTraits<BoxCore>();

    public readonly bool TryGetForm(out ShapeForm form) => ShapeForm.Of(FormKind.Box, Half.Xyz, out form);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly FormKind GetPlain(out Double3 size)
    {
        size = Half.Xyz;
        return FormKind.Box;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int Support(in Double3 direction, out Double3 point) =>
        Corners.Id(BoxSupport.Furthest(Half.Xyz, direction, out point));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool TryGetVertex(int id, out Double3 point)
    {
        BoxSupport.TryGetVertex(Half.Xyz, Corners.Signs(id & 7), out point);
        return (uint)id < 8u;
    }

    /// <summary>The face in a direction; its corners are numbered by their signs.</summary>
    public readonly void GetFace(in Double3 direction, ref FaceCorners corners) =>
        BoxSupport.Face(Half.Xyz, direction, ref corners);
}
