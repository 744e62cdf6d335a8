namespace Gjk.Core;

/// <summary>What of a segment or parallelogram lies opposite a parallelogram: clipped by its four sides, one after the
/// other (Sutherland and Hodgman 1974).</summary>
internal static unsafe class FaceClip
{
    /// <summary>Count: four corners, and one more for each side that clips them; one to spare.</summary>
    private const int MostCorners = 9;

    /// <summary>The mean of the corners of what is left. A side beyond which all of it lies, as it may by rounding,
    /// cuts nothing off.</summary>
    /// <param name="middle">The middle of what is clipped.</param>
    /// <param name="first">Half of its one side.</param>
    /// <param name="second">Half of its other side; 0 for a segment.</param>
    /// <param name="center">The middle of what clips it.</param>
    /// <param name="u">The direction of that one's side.</param>
    /// <param name="halfU">Half of its length.</param>
    /// <param name="v">The direction of its other side, perpendicular to the first.</param>
    /// <param name="halfV">Half of its length.</param>
    public static Double3 Middle(
        in Double3 middle, in Double3 first, in Double3 second, in Double3 center, in Double3 u, double halfU,
        in Double3 v, double halfV)
    {
        Double3* corners = stackalloc Double3[MostCorners], clipped = stackalloc Double3[MostCorners];
        corners[0] = middle + first + second;
        corners[1] = middle + first - second;
        corners[2] = middle - first - second;
        corners[3] = middle - first + second;
        int count = 4;
        Clip(ref corners, ref count, ref clipped, center, u, halfU);
        Clip(ref corners, ref count, ref clipped, center, -u, halfU);
        Clip(ref corners, ref count, ref clipped, center, v, halfV);
        Clip(ref corners, ref count, ref clipped, center, -v, halfV);
        Double3 sum = default;
        for (int i = 0; i < count; i++) sum += corners[i];
        return sum * (1.0 / count);
    }

    /// <summary>Leaves what lies no further from the centre along a direction than a reach, if anything does.</summary>
    private static void Clip(
        ref Double3* from, ref int count, ref Double3* to, in Double3 center, in Double3 direction, double reach)
    {
        int kept = 0;
        for (int i = 0; i < count && kept + 2 <= MostCorners; i++)
        {
            Double3 p = from[i], q = from[i + 1 < count ? i + 1 : 0];
            double above = Double3.Dot(p - center, direction) - reach;
            double next = Double3.Dot(q - center, direction) - reach;
            if (above <= 0) to[kept++] = p;
            if (above < 0 && next > 0 || above > 0 && next < 0) to[kept++] = p + (q - p) * (above / (above - next));
        }

        if (kept == 0) return;
        Double3* left = to;
        to = from;
        from = left;
        count = kept;
    }
}
