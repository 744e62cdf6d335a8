namespace Gjk.Core;

/// <summary>A plane n·x = value that has the whole Minkowski difference on its far side, as a support point proves:
/// value / |n| is a lower bound of the distance of the cores.</summary>
internal struct SupportPlane
{
    /// <summary>From the origin to the plane, of any length.</summary>
    public Double3 Normal;

    /// <summary>|Normal|²; 0 where no plane is known.</summary>
    public double NormalSquared;

    /// <summary>Normal · x on the plane.</summary>
    public double Value;

    /// <summary>The plane across a feature's normal.</summary>
    public void Set(in ClosestFeature feature, double value)
    {
        Value = value;
        Double3.Write(feature.Normal.X, feature.Normal.Y, feature.Normal.Z, out Normal);
        NormalSquared = feature.NormalSquared;
    }

    /// <summary>The plane's distance from the origin, negative where the origin is beyond it.</summary>
    public readonly double Distance => Value / Math.Sqrt(NormalSquared);
}
