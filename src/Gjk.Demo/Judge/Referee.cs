namespace Gjk.Demo.Judge;

/// <summary>What can be wrong with an answer, in the order in which it is looked for.</summary>
internal enum Fault
{
    None,
    Missing,
    NoAnswer,
    Wrong,
    Inaccurate,
    Bound,
    Normal,
    Part,
}

/// <summary>What a referee says of an answer.</summary>
/// <param name="Fault">What is wrong with it.</param>
/// <param name="Text">In words.</param>
/// <param name="Error">How far it is off, as a ratio to what is allowed: 1 is the limit.</param>
internal readonly record struct Ruling(Fault Fault, string Text, double Error);

/// <summary>Holds the answer of any engine to the proved one. Numbers count as the floats that they round to, so that
/// an engine in double has no advantage. Every allowance is in <see cref="Accuracy"/> or below, and in
/// docs/cases.md.</summary>
/// <param name="forgiven">Ratio to the larger of scale and distance, or way: an error that is no fault. 0 for exact
/// engines.</param>
internal sealed class Referee(double forgiven)
{
    /// <summary>Ratio of a cast's error to the scale or the way, whichever is larger.</summary>
    private const double PerWay = 1e-7;

    /// <summary>Ratio to the scale: what a way out may cost more than the shortest one. Rounding a unit vector to float
    /// turns it by 1.1e-7, at a lever of at most 3.5 scales. Also how far a normal may be off.</summary>
    private const double PerDirection = 1e-6;

    public Ruling Judge(Truth truth, CsvRow? answer)
    {
        if (answer is null) return new Ruling(Fault.Missing, "there is no row for the pair", 0);
        return truth.Kind == TruthKind.Cast ? OfCast(truth, answer) : OfPair(truth, answer);
    }

    private Ruling OfPair(Truth truth, CsvRow answer)
    {
        bool overlaps = answer.Flag("overlap");

        // An engine that tells depths may have no distance of a pair that is apart.
        bool isFlagOnly = truth.Kind == TruthKind.Depth && !overlaps && !answer.Has("distance");
        float found = isFlagOnly ? 0 : (float)answer.Number("distance");
        if (answer.Has("status") && answer["status"] is not ("Separated" or "Overlapping"))
            return new Ruling(Fault.NoAnswer, $"status {answer["status"]}", 0);
        if (!float.IsFinite(found)) return new Ruling(Fault.NoAnswer, Invariant($"distance {found}"), 0);
        double clear = Math.Max(forgiven, Accuracy.FlagScale) * truth.Scale;
        bool isClear = (truth.Overlaps ? truth.Depth : truth.Distance) > clear;
        if (overlaps != truth.Overlaps && isClear)
        {
            string size = Invariant($"distance {truth.Distance}, depth {truth.Depth}");
            return new Ruling(Fault.Wrong, $"overlap {overlaps}, truly {truth.Overlaps}: {size}", 0);
        }

        bool hasDepth = truth.Kind == TruthKind.Depth || (truth.Kind == TruthKind.Point && found < 0);
        if (isFlagOnly || (overlaps && (!truth.Overlaps || !hasDepth))) return default;
        double signed = overlaps ? -truth.Depth : truth.Distance;
        double error = Math.Abs(found - signed) / Allowed(truth, Math.Abs(signed));
        if (error > 1) return new Ruling(Fault.Inaccurate, Invariant($"distance {found}, truly {signed}"), error);
        if (BoundFault(signed, answer) is { } bound) return new Ruling(Fault.Bound, bound, error);
        if (overlaps && DirectionFault(truth, answer) is { } way) return new Ruling(Fault.Normal, way, error);
        return PartFault(truth, answer, overlaps) is { } part
            ? new Ruling(Fault.Part, part, error)
            : new Ruling(Fault.None, "", error);
    }

    private double Allowed(Truth truth, double size) =>
        Accuracy.Band(size, truth.Scale) + forgiven * Math.Max(truth.Scale, size) + truth.Tolerance;

    private static string? BoundFault(double signed, CsvRow answer)
    {
        if (!answer.Has("lower_bound")) return null;
        float bound = (float)answer.Number("lower_bound");
        double most = signed + Accuracy.HalfFloat * Math.Abs(signed) + Accuracy.LeastFloat;
        return bound <= most ? null : Invariant($"lower bound {bound}, above the truth {signed}");
    }

