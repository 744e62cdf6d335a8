namespace Gjk.Demo.Trace;

/// <summary>GJK as books print it and as the report built it: Muratori's cases (2006) with the nearest point by
/// barycentric weights (Ericson 2004), in float and in world coordinates, and with a tolerance in its test for the end.
/// It is here to be compared with the library's, and to fail where the books' text fails.</summary>
internal static class TextbookGjk
{
    /// <summary>A share of |v| squared, as careful books have it. A vertex that is nearer by less ends the loop.
    /// Without it many more pairs loop for ever.</summary>
    public const float Tolerance = 1e-6f;

    /// <summary>The page's own limit, far above what pairs need that end. A loop over few vertices repeats itself much
    /// earlier, and is then known to be endless; a curved shape has new vertices for very long.</summary>
    public const int StepCap = 100;

    public static TextbookRun Run(SceneObject a, SceneObject b)
    {
        TextbookBody bodyA = new(a.Shape, a.Pose), bodyB = new(b.Shape, b.Pose);
        var run = new TextbookRun();
        var simplex = new List<TextbookVertex>();
        var seen = new List<TextbookVertex[]>();
        Vector3 direction = bodyB.Center - bodyA.Center, v = Vector3.Zero;
        if (direction == Vector3.Zero) direction = Vector3.UnitX;
        run.Ending = TextbookEnding.StepCap;
        while (run.Steps.Count < StepCap)
        {
            var w = new TextbookVertex(
                run.Steps.Count, bodyA.FurthestPoint(direction), bodyB.FurthestPoint(-direction));
            var step = new TextbookStep(direction, w, Indices(simplex));
            run.Steps.Add(step);
            if (simplex.Count > 0 && TextbookMath.Dot(w.W - v, direction) <= Tolerance * TextbookMath.Dot(v, v))
            {
                run.Ending = TextbookEnding.NoNearer;
                break;
            }

            simplex.Add(w);
            bool holdsOrigin = TextbookSimplex<TextbookVertex>.Reduce(simplex, ref direction);
            step.After = Indices(simplex);
            if (holdsOrigin)
            {
                run.Ending = TextbookEnding.Encloses;
                break;
            }

            Vector3 weights = TextbookClosestPoint.Weights(simplex);
            v = Vector3.Zero;
            for (int i = 0; i < simplex.Count; i++) v += weights[i] * simplex[i].W;
            step.Weights = [.. simplex.Select((_, i) => weights[i])];
            step.Nearest = v;
            direction = -v;
            if (TryEnd(run, v, simplex, seen)) break;
        }

        bool isHit = run.Ending is TextbookEnding.Encloses or TextbookEnding.Touches;
        float margins = (float)(a.Shape.Margin + b.Shape.Margin);
        run.Distance = isHit ? 0 : Math.Max(0, MathF.Sqrt(TextbookMath.Dot(v, v)) - margins);
        return run;
    }

    /// <summary>Ends that the new simplex shows: v is the origin or no number, or the loop has been here.</summary>
    private static bool TryEnd(
        TextbookRun run, Vector3 v, List<TextbookVertex> simplex, List<TextbookVertex[]> seen)
    {
        run.RepeatOf = seen.FindIndex(other => IsSame(other, simplex));
        if (v == Vector3.Zero) run.Ending = TextbookEnding.Touches;
        else if (!float.IsFinite(TextbookMath.Dot(v, v))) run.Ending = TextbookEnding.NotFinite;
        else if (run.RepeatOf >= 0) run.Ending = TextbookEnding.Repeats;
        else seen.Add([.. simplex]);
        return run.Ending != TextbookEnding.StepCap;
    }

    private static bool IsSame(TextbookVertex[] one, List<TextbookVertex> other)
    {
        if (one.Length != other.Count) return false;
        for (int i = 0; i < one.Length; i++)
        {
            if (!one[i].IsAt(other[i])) return false;
        }

        return true;
    }

    private static int[] Indices(List<TextbookVertex> simplex) => [.. simplex.ConvertAll(vertex => vertex.Step)];
}
