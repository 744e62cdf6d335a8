namespace Gjk.Core;

/// <summary>Keeps places of contact to faces that are needles: what is within a slack of both edges of a sharp tip may
/// lie far beyond it, where the shape has ended.</summary>
internal static class SharpTips
{
    /// <summary>Moves a place that lies beyond a tip to the tip; false where the other feature does not reach that
    /// far.</summary>
    public static bool TryKeep(ref ContactPlace place, ref FlatFeature a, ref FlatFeature b, double slack)
    {
        if (!a.IsSharp && !b.IsSharp) return true;
        int tip = Before(ref a, place.U, place.V, slack);
        if (tip >= 0)
        {
            place.MoveTo(a[tip], tip, -1);
            return Reaches(ref b, place, slack);
        }

        tip = Before(ref b, place.U, place.V, slack);
        if (tip < 0) return true;
        place.MoveTo(b[tip], -1, tip);
        return Reaches(ref a, place, slack);
    }

    private static bool Reaches(ref FlatFeature feature, in ContactPlace place, double slack) =>
        feature.Holds(place.U, place.V, slack) && Before(ref feature, place.U, place.V, slack) < 0;

    /// <summary>The corner that a place lies beyond; -1 where it is within a slack of the feature itself.</summary>
    private static int Before(ref FlatFeature feature, double u, double v, double slack)
    {
        int tip = -1;
        for (int i = 0; i < feature.EdgeCount; i++)
        {
            if (!(feature.Inside(i, u, v) < 0)) continue;
            if (feature.IsBeside(i, u, v, slack)) return -1;
            int end = feature.NearerEnd(i, u, v);
            if (tip < 0 || feature[end].SquaredTo(u, v) < feature[tip].SquaredTo(u, v)) tip = end;
        }

        return tip >= 0 && feature[tip].SquaredTo(u, v) <= 4 * slack * slack ? -1 : tip;
    }
}