    /// <summary>A way out is judged by what it costs: several may be shortest.</summary>
    private string? DirectionFault(Truth truth, CsvRow answer)
    {
        if (truth.Kind != TruthKind.Depth || Normal(answer) is not { } normal) return null;
        double length = normal.Length;
        if (!(Math.Abs(length - 1) <= PerDirection)) return Invariant($"the normal's length is {length}");
        var a = new Body<ConvexShape>(truth.A.Shape, truth.A.Pose);
        var b = new Body<ConvexShape>(truth.B.Shape, truth.B.Pose);
        double cost = -Certificate.Gap(a, b, normal * (1 / length));
        double most = truth.Depth + Math.Max(PerDirection, forgiven) * truth.Scale;
        return cost <= most ? null : Invariant($"the way out along the normal is {cost}, the shortest {truth.Depth}");
    }

    private static Double3? Normal(CsvRow row) => row.Has("nx") && row.Has("ny") && row.Has("nz")
        ? new Double3(row.Number("nx"), row.Number("ny"), row.Number("nz"))
        : null;

    /// <summary>The named parts must exist, and their own distance must be that of the shapes.</summary>
    private string? PartFault(Truth truth, CsvRow answer, bool overlaps)
    {
        if (PartOf(truth.A, answer, "part_a", out ConvexShape a) is { } faultA) return faultA;
        if (PartOf(truth.B, answer, "part_b", out ConvexShape b) is { } faultB) return faultB;
        if (overlaps || a.Kind == ShapeKind.None || b.Kind == ShapeKind.None) return null;
        double apart = ConvexQuery.Distance(a, truth.A.Pose, b, truth.B.Pose).Distance;
        double most = truth.Distance + Allowed(truth, truth.Distance);
        return apart <= most ? null : Invariant($"the named parts are {apart} apart, the shapes {truth.Distance}");
    }

    /// <summary>The part that a column names; none where it is not there, or names none.</summary>
    private static string? PartOf(SceneObject o, CsvRow answer, string column, out ConvexShape part)
    {
        part = o.Shape;
        if (o.IsConvex || !answer.Has(column)) return null;
        int index = answer.Index(column);
        if (index >= o.Any.PartCount) return $"{column} {index}: the object has {o.Any.PartCount} parts";
        if (o.Any.Mesh is { } mesh)
        {
            mesh.GetTriangle(index, out int i, out int j, out int k);
            part = ConvexShape.Triangle(mesh.GetVertex(i), mesh.GetVertex(j), mesh.GetVertex(k)).Scaled(mesh.Scale);
        }
        else
        {
            part = o.Any.Compound!.GetPart(index);
        }

        return null;
    }

    private Ruling OfCast(Truth truth, CsvRow answer)
    {
        string said = Outcome(answer["status"]), outcome = Outcome(truth.Row["outcome"]);
        if (said is not ("hit" or "miss" or "overlappingatstart"))
            return new Ruling(Fault.NoAnswer, $"status {answer["status"]}", 0);
        if (said != outcome) return new Ruling(Fault.Wrong, $"{said}, truly {outcome}", 0);
        if (said != "hit") return default;
        float found = (float)answer.Number("fraction");
        if (!float.IsFinite(found)) return new Ruling(Fault.NoAnswer, Invariant($"fraction {found}"), 0);
        double fraction = truth.Row.Number("fraction");
        double way = ((Double3)truth.B.Velocity - truth.A.Velocity).Length;
        double allowed = Math.Max(PerWay, forgiven) * Math.Max(truth.Scale, fraction * way) + truth.Tolerance * way;
        double error = Math.Abs(found - fraction) * way / allowed;
        if (error > 1) return new Ruling(Fault.Inaccurate, Invariant($"fraction {found}, truly {fraction}"), error);
        double most = Math.Max(PerDirection, forgiven);
        bool isOnly = truth.Row.Has("ties") && truth.Row["ties"] == "1";
        if (isOnly && Normal(answer) is { } n && Normal(truth.Row) is { } only && !((n - only).Length <= most))
            return new Ruling(Fault.Normal, Invariant($"normal {n}, truly {only}"), error);
        return new Ruling(Fault.None, "", error);
    }

    private static string Outcome(string text) => text.ToLowerInvariant().Replace("_", "");

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
