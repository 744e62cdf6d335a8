namespace Gjk.Core;

/// <summary>A plane out of which a contact keeps or pushes another body.</summary>
internal readonly struct OpenPlane(in Double3 foot, in Double3 normal, double depth)
{
    public readonly Double3 Foot = foot, Normal = normal;

    /// <summary>How far the other body is behind it; 0 where it is not.</summary>
    public readonly double Depth = depth;
}
