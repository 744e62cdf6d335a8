namespace Gjk.Core.Tests.Support;

/// <summary>A support function from outside, to be wrong in ways of every kind.</summary>
internal readonly struct BrokenShape(
    Func<Double3, Double3> support, double margin = 0, double radius = 2, Double3 center = default) : ISupportMap
{
    /// <summary>Its support has no number.</summary>
    public static BrokenShape OfNaN => new(_ => new Double3(double.NaN, 0, 0));

    public Double3 Center => center;
    public double Margin => margin;
    public double BoundingRadius => radius;
    public int Support(in Double3 d, out Double3 point)
    {
        point = support(d);
        return -1;
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    public bool TryGetVertex(int id, out Double3 point)
    {
        point = default;
        return false;
    }
}
