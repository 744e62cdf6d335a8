using Gjk.Core.Diagnostics;

namespace Gjk.Web;

/// <summary>A trace as numbers. A support is 1, its normal, the points on A and B, their ids, the lower bound, and 1 if
/// it is in extended precision. A reduction is 2, the number of vertices, each vertex with its weight, the nearest
/// point and the upper bound.</summary>
internal readonly struct StepNumbers : IGjkTrace
{
    private const double Support = 1, Reduction = 2;

    public StepNumbers(List<double> numbers) => Numbers = numbers;

    public List<double> Numbers { get; }

    public bool IsOn => true;

    public void OnSupport(in TracedSupport support)
    {
        Numbers.Add(Support);
        Add(support.Normal);
        Add(support.PointOnA);
        Add(support.PointOnB);
        Numbers.AddRange([support.IdA, support.IdB, support.LowerBound, support.IsExtended ? 1 : 0]);
    }

    public void OnReduced(in TracedSimplex simplex)
    {
        Numbers.AddRange([Reduction, simplex.Count]);
        for (int i = 0; i < simplex.Count; i++)
        {
            Add(simplex.Vertex(i));
            Numbers.Add(simplex.Weight(i));
        }

        Add(simplex.Nearest);
        Numbers.Add(simplex.UpperBound);
    }

    private void Add(in Double3 v) => Numbers.AddRange([v.X, v.Y, v.Z]);
}
