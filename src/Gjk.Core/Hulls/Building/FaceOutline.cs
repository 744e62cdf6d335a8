namespace Gjk.Core;

/// <summary>The convex outline of a face's corners, seen along its normal (Andrew 1979: lower and upper chain of the
/// corners in the order of one coordinate).</summary>
internal sealed class FaceOutline(Vector3[] points)
{
    private readonly List<Corner> _seen = [];
    private readonly List<Corner> _chain = [];
    private readonly HashSet<int> _ids = [];

    /// <summary>Appends the outline's corners, counter-clockwise seen from outside.</summary>
    /// <param name="region">The face's triangles.</param>
    /// <param name="triangles">Three corners each.</param>
    /// <param name="normal">Outward, of unit length.</param>
    /// <param name="outline">What is appended to.</param>
    public void Append(List<int> region, int[] triangles, in Double3 normal, List<int> outline)
    {
        if (region.Count == 1)
        {
            for (int k = 0; k < 3; k++) outline.Add(triangles[3 * region[0] + k]);
            return;
        }

        Collect(region, triangles, normal);
        _seen.Sort((p, q) => p.U != q.U ? p.U.CompareTo(q.U) : p.V != q.V ? p.V.CompareTo(q.V) : p.Id.CompareTo(q.Id));
        AddChain(outline);
        _seen.Reverse();
        AddChain(outline);
    }

    private void Collect(List<int> region, int[] triangles, in Double3 normal)
    {
        var basis = new PlaneBasis(normal);
        Double3 origin = points[triangles[3 * region[0]]];
        _seen.Clear();
        _ids.Clear();
        foreach (int triangle in region)
        {
            for (int k = 0; k < 3; k++)
            {
                int id = triangles[3 * triangle + k];
                if (!_ids.Add(id)) continue;
                Double3 p = points[id] - origin;
                _seen.Add(new Corner(Double3.Dot(p, basis.U), Double3.Dot(p, basis.V), id));
            }
        }
    }

    /// <summary>One half of the outline, without its last corner, which begins the other.</summary>
    private void AddChain(List<int> outline)
    {
        _chain.Clear();
        foreach (Corner corner in _seen)
        {
            while (_chain.Count >= 2 && !TurnsLeft(_chain[_chain.Count - 2], _chain[_chain.Count - 1], corner))
                _chain.RemoveAt(_chain.Count - 1);
            _chain.Add(corner);
        }

        for (int i = 0; i + 1 < _chain.Count; i++) outline.Add(_chain[i].Id);
    }

    private static bool TurnsLeft(in Corner a, in Corner b, in Corner c) =>
        (b.U - a.U) * (c.V - b.V) > (b.V - a.V) * (c.U - b.U);

    private readonly struct Corner(double u, double v, int id)
    {
        public readonly double U = u, V = v;
        public readonly int Id = id;
    }
}
