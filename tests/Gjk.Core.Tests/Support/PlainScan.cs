namespace Gjk.Core.Tests.Support;

/// <summary>The furthest vertex of a hull by a scan of all: the definition that every faster way must agree
/// with.</summary>
internal static class PlainScan
{
    public static int Furthest(HullCells cells, in Double3 direction)
    {
        Double3 d = direction;
        if (cells.Kind == HullCells.LookupKind.Box)
            return cells.Corners.Id((d.X < 0 ? 1 : 0) | (d.Y < 0 ? 2 : 0) | (d.Z < 0 ? 4 : 0));
        if (!cells.Direction.TryPrepare(ref d)) return 0;
        HullVertices hull = cells.Vertices;
        float[] xs = hull.X, ys = hull.Y, zs = hull.Z;
        int best = 0;
        double bestDot = double.NegativeInfinity;
        for (int i = 0; i < hull.Count; i++)
        {
            double dot = d.X * xs[i] + d.Y * ys[i] + d.Z * zs[i];
            if (dot > bestDot) (bestDot, best) = (dot, i);
        }

        return best;
    }
}
