namespace Gjk.Core;

/// <summary>What a ray met, before anything is rounded.</summary>
internal struct RayMeeting
{
    /// <summary>Hit, Miss, OverlappingAtStart or why there is no answer.</summary>
    public CastStatus Status;

    /// <summary>Whether the origin is so near the surface that whether the shape holds it decides the answer: Hit or
    /// Miss where it does not.</summary>
    public bool IsAtSurface;

    /// <summary>Along the ray from its origin, in world units.</summary>
    public double Distance;

    /// <summary>The shape's outward normal, of unit length, and the point of the ray, in the world.</summary>
    public Double3 Normal, Point;

    /// <summary>Support calls made.</summary>
    public int Iterations;
}
