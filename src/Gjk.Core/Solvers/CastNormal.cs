using System;

namespace Gjk.Core;

/// <summary>
/// The normal in which a curved core is touched, sharper than the distance needs it. A normal that is wrong by an angle
/// costs a distance only the angle's square, so a walk that ends within 1e-10 of the distance can be 1e-5 off.
/// </summary>
/// <remarks>
/// B is moved away from the contact along the normal that is known. The closest points stay where they are but for a
/// hundredth of its error, and the textbook's walk goes on from the simplex that is there, until the distance stops
/// falling: nothing depends on its end but the normal, so nothing need be proved.
/// </remarks>
internal static class CastNormal
{
    /// <summary>Ratio to the radii: how far B is moved away. Pinned by HardCastTests.</summary>
    private const double Retreat = 1e-2;

    /// <summary>
    /// Ratio to the distance: a gap between feature and plane that costs an angle of 1e-7. Pinned by HardCastTests.
    /// </summary>
    private const double Gap = 1e-12;

    /// <summary>Count: rarely more than twenty are taken. Pinned by HardCastTests.</summary>
    private const int MaxRounds = 64;

    /// <summary>Makes the normal sharper; the simplex in the state is used up.</summary>
    public static void Sharpen<TA, TB>(
        ref TA a, ref TB b, ref PairFrame frame, ref SolverState state, ref Cast cast)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        frame.Translation += cast.Normal * (Retreat * frame.Radius);
        FeatureVertices.Begin(out FeatureVertices vertices);
        ClosestFeature feature = default;
        feature.Normal = -cast.Normal;
        double before = double.PositiveInfinity;
        for (int rounds = 0; rounds < MaxRounds; rounds++)
        {
            int slot = vertices.FreeSlot;
            Vector3D w = MinkowskiDifference.Support(
                ref a, ref b, frame, feature.Normal, ref state.Simplex, slot, out _);
            cast.Iterations++;
            double gap = feature.Height - Vector3D.Dot(feature.Normal, w);
            if (vertices.Count > 0 && !(gap > Gap * feature.Height)) break;
            ClosestFeature last = feature;
            bool isOutside = NextSimplex.TryAdvance(
                ref vertices, new MinkowskiVertex(w, slot), ref feature, nearest: true);
            if (isOutside && feature.DistanceSquared < before)
            {
                before = feature.DistanceSquared;
                continue;
            }

            feature = last;
            break;
        }

        double length = Math.Sqrt(feature.NormalSquared);
        if (length > 0) cast.Normal = feature.Normal * (-1 / length);
    }
}
