namespace Gjk.Core;

/// <summary>A ray in the world, as it was asked for.</summary>
internal readonly struct WorldRay(
    in Double3 origin, in Double3 direction, double length, double reach, double ball = 0)
{
    /// <summary>Where it begins.</summary>
    public readonly Double3 Origin = origin;

    /// <summary>Of any length but 0.</summary>
    public readonly Double3 Direction = direction;

    /// <summary>The direction's length, and how far the ray reaches, in world units; at least 0.</summary>
    public readonly double Length = length, Reach = reach;

    /// <summary>Of a way back, whose origin is no float: the radius of a ball about the shape's centre that it begins
    /// outside of and that holds what it crosses of the shape; else 0.</summary>
    public readonly double Ball = ball;

    /// <summary>The point at a distance.</summary>
    public Double3 At(double distance) => Direction * (distance / Length) + Origin;
}
