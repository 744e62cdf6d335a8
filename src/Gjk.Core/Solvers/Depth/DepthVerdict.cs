namespace Gjk.Core;

/// <summary>How a search for the depth ended; see <see cref="GjkDepth"/>.</summary>
internal enum DepthVerdict
{
    /// <summary>There was no room for the whole surface.</summary>
    Undecided = 0,

    /// <summary>The bounds met.</summary>
    Found,

    /// <summary>A plane separates the shapes.</summary>
    Apart,

    /// <summary>The Minkowski difference has no inside: it is flat, a segment or a point.</summary>
    Flat,

    /// <summary>The supports contradict each other.</summary>
    Contradiction,
}

/// <summary>What is known of the depth.</summary>
internal struct DepthBounds
{
    /// <summary>The direction of the cheapest way out that was seen, of unit length.</summary>
    public Double3 Normal;

    /// <summary>What it costs: the depth is not more.</summary>
    public double Above;

    /// <summary>The depth is not less.</summary>
    public double Below;

    /// <summary>Nothing is known.</summary>
    public static DepthBounds None => new()
    {
        Normal = new Double3(1, 0, 0),
        Above = double.PositiveInfinity,
        Below = double.NegativeInfinity,
    };

    /// <summary>What a search has left in a state.</summary>
    public static DepthBounds Of(in SolverState state) => new()
    {
        Normal = -state.Feature.Normal,
        Above = -state.Plane.Value,
        Below = -state.Feature.Height,
    };

    /// <summary>Takes note of what a direction costs; the first of equally cheap ones stays.</summary>
    public void See(in Double3 normal, double height)
    {
        if (!(height < Above)) return;
        Above = height;
        Normal = normal;
    }

    /// <summary>Whether a plane separates the shapes by more than rounding could.</summary>
    public readonly bool IsApart(in SolverState state) =>
        Above < -GjkTolerances.SeparatedBandOf(state.IsCurved) * state.Size.Value;

    /// <summary>The direction in which the bounds have met.</summary>
    public void Settle(in Double3 normal, double height)
    {
        Above = height;
        Normal = normal;
    }

    /// <summary>Writes the bounds as a feature of negative distance: as if a plane at minus the depth separated the
    /// shapes.</summary>
    /// <param name="state">Gets it.</param>
    /// <param name="depth">What to call the depth.</param>
    public readonly void Store(ref SolverState state, double depth)
    {
        state.Feature.Normal = -Normal;
        state.Feature.NormalSquared = 1;
        state.Feature.Height = -depth;
        state.Plane.Set(state.Feature, -Above);
    }
}
