namespace Gjk.Core;

/// <summary>Which sides of a shape a ray meets. The values combine.</summary>
[Flags]
public enum RaySides : byte
{
    /// <summary>The default: triangles are met from both sides, and shapes are solid. A ray that begins inside answers
    /// <see cref="CastStatus.OverlappingAtStart"/> at once.</summary>
    Both = 0,

    /// <summary>Back faces are passed, as if they were not there: those for which
    /// <see cref="RayCastResult.IsBackFace"/> would be true.</summary>
    FrontOnly = 1,

    /// <summary>Shapes are hollow: a ray that begins inside meets the surface from within. Of a convex shape that is
    /// the way out, as <c>ConvexQuery.RayExit</c> gives it, and of a solid mesh its triangles. With
    /// <see cref="FrontOnly"/>, a convex shape is not met from inside at all.</summary>
    Hollow = 2,
}

/// <summary>Whether a flag is set; <c>HasFlag</c> allocates on Mono.</summary>
internal static class RaySidesExtensions
{
    public static bool Has(this RaySides sides, RaySides flag) => (sides & flag) != 0;
}
