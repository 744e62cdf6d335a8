namespace Gjk.Core;

/// <summary>Where a line enters the Minkowski difference of two polytopes. A triangle of three of its vertices that the
/// line passes through, the portal, is moved towards the line's beginning until a support plane proves that it is a
/// face (Snethen, "XenoCollide: Complex Collision Made Simple", 2008, there for rays from the inside).</summary>
/// <remarks>
/// <para>Seen along the motion, the difference is a polygon and the line a point, the origin. First the origin is
/// enclosed in a triangle of vertices, as GJK does it, in the plane; a plane along the motion with the polygon on its
/// far side proves a miss. Then each round asks for the vertex furthest beyond the portal's plane. It takes the place
/// of the corner without which the line still passes, and the entry comes nearer. Where nothing lies beyond, portal and
/// plane are bounds of the entry that meet.</para>
/// <para>It deviates from the source in what it believes. An entry is told only with its certificate: a weighted sum of
/// the portal's corners is on the line, the support plane is there too, and the normal is that of a triangle that is no
/// needle. A miss is told only where a plane is further off than rounding. All else (a graze, a slide, a start inside)
/// is left to <c>CastSolver</c>, which asks for proved distances.</para>
/// <para>It terminates because the entry comes nearer from round to round and there are finitely many faces. MaxRounds
/// ends what rounding would turn in a circle.</para>
/// <para>Verdicts. Hit: the line enters at the fraction, which is above 0. Miss: it does not up to the most. Undecided:
/// the caller is to hand over.</para>
/// </remarks>
internal static class CastPortal
{
    /// <summary>Count, of either loop: more than hulls of thousands of vertices need. It only decides which solver
    /// answers.</summary>
    private const int MaxRounds = 40;

    /// <summary>Ratio to the radii: how far the two bounds of the entry may be apart along the motion, and how far
    /// their point may be from the line. A thousandth of the promise. Pinned by
    /// CastPortalTests.ATipAboveAPortalIsLevelOrATurn.</summary>
    private const double EntryGap = 1e-10;

    /// <summary>Ratio to the radii: how level the corners of a face are; then the entry is right to 1e-9
    /// (proofs/cast-portal.g). Pinned by CastPortalTests.ATipAboveAPortalIsLevelOrATurn.</summary>
    private const double Level = 64 * RoundOff.Unit;

    /// <summary>Ratio to the radii: a triangle that is lower is a needle, whose normal may be wrong by more than 3e-7.
    /// Pinned by CastPortalTests.ANeedleIsNoPortal.</summary>
    private const double LeastHeight = 1e7 * Level;

    /// <summary>Ratio: the sine of the angle between the motion and a face; a flatter one is a graze. Pinned by
    /// CastPortalTests.AGrazedTriangleIsNoPortal.</summary>
    private const double LeastSlope = 1e-5;

