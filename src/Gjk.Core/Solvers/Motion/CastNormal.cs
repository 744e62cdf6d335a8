namespace Gjk.Core;

/// <summary>The normal in which a curved core is touched, and the point, sharper than the distance needs them. A normal
/// that is wrong by an angle costs a distance only the angle's square, so a walk that ends within 1e-10 of the distance
/// can be 1e-5 off.</summary>
/// <remarks>Cores without margins are first moved away from the contact, along the normal that is known: the closest
/// points stay where they are but for a small part of its error. There the textbook's walk goes on until the distance
/// stops falling. Nothing but the last digits depend on its end, so nothing need be proved: the normal is taken if its
/// plane is at least as good as the one that is known. The gap of shapes that overlap by a trifle needs no more: any
/// plane bounds it soundly, and the bound is sharp where its normal is that of the shortest way out.</remarks>
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

    /// <summary>Ratio to the size: what is deeper is deep, whatever the search leaves open (5e-7 where it has to divide
    /// its surface), and is not looked at. A larger one is only slower; a quarter would do where nothing is
    /// divided.</summary>
    private const double Shallow = 4 * GjkTolerances.DepthNoiseCurved;

    /// <summary>Count: how often a gap is measured, each time along the normal that was found the time before. Once is
    /// too few: pinned by RayStartTests. More are only slower.</summary>
    private const int MostGaps = 2;

    /// <summary>Whether the shapes overlap by no more than counts as touching, and where they touch.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair.</param>
    /// <param name="state">Its signed distance.</param>
    /// <param name="touch">Gets normal and point.</param>
    public static bool TryFindTouch(
        ref TA a, ref TB b, in PairFrame frame, in SolverState state, out CastFinding touch)
    {
        touch = default;
        return TryMeasureGap(ref a, ref b, frame, state, ref touch, out double gap)
            && gap >= -GjkTolerances.TouchCurved * state.Size.Value;
    }

    /// <summary>Measures the gap of shapes that overlap by less than the search for a depth can tell: that ends within
    /// 1e-6 of the size, and touching is 1e-9.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair.</param>
    /// <param name="state">Its signed distance.</param>
    /// <param name="touch">Gets normal and point; the iterations are added.</param>
    /// <param name="gap">The gap between the planes across the normal, in solver units: at most the signed
    /// distance.</param>
    /// <returns>False where they are deeper.</returns>
    public static bool TryMeasureGap(
        ref TA a, ref TB b, in PairFrame frame, in SolverState state, ref CastFinding touch, out double gap)
    {
        gap = double.NegativeInfinity;
        double size = state.Size.Value, scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        if (frame.Margins - state.Feature.Height * scale > Shallow * size) return false;
        touch.Normal = state.Feature.Normal * -scale;
        touch.OnA = state.Simplex.WitnessOnA(state.Weights);
        PairFrame moved = frame;
        Simplex.Make(out Simplex simplex);
        for (int count = 0; count < MostGaps && !(gap >= -GjkTolerances.TouchCurved * size); count++)
            gap = Sharpen(ref a, ref b, ref moved, -touch.Normal, ref simplex, ref touch);
        return true;
    }

    /// <summary>Makes normal and point sharper; the simplex is used up.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair where they touch.</param>
    /// <param name="axis">A direction in which B moves into A.</param>
    /// <param name="simplex">Room for the walk.</param>
    /// <param name="cast">The contact.</param>
    /// <returns>The gap between the shapes along the normal, negative where they reach past each other.</returns>
    public static double Sharpen(
        ref TA a, ref TB b, ref PairFrame frame, in Double3 axis, ref Simplex simplex, ref CastFinding cast)
    {
        Double3 contact = frame.Translation;
        double known = GapAlong(ref a, ref b, frame, cast.Normal, ref simplex, ref cast);
        if (frame.Margins == 0) frame.Translation += cast.Normal * (Retreat * frame.Radius);
        FeatureVertices.Make(out FeatureVertices vertices);
        ClosestFeature feature = Walk(ref a, ref b, frame, ref vertices, ref simplex, ref cast);
        double length = Math.Sqrt(feature.NormalSquared);
        if (!(length > 0)) return known;
        Double3 normal = feature.Normal * (-1 / length);
        simplex.Select(vertices.Count, (int)vertices.A.Slot, (int)vertices.B.Slot, (int)vertices.C.Slot, 0);
        Double3 onA = simplex.WitnessOnA(ClosestPointWeights.Of(simplex));
        frame.Translation = contact;
        double slope = -Double3.Dot(normal, axis);
        double gap = GapAlong(ref a, ref b, frame, normal, ref simplex, ref cast);

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
