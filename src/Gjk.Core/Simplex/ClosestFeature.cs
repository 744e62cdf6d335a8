namespace Gjk.Core;

/// <summary>The vertex, edge or face of a simplex that is nearest the origin, as the plane through it that is
/// perpendicular to the way there. A feature's distance is Height / |Normal|; nothing is divided or
/// normalised.</summary>
internal struct ClosestFeature
{
    /// <summary>From the origin towards the feature and perpendicular to it, of any length.</summary>
    public Double3 Normal;

    /// <summary>Normal · x for every x of the feature: at least 0.</summary>
    public double Height;

    /// <summary>|Normal|².</summary>
    public double NormalSquared;

    /// <summary>The squared distance of the feature from the origin.</summary>
    public readonly double DistanceSquared => Height * Height / NormalSquared;
}
