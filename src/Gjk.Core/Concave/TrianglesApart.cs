namespace Gjk.Core;

/// <summary>Proves of two meshes' triangles that they do not touch, nor does a cast bring them together: the plane of
/// one of them leaves a gap all the way.</summary>
/// <remarks>Where waves slide along their ruling, each triangle passes many others within float's rounding, so that
/// neither boxes nor one plane for all rule them out; a cast costs some fifty times as much as this. All corners are
/// measured in double, in A's axes.</remarks>
internal readonly struct TrianglesApart
{
    private readonly TriangleMesh? _a, _b;
    private readonly RotationD _rotation;
    private readonly Double3 _between, _way;
    private readonly double _rounding;

    /// <param name="a">The first side, at the start.</param>
    /// <param name="b">The second side.</param>
    /// <param name="frame">Theirs.</param>
    /// <param name="way">B's motion relative to A, in the world, for the fraction 1.</param>
    public TrianglesApart(PartSide a, PartSide b, in TreeFrame frame, in Double3 way)
    {
        (_a, _b, _rotation) = (a.Mesh, b.Mesh, frame.Rotation);
        Double3 between = (Double3)b.Pose.Position - a.Pose.Position;
        (_between, _way) = (frame.RotationA.InverseRotate(between), frame.RotationA.InverseRotate(way));
        double lengths = between.SumOfMagnitudes + PlaneProof.LengthsOf(a) + PlaneProof.LengthsOf(b);
        _rounding = 2 * PlaneProof.Error * lengths;
    }

    /// <summary>Whether two triangles stay apart up to a fraction.</summary>
    public bool StayApart(int triangleA, int triangleB, double most)
    {
        if (_a is null || _b is null) return false;
        _a.GetCorners(triangleA, out Double3 origin, out Double3 a1, out Double3 a2);
        _b.GetCorners(triangleB, out Double3 b0, out Double3 b1, out Double3 b2);
        Double3 between = _between - origin, way = _way * most;
        (a1, a2, b0) = (a1 - origin, a2 - origin, _rotation.Rotate(b0) + between);
        (b1, b2) = (_rotation.Rotate(b1) + between, _rotation.Rotate(b2) + between);
        Double3 e1 = b1 - b0, e2 = b2 - b0;
        double sizes = a1.SumOfMagnitudes + a2.SumOfMagnitudes + e1.SumOfMagnitudes + e2.SumOfMagnitudes;
        double room = _rounding + PlaneProof.TriangleRoom * (sizes + way.SumOfMagnitudes);
        return IsGap(Double3.Cross(a1, a2)) || IsGap(Double3.Cross(e1, e2));

        bool IsGap(in Double3 normal)
        {
            double u = Double3.Dot(normal, a1), v = Double3.Dot(normal, a2), closing = Double3.Dot(normal, way);
            double x = Double3.Dot(normal, b0), y = Double3.Dot(normal, b1), z = Double3.Dot(normal, b2);
            double above = Math.Min(Math.Min(x, y), z) - Math.Max(Math.Max(u, v), 0) + Math.Min(closing, 0);
            double below = Math.Min(Math.Min(u, v), 0) - Math.Max(Math.Max(x, y), z) - Math.Max(closing, 0);
            return Math.Max(above, below) > room * normal.SumOfMagnitudes;
        }
    }
}
