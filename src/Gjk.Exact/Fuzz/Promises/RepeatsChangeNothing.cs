using System.Collections.Generic;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Vertices that are given twice, and in another order, change nothing.</summary>
internal sealed class RepeatsChangeNothing : IPromise
{
    /// <summary>Building hulls of more corners costs more than all the other promises.</summary>
    private const int MostCorners = 40;

    public string Name => "repeated vertices and their order change nothing";

    public string? Broken(FuzzPair pair)
    {
        if (!TryRepeat(pair.A, out ConvexShape a) | !TryRepeat(pair.B, out ConvexShape b)) return null;
        return Same.Problem(pair, ConvexQuery.Distance(a, pair.PoseA, b, pair.PoseB), "with repeats");
    }

    /// <summary>False when the shape cannot be made again; what is no mesh stays as it is.</summary>
    private static bool TryRepeat(in ConvexShape shape, out ConvexShape repeated)
    {
        repeated = shape;
        if (shape.Hull is not { } hull) return true;
        if (hull.VertexCount > MostCorners) return false;
        var points = new List<Vector3>();
        for (int i = hull.VertexCount - 1; i >= 0; i--)
        {
            points.Add(hull.GetVertex(i));
            points.Add(hull.GetVertex(i / 2));
        }

        repeated = ConvexShape.Mesh(points);
        if (shape.Scale != Vector3.One) repeated = repeated.Scaled(shape.Scale);
        return true;
    }
}
