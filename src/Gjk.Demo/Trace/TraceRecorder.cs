namespace Gjk.Demo.Trace;

/// <summary>Keeps everything that a query reports, step by step.</summary>
internal readonly struct TraceRecorder : IGjkTrace
{
    private readonly List<TraceStep> _steps;

    public TraceRecorder(List<TraceStep> steps) => _steps = steps;

    public bool IsOn => true;

    public void OnSupport(in TracedSupport support)
    {
        // A simplex continues from step to step. Only the solver in extended precision begins with an empty one.
        TraceStep? last = _steps.Count > 0 ? _steps[^1] : null;
        bool goesOn = last is not null && last.Support.IsExtended == support.IsExtended;
        _steps.Add(new TraceStep(support, goesOn ? last!.After ?? last.Before : []));
    }

    public void OnReduced(in TracedSimplex simplex)
    {
        var after = new int[simplex.Count];
        var weights = new double[simplex.Count];
        for (int i = 0; i < after.Length; i++)
        {
            Double3 vertex = simplex.Vertex(i);
            after[i] = _steps.FindLastIndex(step => step.Support.Vertex == vertex);
            weights[i] = simplex.Weight(i);
        }

        _steps[^1].Reduce(after, weights, simplex.Nearest, simplex.UpperBound);
    }
}

/// <summary>One iteration: a support call on each shape, and the simplex that follows.</summary>
internal sealed class TraceStep
{
    public TraceStep(in TracedSupport support, int[] before)
    {
        Support = support;
        Before = before;
    }

    public TracedSupport Support { get; }

    /// <summary>The simplex before the step. Each number is the step that found the vertex.</summary>
    public int[] Before { get; }

    /// <summary>The feature that remains of the old simplex and the new vertex. Null if the support ended the
    /// query.</summary>
    public int[]? After { get; private set; }

    /// <summary>The barycentric weights of the nearest point.</summary>
    public double[] Weights { get; private set; } = [];

    public Double3 Nearest { get; private set; }

    /// <summary>|v| after this step.</summary>
    public double UpperBound { get; private set; }

    public void Reduce(int[] after, double[] weights, in Double3 nearest, double upperBound)
    {
        After = after;
        Weights = weights;
        Nearest = nearest;
        UpperBound = upperBound;
    }
}
