namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Holds any answer for a moving pair to what a certificate without the library's solvers can prove.</summary>
internal static class CastProof
{
    /// <summary>Length, as a fraction of the scale or of the way, whichever is larger: how exact a fraction is along
    /// the motion. It holds its rounding to float, which is 6e-8 of the way.</summary>
    public const double Along = 1e-7;

    /// <summary>Length, as a fraction of the scale: a graze may be called either way where the shapes miss each other,
    /// or reach into each other, by no more.</summary>
    private const double Graze = 2 * Accuracy.FlagScale;

    /// <summary>Length, as a fraction of the scale: curved cores touch when they are within 1e-9 of it, and their
    /// points are then known to the root of that.</summary>
    private const double CurvedPoint = 5e-5;

    /// <summary>Length, as a fraction of the scale: from so far apart, along a direction that floats hold to 6e-8, the
    /// nearest feature's own direction is known to the root of a double's last place.</summary>
    private const double Step = 1e-4;

    /// <summary>A hit is a contact, with a proof that there is none before; of a miss, planes prove that there is none
    /// at all.</summary>
    public static string? Broken(FuzzPair pair) => Problem(pair, pair.Cast, 1);

    /// <summary>How an answer breaks the contract of a cast, or null.</summary>
    /// <param name="pair">The pair with its motion.</param>
    /// <param name="r">The answer.</param>
    /// <param name="most">The largest fraction that was asked for, at least 0.</param>
    public static string? Problem(FuzzPair pair, in CastResult r, float most)
    {
        switch (r.Status)
        {
            case CastStatus.Hit:
                return Touch(pair, r, most) ?? Normal(pair, r) ?? Point(pair, r);
            case CastStatus.OverlappingAtStart:
                return r.Fraction == 0 && r.Depth > 0
                    && Math.Abs(((Double3)r.Normal).Length - 1) <= Accuracy.UnitLength
                    ? Point(pair, r)
                    : Say.Line($"{r}, with the fraction {r.Fraction:R}");
            case CastStatus.Miss:
                // What only touches at the start may go on touching.
                if (pair.Answer.IsOverlapping) return WhatPassesGetsNoDeeper.Deeper(pair, most, 0);
                return r.Fraction == most && float.IsNaN(r.Point.X) && float.IsNaN(r.Normal.X)
                    ? Apart(pair, 0, most, pair.Answer.Normal, "a miss")
                    : Say.Line($"a miss with the fraction {r.Fraction:R}, {r.Point} and {r.Normal}");
            case CastStatus.IterationLimit when pair.IsCurved:
                return Apart(pair, 0, r.Fraction, pair.Answer.Normal, "apart up to there");
            default:
                return Say.Line($"{r.Status} after {r.Iterations} iterations");
        }
    }

    /// <summary>How far a fraction may be off.</summary>
    public static double Slack(FuzzPair pair, double fraction)
    {
        double way = pair.Motion.Length;
        return way > 0 ? Along * Math.Max(pair.Scale / way, fraction) + Accuracy.LeastFloat : 0;
    }

    /// <summary>The distance is a convex function of the fraction. So a contact near the fraction, and a gap just
    /// before it, prove together that nothing touches any earlier.</summary>
    private static string? Touch(FuzzPair pair, in CastResult r, float most)
    {
        if (!(r.Fraction >= 0 && r.Fraction <= most)) return Say.Line($"a hit at {r.Fraction:R}, asked up to {most:R}");
        double slack = Slack(pair, r.Fraction), before = r.Fraction - slack;
        Moment nearest = pair.Sweep.Least(Math.Max(before, 0), r.Fraction + slack);
        if (nearest.AtLeast > Grazing(pair, r.Fraction))
            return Say.Line($"a hit at {r.Fraction:R}, where a plane leaves {nearest.AtLeast}");
        return before > 0 ? Apart(pair, before, before, r.Normal, Say.Line($"a hit at {r.Fraction:R}")) : null;
    }

