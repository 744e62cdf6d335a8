namespace Gjk.Core;

/// <summary>
/// What of a segment or parallelogram lies opposite a parallelogram: clipped by its four sides, one after the other
/// (Sutherland and Hodgman 1974).
/// </summary>
internal static unsafe class FaceClip
{
    /// <summary>Count: four corners, and one more for each side that clips them; one to spare.</summary>
    private const int MostCorners = 9;

    /// <summary>
    /// The mean of the corners of what is left. A side beyond which all of it lies, as it may by rounding, cuts nothing
    /// off.
    /// </summary>
    /// <param name="middle">The middle of what is clipped.</param>
    /// <param name="first">Half of its one side.</param>
    /// <param name="second">Half of its other side; 0 for a segment.</param>
    /// <param name="center">The middle of what clips it.</param>
    /// <param name="u">The direction of that one's side.</param>
    /// <param name="halfU">Half of its length.</param>
    /// <param name="v">The direction of its other side, perpendicular to the first.</param>
    /// <param name="halfV">Half of its length.</param>
    public static Vector3D Middle(
        in Vector3D middle, in Vector3D first, in Vector3D second, in Vector3D center, in Vector3D u, double halfU,
        in Vector3D v, double halfV)
    {
        Vector3D* corners = stackalloc Vector3D[MostCorners], clipped = stackalloc Vector3D[MostCorners];
        corners[0] = middle + first + second;
        corners[1] = middle + first - second;
        corners[2] = middle - first - second;
        corners[3] = middle - first + second;
        int count = 4;
        Clip(ref corners, ref count, ref clipped, center, u, halfU);
        Clip(ref corners, ref count, ref clipped, center, -u, halfU);
        Clip(ref corners, ref count, ref clipped, center, v, halfV);
        Clip(ref corners, ref count, ref clipped, center, -v, halfV);
        Vector3D sum = default;
        for (int i = 0; i < count; i++) sum += corners[i];
        return sum * (1.0 / count);
    }

    /// <summary>Leaves what lies no further from the centre along a direction than a reach, if anything does.</summary>
    private static void Clip(
        ref Vector3D* from, ref int count, ref Vector3D* to, in Vector3D center, in Vector3D direction, double reach)
    {
        int kept = 0;
        for (int i = 0; i < count && kept + 2 <= MostCorners; i++)
        {
            Vector3D p = from[i], q = from[i + 1 < count ? i + 1 : 0];
            double above = Vector3D.Dot(p - center, direction) - reach;
            double next = Vector3D.Dot(q - center, direction) - reach;
            if (above <= 0) to[kept++] = p;
            if (above < 0 && next > 0 || above > 0 && next < 0) to[kept++] = p + (q - p) * (above / (above - next));
        }

        if (kept == 0) return;
        Vector3D* left = to;
        to = from;
        from = left;
        count = kept;
    }
}
