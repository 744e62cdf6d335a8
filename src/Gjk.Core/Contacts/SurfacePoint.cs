namespace Gjk.Core;

/// <summary>A point of a shape's surface over a place in the contact plane: how far the shape reaches there towards the
/// other one, and the direction in which its surface looks there.</summary>
/// <remarks>A margin is added across the surface, not along the contact normal: over a face that is tilted by t the
/// surface lies margin / cos t above the core, and round an edge it is a cylinder, at its ends balls. The direction
/// lets a support of the shape prove that nothing of it reaches further (<see cref="ContactProof"/>).</remarks>
internal readonly struct SurfacePoint(double height, double normalU, double normalV, double normalHeight)
{
    /// <summary>Ratio to the edge's length: at a cone's tip, which is as thin as this, a place is on the line that is
    /// shown. Above the rounding of two poses, below what a surface may be off. Pinned by AlongEdgeTests.</summary>
    private const double AtTip = 4e-7;

    /// <summary>Along the contact normal, towards the other shape.</summary>
    public readonly double Height = height;

    /// <summary>Outward, of unit length: along the plane's axes, and along the contact normal.</summary>
    public readonly double NormalU = normalU, NormalV = normalV, NormalHeight = normalHeight;

    /// <summary>Over a place near an edge of the core: part of a cylinder of the margin's radius about it, or of a ball
    /// at an end. Where the edge is a line of a round side, that side takes its place: as a cylinder or a cone about
    /// its axis, it is met where a line along the contact normal meets it.</summary>
    /// <param name="p">The edge's first end.</param>
    /// <param name="q">Its other end.</param>
    /// <param name="u">The place.</param>
    /// <param name="v">Its other coordinate.</param>
    /// <param name="margin">What the core is widened by.</param>
    /// <param name="radiusP">How far the side's axis is from the first end, across the side; 0 for sharp edges.</param>
    /// <param name="radiusQ">The same of the other end.</param>
    /// <returns>A height that is NaN where the place lies too far beside the edge.</returns>
    public static SurfacePoint OfEdge(
        in FlatCorner p, in FlatCorner q, double u, double v, double margin, double radiusP, double radiusQ)
    {
        double edgeU = q.U - p.U, edgeV = q.V - p.V, length = Math.Sqrt(edgeU * edgeU + edgeV * edgeV);
        double alongU = edgeU / length, alongV = edgeV / length;
        double along = alongU * (u - p.U) + alongV * (v - p.V), across = alongU * (v - p.V) - alongV * (u - p.U);
        double rise = (q.Height - p.Height) / length, secant = Math.Sqrt(1 + rise * rise);

        // In the frame of the widened edge, along it, across it and up, the contact normal is (lean, 0, upright).
        double upright = 1 / secant, lean = rise * upright, edgeLength = length * secant;
        double taper = (radiusQ - radiusP) / edgeLength, foot = along * secant + margin * rise;
        double radius = radiusP + taper * foot + margin, drop = 0;
        if (!(radius > 0) || (radius < 4 * Math.Abs(across) && Math.Abs(across) <= AtTip * edgeLength)) across = 0;
        if (across != 0)
        {
            double straight = radius * upright, bend = upright * (upright * (taper * taper - 1) - 2 * taper * lean);
            drop = across * across / (straight + Math.Sqrt(straight * straight + bend * across * across));
        }

        double up = -drop * upright, normalUp = radius - taper * drop * lean + up * (1 - taper * taper);
        foot -= drop * lean + up * taper;
        if (!(foot < 0 || foot > edgeLength) || margin == 0)
        {
            double normalFoot = taper * up;
            double size = 1 / Math.Sqrt(normalFoot * normalFoot + across * across + normalUp * normalUp);
            if (!(radius > 0)) (normalUp, size) = (1, 1);
            return Make(
                p.Height + rise * along + margin * secant - drop, (normalFoot * upright - normalUp * lean) * size,
                across * size, (normalFoot * lean + normalUp * upright) * size);
        }

        // Over an end it is that of a ball, at the end's own place in its middle.
        double sideRadius = foot < 0 ? radiusP : radiusQ, side = across / (margin + sideRadius);
        double back = (foot < 0 ? along : along - length) / margin;
        double sunk = sideRadius * (Math.Sqrt(1 - side * side) - 1);
        double height = Math.Sqrt(1 - side * side - back * back);
        return Make((foot < 0 ? p.Height : q.Height) + margin * height + sunk * secant, back, side, height);

        SurfacePoint Make(double heightHere, double normalAlong, double normalSide, double normalHeight) =>
            new(
                heightHere, alongU * normalAlong - alongV * normalSide, alongV * normalAlong + alongU * normalSide,
                normalHeight);
    }
}
