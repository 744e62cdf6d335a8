namespace Gjk.Core;

/// <summary>The bodies that a ray meets in closed form.</summary>
internal enum RayForm : byte
{
    /// <summary>None of these: the ray is cast as a point.</summary>
    None,

    /// <summary>A ball about the centre: its radius.</summary>
    Ball,

    /// <summary>A segment and a radius: its ends, measured from the centre.</summary>
    Capsule,

    /// <summary>A box about the centre: A, half its sides.</summary>
    Box,

    /// <summary>A cylinder about the y axis: A, the radius and half the height.</summary>
    Cylinder,

    /// <summary>A cone about the y axis, its apex at the top: A, the radius and half the height.</summary>
    Cone,

    /// <summary>An ellipsoid: A, its radii.</summary>
    Ellipsoid,

    /// <summary>A triangle: its corners, measured from the centre.</summary>
    Triangle,

    /// <summary>A hull with planes.</summary>
    Hull,

    /// <summary>A body of revolution that no ray meets in closed form, rounded before it was scaled unevenly: A, its
    /// axis.</summary>
    Swollen,
}
