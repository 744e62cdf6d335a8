namespace Gjk.Core.Tests.Support;

/// <summary>A shape that counts how often it is asked for a support point; everything else is the shape's
/// own.</summary>
internal readonly struct SupportCounter(ConvexShape shape, int[] calls) : ISupportMap
{
    public Double3 Center => shape.Center;

    public double Margin => shape.Margin;

    public double BoundingRadius => shape.BoundingRadius;

    public int Support(in Double3 direction, out Double3 point)
    {
        calls[0]++;
        return shape.Support(direction, out point);
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    public bool TryGetVertex(int id, out Double3 point) => shape.TryGetVertex(id, out point);
}
