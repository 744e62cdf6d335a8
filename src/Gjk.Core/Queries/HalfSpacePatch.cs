namespace Gjk.Core;

/// <summary>What a half-space is to the contacts of one shape: the square of its plane that lies under all of
/// that.</summary>
/// <param name="normal">Of the plane, of unit length, in its own axes.</param>
/// <param name="size">The other's bounding radius; it lies within two of them about the foot of its deepest
/// point.</param>
internal readonly struct HalfSpacePatch(in Double3 normal, double size) : ISupportMap
{
    /// <summary>Ratio to the other's radius: half a side. Above 2, so that no corner of the square is ever shared; more
    /// changes no point.</summary>
    private const double Half = 4;

    private readonly Double3 _normal = normal;
    private readonly double _half = Half * size;

    public Double3 Center => default;

    public double Margin => 0;

    public double BoundingRadius => 2 * _half;

    public int Support(in Double3 direction, out Double3 point)
    {
        (Double3 u, Double3 v) = new PlaneBasis(_normal);
        point = u * (Double3.Dot(u, direction) < 0 ? -_half : _half)
            + v * (Double3.Dot(v, direction) < 0 ? -_half : _half);
        return -1;
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        (Double3 u, Double3 v) = new PlaneBasis(_normal);
        for (int i = 0; i < 4; i++)
            corners.Add(u * (i is 1 or 2 ? _half : -_half) + v * (i < 2 ? -_half : _half), i);
    }

    public bool TryGetVertex(int id, out Double3 point)
    {
        point = default;
        return false;
    }
}
