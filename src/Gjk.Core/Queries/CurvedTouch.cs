using System;

namespace Gjk.Core;

/// <summary>
/// Whether curved shapes that overlap by a trifle only touch. The search for a depth of curved cores ends within 1e-6
/// of the size, a distance within 1e-9; so B is moved out of A by a known length, and the distance there is held
/// against it.
/// </summary>
/// <remarks>
/// The plane that separates the shapes there bounds the depth where B was, soundly. The bound is sharp where its normal
/// is that of the shortest way out: one that is off by an angle costs half its square of the length. The second look
/// begins with the first one's normal, which is sharper than that of the depth.
/// </remarks>
internal static class CurvedTouch
{
    /// <summary>
    /// Ratio to the size: how far B is moved out, far above the depth and below the shapes' radii. Four times more or
    /// less changes nothing but how many looks are enough. Pinned by TouchingStartTests.
    /// </summary>
    private const double Retreat = 1e-3;

    /// <summary>Count: looks. Pinned by TouchingStartTests.</summary>
    private const int MaxLooks = 2;

    /// <summary>
    /// Ratio to the size: what is deeper is deep, whatever the search leaves open, and is not looked at. Pinned by
    /// TouchingStartTests.
    /// </summary>
    private const double Shallow = 4 * GjkTolerances.DepthNoiseCurved;

    /// <summary>Whether the shapes overlap by no more than counts as touching, and where they touch.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair.</param>
    /// <param name="state">Its signed distance.</param>
    /// <param name="touch">Gets normal and point, as sharp as those of a cast.</param>
    public static bool TryFind<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in SolverState state, out CastFinding touch)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        touch = default;
        double size = state.Size.Value, scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        if (frame.Margins - state.Feature.Height * scale > Shallow * size) return false;
        touch.Normal = state.Feature.Normal * -scale;
        PairFrame moved = frame;
        NoTrace trace = default;
        WarmStart unused = default;
        for (int look = 0; look < MaxLooks; look++)
        {
            Vector3D way = touch.Normal * (Retreat * size);
            moved.Translation = frame.Translation + way;
            SolverState.Begin<TA, TB>(moved, out SolverState apart);
            ConvexQuery.SolveCores(
                ref a, ref b, moved, float.PositiveInfinity, ref unused, false, ref apart, ref trace);
            touch.Iterations += apart.Iterations;
            if (apart.Verdict != Verdict.Apart) return false;
            double planeScale = 1 / Math.Sqrt(apart.Plane.NormalSquared);
            touch.Normal = apart.Plane.Normal * -planeScale;
            double gap = apart.Plane.Value * planeScale - frame.Margins - Vector3D.Dot(touch.Normal, way);
            if (!(gap >= -GjkTolerances.TouchCurved * size)) continue;
            touch.OnA = apart.Simplex.PointOnA(apart.Weights).ToVector3D();
            CastLine outward = default;
            outward.Axis = -touch.Normal;
            moved.Translation = frame.Translation;
            CastNormal.Sharpen(ref a, ref b, ref moved, outward, ref apart, ref touch);
            return true;
        }

        return false;
    }
}