    /// <summary>Whether the cores are polytopes that can be trusted to be.</summary>
    public static bool AppliesTo<TA, TB>(in PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        ShapeTraits<TA>.AreTight && ShapeTraits<TB>.AreTight && frame.Margins == 0;

    /// <summary>Looks for the entry.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair where the centres are nearest.</param>
    /// <param name="line">The motion.</param>
    /// <param name="most">The largest fraction.</param>
    /// <param name="cast">Gets fraction, normal and iterations.</param>
    /// <param name="state">Gets the simplex and the weights of the point that the shapes share.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static MotionVerdict Solve<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in CastLine line, double most, ref CastFinding cast,
        ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        // A start behind the middle, or so near it, hits nothing or is inside.
        if (!(line.Middle > 0)) return MotionVerdict.Undecided;
        FeatureVertices.Make(out FeatureVertices portal);
        MotionVerdict verdict = Enclose(
            ref a, ref b, frame, line, ref portal, ref cast, ref state.Simplex, out double turn);
        if (verdict != MotionVerdict.Hit) return verdict;
        double end = (most - line.Middle) * line.Speed, gap = EntryGap * frame.Radius;
        for (int rounds = 0; rounds < MaxRounds; rounds++)
        {
            Double3 corner = portal.A.W;
            Double3 normal = Double3.Cross(portal.B.W - corner, portal.C.W - corner) * turn;
            double slope = Double3.Dot(normal, line.Axis), squared = normal.LengthSquared;
            if (!(slope > 0 && slope * slope > LeastSlope * LeastSlope * squared)) return MotionVerdict.Undecided;
            double height = Double3.Dot(normal, corner);
            if (!(line.FractionAt(height / slope) > 0)) return MotionVerdict.Undecided;
            int slot = portal.FreeSlot;
            int ids = MinkowskiDifference.Support(
                ref a, ref b, frame, normal, ref state.Simplex.At(slot), out Double3 w);
            cast.Iterations++;
            double plane = Double3.Dot(normal, w), entry = plane / slope;
            if (entry > end + gap) return MotionVerdict.Miss;
            if (ids < 0) return MotionVerdict.Undecided;
            if (height - plane <= gap * slope || IsCorner(state.Simplex, portal, slot))
            {
                cast.Fraction = line.FractionAt(entry);
                cast.Normal = normal * (-1 / Math.Sqrt(squared));
                if (!IsCertain(frame, line, portal, normal, plane, entry, ref state)) return MotionVerdict.Undecided;
                if (!(cast.Fraction * line.Speed > gap)) return MotionVerdict.Undecided;
                return MotionVerdict.Hit;
            }

            Replace(ref portal, new MinkowskiVertex(w, slot), line.Axis, turn);
        }

        return MotionVerdict.Undecided;
    }

