using System.Numerics;

namespace Gjk.Core;

/// <summary>A ray in the world, as it was asked for.</summary>
internal readonly struct WorldRay
{
    /// <summary>Where it begins.</summary>
    public readonly Vector3 Origin;

    /// <summary>Of any length but 0.</summary>
    public readonly Double3 Direction;

    /// <summary>The direction's length, and how far the ray reaches, in world units; at least 0.</summary>
    public readonly double Length, Reach;

    public WorldRay(Vector3 origin, in Double3 direction, double length, double reach)
    {
        Origin = origin;
        Direction = direction;
        Length = length;
        Reach = reach;
    }

    /// <summary>The point at a distance.</summary>
    public Double3 At(double distance) => Direction * (distance / Length) + Origin;
}
