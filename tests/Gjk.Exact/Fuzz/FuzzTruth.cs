namespace Gjk.Exact.Fuzz;

/// <summary>What is certain about a pair's distance. Without a curved core it is known, margins included: solved in
/// integers of any size from the points that the shapes were made of. With one, a point of each shape, found by a walk
/// of its own, bounds it from above.</summary>
internal sealed class FuzzTruth
{
    private readonly FuzzPair _pair;

    public FuzzTruth(FuzzPair pair)
    {
        _pair = pair;
        if (IsKnown) Answer = Solve(default);
        AtMost = IsKnown ? Answer.Distance : Math.Max(0, pair.Sweep.At(0).AtMost);
    }

    /// <summary>False where a core is curved.</summary>
    public bool IsKnown => !_pair.IsCurved;

    /// <summary>The exact flag and the distance rounded to the nearest double; only where it is known.</summary>
    public ExactAnswer Answer { get; }

    /// <summary>The true distance is no larger: the distance itself where it is known, else that of two points, with
    /// room for the roundings of a double.</summary>
    public double AtMost { get; }

    /// <summary>The true signed distance of a pair that overlaps by its margins alone: that of the cores, less the
    /// margins. Null where the cores overlap or are curved.</summary>
    public double? SignedByMargins()
    {
        double margins = _pair.A.Margin + _pair.B.Margin;
        if (!IsKnown || margins == 0) return null;
        ExactAnswer cores = ExactOracle.Solve(
            _pair.BodyA.Vertices, 0, _pair.PoseA, _pair.BodyB.Vertices, 0, _pair.PoseB);
        return cores.Overlap ? null : cores.Distance - margins;
    }

    /// <summary>Whether moving B by so much parts the shapes: then they overlap by no more than that.</summary>
    public bool PartsWith(in Double3 moveB) => !Solve(moveB).Overlap;

    private ExactAnswer Solve(in Double3 moveB) =>
        ExactOracle.Solve(
            _pair.BodyA.Vertices, _pair.A.Margin, _pair.PoseA, _pair.BodyB.Vertices, _pair.B.Margin, _pair.PoseB,
            moveB);
}