    /// <summary>Finds three vertices that have the line between them.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair where the centres are nearest.</param>
    /// <param name="line">The motion.</param>
    /// <param name="portal">Gets the vertices.</param>
    /// <param name="cast">Its iterations are counted.</param>
    /// <param name="simplex">Gets the support points.</param>
    /// <param name="turn">The sign that makes (B - A) × (C - A) point along the motion.</param>
    private static MotionVerdict Enclose<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in CastLine line, ref FeatureVertices portal, ref CastFinding cast,
        ref Simplex simplex, out double turn)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        turn = 1;

        // From where the line enters the ball about both, to the centre.
        Double3 axis = line.Axis, normal = axis * line.HalfChord - frame.Translation;
        Double3 side = default;
        bool isTilted = false;
        for (int rounds = 0; rounds < MaxRounds; rounds++)
        {
            int slot = portal.FreeSlot;
            int ids = MinkowskiDifference.Support(ref a, ref b, frame, normal, ref simplex.At(slot), out Double3 w);
            cast.Iterations++;
            if (ids < 0) return MotionVerdict.Undecided;
            double beyond = Double3.Dot(side, w);
            if (portal.Count > 0 && beyond > 0)
            {
                if (!isTilted) return IsBeside(line, side, beyond) ? MotionVerdict.Miss : MotionVerdict.Undecided;
                isTilted = false;
                normal = side;
                continue;
            }

            var newest = new MinkowskiVertex(w, slot);
            if (portal.Count == 2 && Surround(ref portal, newest, axis, ref turn)) return MotionVerdict.Hit;
            if (portal.Count == 1)
            {
                portal.B.Set(portal.A);
                portal.A.Set(newest);
                portal.Count = 2;
            }
            else if (portal.Count == 0)
            {
                portal.A.Set(newest);
                portal.Count = 1;
            }

            isTilted = true;
            normal = Aim(portal, axis, out side);
            if (!(side.LengthSquared > line.Error * line.Error)) return MotionVerdict.Undecided;
        }

        return MotionVerdict.Undecided;
    }

    /// <summary>Whether a plane has the difference on its far side, and all of the line that comes near it on this one.
    /// Rounding may have tilted the plane against the line.</summary>
    private static bool IsBeside(in CastLine line, in Double3 side, double plane)
    {
        double tilt = Math.Abs(Double3.Dot(side, line.Axis)), free = plane - tilt * line.HalfChord;
        return free > 0 && free * free > line.Error * line.Error * side.LengthSquared;
    }

    /// <summary>The next direction, from the line to the vertex or edge, and half as much along the motion, so that
    /// vertices in front are found before those behind.</summary>
    /// <param name="portal">A vertex or an edge.</param>
    /// <param name="axis">The motion.</param>
    /// <param name="side">The part of the direction that is perpendicular to the motion.</param>
    private static Double3 Aim(in FeatureVertices portal, in Double3 axis, out Double3 side)
    {
        Double3 corner = portal.A.W;
        if (portal.Count == 1)
        {
            side = corner - axis * Double3.Dot(corner, axis);
            return side + axis * side.Length;
        }

        Double3 edge = portal.B.W - corner, across = Double3.Cross(axis, edge);
        side = across * BranchFree.WithSign(1, Double3.Dot(across, corner));
        return side * edge.Length + Double3.Cross(edge, across);
    }

    /// <summary>Whether the line passes between an edge and the newest vertex; if not, the edge becomes the side that
    /// it is beyond.</summary>
    private static bool Surround(
        ref FeatureVertices portal, in MinkowskiVertex newest, in Double3 axis, ref double turn)
    {
        Double3 w = newest.W, a = portal.A.W, b = portal.B.W, moment = Double3.Cross(axis, w);
        double sign = BranchFree.WithSign(1, Double3.Dot(Double3.Cross(axis, a), b));
        double besideB = -Double3.Dot(moment, b) * sign, besideA = Double3.Dot(moment, a) * sign;
        if (besideA >= 0 & besideB >= 0)
        {
            portal.C.Set(newest);
            portal.Count = 3;
            turn = sign;
            return true;
        }

        if (besideB < 0) portal.A.Set(newest);
        else portal.B.Set(newest);
        return false;
    }

    /// <summary>The corner without which the line still passes between the others and the newest vertex.</summary>
    private static void Replace(ref FeatureVertices portal, in MinkowskiVertex newest, in Double3 axis, double turn)
    {
        Double3 moment = Double3.Cross(axis, newest.W) * turn;
        bool a = Double3.Dot(moment, portal.A.W) >= 0;
        bool b = Double3.Dot(moment, portal.B.W) >= 0;
        bool c = Double3.Dot(moment, portal.C.W) >= 0;
        if (a & !b) portal.C.Set(newest);
        else if (b & !c) portal.A.Set(newest);
        else portal.B.Set(newest);
    }

    /// <summary>The portal was made with this vertex already.</summary>
    private static bool IsCorner(in Simplex simplex, in FeatureVertices portal, int slot) =>
        IsSame(simplex, (int)portal.A.Slot, slot) || IsSame(simplex, (int)portal.B.Slot, slot)
        || IsSame(simplex, (int)portal.C.Slot, slot);

    private static bool IsSame(in Simplex simplex, int slot, int other) =>
        simplex.IdA(slot) == simplex.IdA(other) & simplex.IdB(slot) == simplex.IdB(other);

    /// <summary>Whether the portal is a face, and its point on the line the entry.</summary>
    private static bool IsCertain(
        in PairFrame frame, in CastLine line, in FeatureVertices portal, in Double3 normal, double plane, double entry,
        ref SolverState state)
    {
        Double3 a = portal.A.W, b = portal.B.W, c = portal.C.W;
        double wa = Math.Abs(Double3.Dot(line.Axis, Double3.Cross(b, c)));
        double wb = Math.Abs(Double3.Dot(line.Axis, Double3.Cross(c, a)));
        double wc = Math.Abs(Double3.Dot(line.Axis, Double3.Cross(a, b)));
        double scale = 1 / (wa + wb + wc);
        state.Weights = new Weights(wa * scale, wb * scale, wc * scale, 0);
        state.Simplex.Select(3, (int)portal.A.Slot, (int)portal.B.Slot, (int)portal.C.Slot, 0);
        Double3 off = state.Simplex.PointOf(state.Weights) - line.Axis * entry;
        double gap = EntryGap * frame.Radius, length = normal.Length, level = Level * frame.Radius * length;
        double widest = Math.Sqrt(Math.Max((b - a).LengthSquared, (c - a).LengthSquared));
        return off.LengthSquared <= gap * gap
            && length >= LeastHeight * frame.Radius * widest
            && Math.Abs(Double3.Dot(normal, a) - plane) <= level
            && Math.Abs(Double3.Dot(normal, b) - plane) <= level
            && Math.Abs(Double3.Dot(normal, c) - plane) <= level;
    }
}
