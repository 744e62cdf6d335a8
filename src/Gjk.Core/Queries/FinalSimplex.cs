namespace Gjk.Core;

/// <summary>The simplex that a distance query ended with: up to four pairs of support points whose weighted sums are
/// the closest points of the two cores (a common point when they overlap). Immutable.</summary>
public readonly struct FinalSimplex
{
    private readonly Simplex _simplex;
    private readonly Weights _weights;
    private readonly Double3 _centerA, _centerB;
    private readonly double _unit;

    internal FinalSimplex(in Simplex simplex, in PairFrame frame)
    {
        _simplex = simplex;
        _weights = ClosestPointWeights.Of(simplex);
        _centerA = frame.CenterA;
        _centerB = frame.CenterB;
        _unit = frame.Unit;
        if (!frame.IsPlaced) return;
        _centerA = frame.OutOfA(_centerA.ToXyz()).ToDouble3();
        _centerB = frame.OutOfB(_centerB.ToXyz()).ToDouble3();
        for (int i = 0; i < simplex.Count; i++)
        {
            int slot = simplex[i];
            _simplex.Fill(
                slot, simplex.W(slot), frame.OutOfA(simplex.OnA(slot).ToXyz()).ToDouble3(),
                frame.OutOfB(simplex.OnB(slot).ToXyz()).ToDouble3(), simplex.IdA(slot), simplex.IdB(slot));
        }
    }

    /// <summary>Keeps the simplex of a query that ended with one.</summary>
    internal static unsafe void Keep(in SolverState state, in PairFrame frame, FinalSimplex* simplex)
    {
        if (state.Verdict != Verdict.Contradiction && state.Simplex.Count > 0)
            *simplex = new FinalSimplex(state.Simplex, frame);
    }

    /// <summary>How many pairs of support points there are, 1 to 4; 0 when the query had no answer.</summary>
    public int Count => _simplex.Count;

    /// <summary>A pair's barycentric weight: at least 0, with sum 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public double Weight(int index) => _weights[Checked(index)];

    /// <summary>The support point of A, in A's own frame.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public Double3 PointOnA(int index) => (_simplex.OnA(_simplex[Checked(index)]) + _centerA) * _unit;

    /// <summary>The support point of B, in B's own frame.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public Double3 PointOnB(int index) => (_simplex.OnB(_simplex[Checked(index)]) + _centerB) * _unit;

    /// <summary>The id of A's support point, or -1 where A has no vertices.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public int IdA(int index) => _simplex.IdA(_simplex[Checked(index)]);

    /// <summary>The id of B's support point, or -1 where B has no vertices.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public int IdB(int index) => _simplex.IdB(_simplex[Checked(index)]);

    private int Checked(int index) => Guard.Index(index, Count, nameof(index), "pair of points");
}
