namespace Gjk.Core;

/// <summary>The normal in which a curved core is touched, and the point, sharper than the distance needs them. A normal
/// that is wrong by an angle costs a distance only the angle's square, so a walk that ends within 1e-10 of the distance
/// can be 1e-5 off.</summary>
/// <remarks>Cores without margins are first moved away from the contact, along the normal that is known: the closest
/// points stay where they are but for a small part of its error. There the textbook's walk goes on until the distance
/// stops falling. Nothing but the last digits depend on its end, so nothing need be proved: the normal is taken if its
/// plane is at least as good as the one that is known.</remarks>
internal static class CastNormal<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Ratio to the radii: how far B is moved away. A quarter of it, and four times as much, keep all that
    /// CurvedCastTests ask.</summary>
    private const double Retreat = 1e-3;

    /// <summary>Ratio to the distance: a gap between feature and plane that costs an angle of some 4e-7. A smaller one
    /// would only take more rounds. Pinned by CurvedCastTests.</summary>
    private const double Gap = 1e-13;

    /// <summary>Count: rarely more than twenty are taken; more would only cost time. Pinned by
    /// CurvedCastTests.</summary>
    private const int MaxRounds = 64;

    /// <summary>Makes normal and point sharper; the simplex in the state is used up.</summary>
    /// <returns>The gap between the shapes along the normal, negative where they reach past each other.</returns>
    public static double Sharpen(
        ref TA a, ref TB b, ref PairFrame frame, in CastLine line, ref SolverState state, ref CastFinding cast)
    {
        Double3 contact = frame.Translation;
        double known = GapAlong(ref a, ref b, frame, cast.Normal, ref state.Simplex, ref cast);
        if (frame.Margins == 0) frame.Translation += cast.Normal * (Retreat * frame.Radius);
        FeatureVertices.Make(out FeatureVertices vertices);
        ClosestFeature feature = Walk(ref a, ref b, frame, ref vertices, ref state.Simplex, ref cast);
        double length = Math.Sqrt(feature.NormalSquared);
        if (!(length > 0)) return known;
        Double3 normal = feature.Normal * (-1 / length);
        state.Simplex.Select(vertices.Count, (int)vertices.A.Slot, (int)vertices.B.Slot, (int)vertices.C.Slot, 0);
        Double3 onA = state.Simplex.WitnessOnA(ClosestPointWeights.Of(state.Simplex));
        frame.Translation = contact;
        double slope = -Double3.Dot(normal, line.Axis);
        double gap = GapAlong(ref a, ref b, frame, normal, ref state.Simplex, ref cast);

        // Of all planes the one in which they touch leaves the widest gap.
        if (!(gap >= known && slope > 0)) return known;
        (cast.Normal, cast.OnA) = (normal, onA);
        return gap;
    }

    /// <summary>The gap between the shapes along a normal, negative where they reach past each other.</summary>
    private static double GapAlong(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref Simplex simplex, ref CastFinding cast)
    {
        MinkowskiDifference.Support(ref a, ref b, frame, -normal, ref simplex.At(0), out Double3 w);
        cast.Iterations++;
        return -Double3.Dot(normal, w) - frame.Margins;
    }

    /// <summary>The feature nearest the origin, as near as a double can tell.</summary>
    private static ClosestFeature Walk(
        ref TA a, ref TB b, in PairFrame frame, ref FeatureVertices vertices, ref Simplex simplex, ref CastFinding cast)
    {
        ClosestFeature feature = default;
        feature.Normal = -cast.Normal;
        double before = double.PositiveInfinity;
        for (int rounds = 0; rounds < MaxRounds; rounds++)
        {
            int slot = vertices.FreeSlot;
            MinkowskiDifference.Support(ref a, ref b, frame, feature.Normal, ref simplex.At(slot), out Double3 w);
            cast.Iterations++;
            double gap = feature.Height - Double3.Dot(feature.Normal, w);
            if (vertices.Count > 0 && !(gap > Gap * feature.Height)) break;
            FeatureVertices lastVertices = vertices;
            ClosestFeature last = feature;
            bool isOutside = NextSimplex.TryAdvance(
                ref vertices, new MinkowskiVertex(w, slot), ref feature, nearest: true);
            if (!isOutside || !(feature.DistanceSquared < before))
            {
                vertices = lastVertices;
                return last;
            }

            before = feature.DistanceSquared;
        }

        return feature;
    }
}