    /// <summary>Whether planes prove the shapes apart, or to reach into each other by no more than a graze: then B
    /// moved out by that along the plane that separates them best is apart. A plane's gap is linear in the fraction:
    /// its ends tell.</summary>
    private static string? Apart(FuzzPair pair, double from, double to, in Double3 hint, string name)
    {
        Moment least = pair.Sweep.Least(from, to);
        double graze = Grazing(pair, to);
        if (least.AtLeast > -graze) return null;
        foreach (Double3 n in (ReadOnlySpan<Double3>)
            [least.Normal, hint, WayOut(pair, least.Fraction), .. Axes(pair.PoseA), .. Axes(pair.PoseB)])
        {
            double length = n.Length;
            if (!(length > 0)) continue;
            Double3 unit = n * (1 / length);
            if (Separates(unit) || Separates(pair.Sweep.At(least.Fraction, unit * (pair.Scale * Step)).Normal))
                return null;
            if (pair.Sweep.Least(from, to, unit * graze).AtLeast > -graze) return null;
        }

        // Where doubles are too coarse for the shapes' own slivers, integers know.
        Double3 moved = pair.Motion.Relative * least.Fraction;
        double outward = hint.Length > 0 ? graze / hint.Length : 0;
        if (pair.Truth.IsKnown && (pair.Truth.PartsWith(moved) || pair.Truth.PartsWith(moved + hint * outward)))
            return null;

        return Say.Line($"{name}, but at {least.Fraction:R} they overlap, by {-least.AtLeast} at most");

        bool Separates(in Double3 unit) =>
            unit.LengthSquared > 0
            && Math.Min(pair.Sweep.Gap(unit, from), pair.Sweep.Gap(unit, to)) > -graze;
    }

    /// <summary>What is flat is left along its own axis.</summary>
    private static Double3[] Axes(in RigidPose pose)
    {
        var turn = new ApproximateRotation(pose.Rotation);
        return [turn.Rotate(new(1, 0, 0)), turn.Rotate(new(0, 1, 0)), turn.Rotate(new(0, 0, 1))];
    }

    /// <summary>Where the library says that B leaves A soonest at a fraction; zero where it says that they are apart.
    /// Only a place to look: the gap of the plane is measured.</summary>
    private static Double3 WayOut(FuzzPair pair, double fraction)
    {
        Double3 moved = (Double3)pair.PoseB.Position + pair.Motion.Relative * fraction;
        var pose = new RigidPose(pair.PoseB.Rotation, (Vector3)moved);
        DistanceResult signed = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pose);
        return signed.IsOverlapping ? signed.Normal : default;
    }

    /// <summary>The plane that touches: it closes, and no gap or overlap is left in it. As it closes in proportion to
    /// the way, it separates the shapes at every fraction before.</summary>
    private static string? Normal(FuzzPair pair, in CastResult r)
    {
        Double3 n = r.Normal;
        double length = n.Length, way = pair.Motion.Length;
        if (!(Math.Abs(length - 1) <= Accuracy.UnitLength)) return Say.Line($"the normal's length is {length}");
        n *= 1 / length;
        double closing = -Double3.Dot(n, pair.Motion.Relative);
        if (!(closing >= -2 * Accuracy.NormalTurn * way)) return Say.Line($"the plane opens by {-closing}");

        double lever = Math.Sqrt(3) * (pair.BodyA.LongestSide + pair.BodyB.LongestSide);
        double gap = pair.Sweep.Gap(n, r.Fraction), moved = Math.Abs(closing) * Slack(pair, r.Fraction);
        double tilt = pair.IsCurved ? Accuracy.CurvedRatio * pair.Scale : 0;
        double band = moved + Accuracy.NormalTurn * lever + tilt + Grazing(pair, r.Fraction) + Accuracy.LeastFloat;
        return Math.Abs(gap) <= band
            ? null
            : Say.Line($"a hit at {r.Fraction:R}, where the plane across the normal leaves {gap}");
    }

    private static string? Point(FuzzPair pair, in CastResult r) =>
        Point(pair, pair.BodyA, pair.Motion.A, r, "A") ?? Point(pair, pair.BodyB, pair.Motion.B, r, "B");

    /// <summary>The point is one of a shape as it has moved, as far as floats can hold it and the fraction.</summary>
    private static string? Point(
        FuzzPair pair, PosedShape body, in Double3 velocity, in CastResult r, string name)
    {
        if (float.IsInfinity(r.Point.X) || float.IsInfinity(r.Point.Y) || float.IsInfinity(r.Point.Z)) return null;
        Double3 moved = velocity * r.Fraction;
        double slack = Slack(pair, r.Fraction), floats = PointsLieOnTheShapes.Rounded(r.Point);
        double rounding = Accuracy.HalfFloat * 2 * (moved.Length + body.Position.Length)
            + slack * (velocity.Length + pair.Motion.Length) + floats;
        double own = pair.IsCurved ? CurvedPoint * pair.Scale : Accuracy.WitnessScale * body.LongestSide;
        double allowed = own + rounding + Grazing(pair, r.Fraction);
        double outside = body.Outside(
            body.InverseRotate((Double3)r.Point - moved - body.Position), Directions.Few);
        return outside <= allowed ? null : Say.Line($"at {r.Fraction:R} the point lies {outside} outside {name}");
    }

    private static double Grazing(FuzzPair pair, double fraction) =>
        Graze * pair.Scale + 4 * pair.Sweep.NoiseAt(fraction);
}
