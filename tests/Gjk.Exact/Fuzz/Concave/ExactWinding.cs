namespace Gjk.Exact.Fuzz.Concave;

/// <summary>How often triangles wind around a point, in integers of any size: slow, and independent of the
/// library.</summary>
public static class ExactWinding
{
    private const int Rays = 20, Reach = 1 << 20;

    /// <param name="corners">Three for each triangle, in the frame of a closed surface.</param>
    /// <param name="pose">The surface's pose.</param>
    /// <param name="point">Not on the surface, in a frame of its own.</param>
    /// <param name="pointPose">That frame's pose.</param>
    /// <param name="random">Draws the direction that is looked in.</param>
    /// <returns>Null where all directions meet an edge.</returns>
    public static int? About(
        Double3[] corners, in RigidPose pose, in Double3 point, in RigidPose pointPose, Rng random)
    {
        var problem = new ExactProblem(corners, 0, pose, [point], 0, pointPose);
        Int3[] seen = [.. Enumerable.Range(0, corners.Length).Select(i => problem.Vertex(i, 0))];
        for (int i = 0; i < Rays; i++)
        {
            var ray = new Int3(
                random.Below(2 * Reach) - Reach, random.Below(2 * Reach) - Reach, random.Below(2 * Reach) - Reach);
            if (Along(seen, ray) is { } found) return found;
        }

        return null;
    }

    private static int? Along(Int3[] corners, in Int3 ray)
    {
        int winding = 0;
        for (int i = 0; i < corners.Length; i += 3)
        {
            (Int3 a, Int3 b, Int3 c) = (corners[i], corners[i + 1], corners[i + 2]);
            Int3 ab = Int3.Cross(a, b);
            int volume = Int3.Dot(ab, c).Sign;

            // In the triangle's plane, but not on it: the triangle is seen from its edge.
            if (volume == 0) continue;
            int x = Int3.Dot(ab, ray).Sign, y = Int3.Dot(Int3.Cross(b, c), ray).Sign;
            int z = Int3.Dot(Int3.Cross(c, a), ray).Sign;
            if (x * y * z == 0 && x * y >= 0 && y * z >= 0 && z * x >= 0) return null;
            if (x == volume && y == volume && z == volume) winding += volume;
        }

        return winding;
    }
}
