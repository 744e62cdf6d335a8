using System;

namespace Gjk.Core;

/// <summary>
/// A point of a shape's surface over a place in the contact plane: how far the shape reaches there towards the other
/// one, and the direction in which its surface looks there.
/// </summary>
/// <remarks>
/// A margin is added across the surface, not along the contact normal: over a face that is tilted by t the surface lies
/// margin / cos t above the core, and round an edge it is a cylinder, at its ends balls. The direction lets a support
/// of the shape prove that nothing of it reaches further (<see cref="ContactProof"/>).
/// </remarks>
internal readonly struct SurfacePoint
{
    /// <summary>Along the contact normal, towards the other shape.</summary>
    public readonly double Height;

    /// <summary>Outward, of unit length: along the plane's axes, and along the contact normal.</summary>
    public readonly double NormalU, NormalV, NormalHeight;

    public SurfacePoint(double height, double normalU, double normalV, double normalHeight)
    {
        Height = height;
        NormalU = normalU;
        NormalV = normalV;
        NormalHeight = normalHeight;
    }

    /// <summary>
    /// Over a place near an edge of the core: part of a cylinder of the margin's radius about it, or of a ball at an
    /// end. Where the edge is a line of a round side, that side's axis takes its place.
    /// </summary>
    /// <returns>A height that is NaN where the place lies too far beside the edge.</returns>
    public static SurfacePoint OfEdge(
        in FlatCorner p, in FlatCorner q, double u, double v, double margin, double sideRadius)
    {
        double edgeU = q.U - p.U, edgeV = q.V - p.V, length = Math.Sqrt(edgeU * edgeU + edgeV * edgeV);
        double alongU = edgeU / length, alongV = edgeV / length;
        double along = alongU * (u - p.U) + alongV * (v - p.V), across = alongU * (v - p.V) - alongV * (u - p.U);
        double rise = (q.Height - p.Height) / length, secant = Math.Sqrt(1 + rise * rise), radius = margin + sideRadius;

        // How the surface's normal leans: to the side, and of the rest by the edge's rise against its direction.
        double side = radius > 0 ? across / radius : 0, upright = Math.Sqrt(1 - side * side);
        double lean = -rise / secant, foot = along - (margin * upright + sideRadius * (upright - 1)) * lean;
        if ((foot >= 0 && foot <= length) || margin == 0)
        {
            return Make(
                p.Height + rise * along + (margin * upright + sideRadius * (upright - 1)) * secant, lean * upright,
                upright / secant);
        }

        // Over an end it is that of a ball, at the end's own place in its middle.
        double beyond = foot < 0 ? along : along - length, back = beyond / margin, drop = sideRadius * (upright - 1);
        double up = Math.Sqrt(1 - side * side - back * back);
        return Make((foot < 0 ? p.Height : q.Height) + margin * up + drop * secant, back, up);

        SurfacePoint Make(double height, double normalAlong, double normalHeight) =>
            new(height, alongU * normalAlong - alongV * side, alongV * normalAlong + alongU * side, normalHeight);
    }
}
