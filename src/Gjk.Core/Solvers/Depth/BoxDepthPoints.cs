namespace Gjk.Core;

/// <summary>The deepest points of two boxes: a point of each box's face, edge or corner along the way out, one opposite
/// the other.</summary>
/// <remarks>Across a face, the other box's corner that lies furthest behind it is one; where an edge or a face lies
/// level with it, the middle of what lies opposite is taken (<see cref="FaceClip"/>). Across two edges it is where they
/// pass each other.</remarks>
internal static class BoxDepthPoints
{
    /// <summary>Length, as a fraction of the size: a side that rises by less along the way out is level; and the same
    /// of its own length. An edge that is tilted by more decides which corner is the deepest without doubt; one that is
    /// tilted by less moves the points by less than they are promised. Pinned by
    /// DepthToleranceTests.ASideThatHardlyRisesIsLevel.</summary>
    private const double LevelSide = 3e-8;

    /// <summary>The cosine between a side and the way out above which it is not level, even if it is too short to rise.
    /// One of the three is at least 0.57, so anything below that and well above <see cref="LevelSide"/> will
    /// do.</summary>
    private const double Steep = 0.5;

    /// <summary>Length, as a fraction of the size: how far beside a face a point still counts as opposite, so that
    /// rounding leaves something of what lies along its rim. Anything well above rounding, 1e-15, and well below
    /// float's will do. Where nothing is left, it is <see cref="LevelSide"/>: a way out that costs no more than another
    /// but for rounding may end beside the face by that rounding over the angle between both. Pinned by
    /// LevelEdgeTests.PointsLieOnBothBoxes.</summary>
    private const double Slack = 1e-12;

    /// <summary>Finds both points, from the boxes' centres and in their frames.</summary>
    public static void Find(in BoxPair pair, in DepthBounds depth, double size, out Double3 onA, out Double3 inB)
    {
        Double3 way = depth.Normal * depth.Upper;
        int face = FaceOf(pair, depth.Normal);
        if (face < 3)
        {
            if (TryCorner(pair.HalfB, -pair.ToB(depth.Normal), size, out inB))
            {
                onA = pair.Between + pair.X * inB.X + pair.Y * inB.Y + pair.Z * inB.Z + way;
                return;
            }

            Double3 onB = Opposite(pair.Between, SidesOfB(pair), default, SidesOfA(pair), face, depth.Normal, size);
            onA = onB + way;
            inB = InB(pair, onB);
            return;
        }

        // Across a face of B it is seen from B.
        if (face >= BoxPair.Faces) onA = OnEdge(pair, depth);
        else if (!TryCorner(pair.HalfA, depth.Normal, size, out onA))
            onA = Opposite(default, SidesOfA(pair), pair.Between, SidesOfB(pair), face - 3, -depth.Normal, size);
        inB = InB(pair, onA - way);
    }

    /// <summary>The corner of a box that is furthest in a direction, where no side is level across it.</summary>
    private static bool TryCorner(in Double3 half, in Double3 direction, double size, out Double3 corner)
    {
        double x = direction.X * half.X, y = direction.Y * half.Y, z = direction.Z * half.Z;
        corner = new Double3(x < 0 ? -half.X : half.X, y < 0 ? -half.Y : half.Y, z < 0 ? -half.Z : half.Z);
        return !(IsLevel(x, half.X, size) | IsLevel(y, half.Y, size) | IsLevel(z, half.Z, size));
    }

    /// <summary>Whether half a side hardly rises: of a box's three at most two, however thin it is.</summary>
    private static bool IsLevel(double rise, double half, double size) =>
        Math.Abs(rise) <= LevelSide * size & Math.Abs(rise) <= Steep * half;

    /// <summary>A point of A's frame, from B's centre in B's.</summary>
    private static Double3 InB(in BoxPair pair, in Double3 point) => pair.ToB(point - pair.Between);

    /// <summary>The point of a box that lies deepest behind a face of another, and opposite the face.</summary>
    /// <param name="center">The centre of the box.</param>
    /// <param name="sides">Its sides.</param>
    /// <param name="faceCenter">The centre of the box with the face.</param>
    /// <param name="faceSides">The same of that.</param>
    /// <param name="face">Which of its axes the face is across.</param>
    /// <param name="outward">The face's normal.</param>
    /// <param name="size">Of the pair.</param>
    private static Double3 Opposite(
        in Double3 center, in Sides sides, in Double3 faceCenter, in Sides faceSides, int face, in Double3 outward,
        double size)
    {
        Double3 point = center, first = default, second = default;
        for (int i = 0; i < 3; i++)
        {
            Double3 side = sides[i];
            double rise = Double3.Dot(side, outward);
            if (sides.Half(i) == 0) continue;
            if (!IsLevel(rise, sides.Half(i), size)) point -= side * Math.Sign(rise);
            else if (first == default) first = side;
            else second = side;
        }

        if (first == default) return point;
        int u = (face + 1) % 3, v = (face + 2) % 3;
        return FaceClip.Middle(
            point, first, second, faceCenter, faceSides.Axis(u), faceSides.Half(u), faceSides.Axis(v),
            faceSides.Half(v), Slack * size, LevelSide * size);
    }

    /// <summary>The face that is level with the axis across two edges, so that rounding alone has preferred them to it;
    /// the axis itself where there is none. An axis that costs no more than another but for rounding is not opposite
    /// its own edges by that rounding over the angle between both, and which of the parallel edges it is may be
    /// rounding, too.</summary>
    private static int FaceOf(in BoxPair pair, in Double3 normal)
    {
        if (pair.Axis < BoxPair.Faces) return pair.Axis;
        int i = pair.EdgeOfA, j = pair.EdgeOfB;
        for (int k = 1; k < 3; k++)
        {
            int beside = (i + k) % 3, besideB = (j + k) % 3;
            if (Math.Abs(Double3.Dot(BoxPair.Unit(beside), normal)) <= LevelSide) return 3 - i - beside;
            if (Math.Abs(Double3.Dot(pair.AxisOfB(besideB), normal)) <= LevelSide) return 6 - j - besideB;
        }

        return pair.Axis;
    }

    /// <summary>The point of A's edge where B's passes it.</summary>
    private static Double3 OnEdge(in BoxPair pair, in DepthBounds depth)
    {
        int i = pair.EdgeOfA, j = pair.EdgeOfB;
        Double3 normal = depth.Normal, along = BoxPair.Unit(i), alongB = pair.AxisOfB(j);
        Double3 a = MiddleOfEdge(pair.HalfA, normal, i), inB = MiddleOfEdge(pair.HalfB, -pair.ToB(normal), j);
        Double3 b = pair.Between + pair.X * inB.X + pair.Y * inB.Y + pair.Z * inB.Z;

        // a + s along = b + normal depth + r alongB; the cross product with alongB leaves s, the dot product with along
        // says where B's edge lies beside A's. Of nearly parallel edges rounding moves s far, but not out of both.
        Double3 across = Double3.Cross(along, alongB), between = b + normal * depth.Upper - a;
        double half = Along(pair.HalfA, i), reach = Along(pair.HalfB, j) * Math.Abs(Double3.Dot(along, alongB));
        double s = Double3.Dot(Double3.Cross(between, alongB), across) / across.LengthSquared;
        double middle = Double3.Dot(between, along);
        return a + along * Math.Max(Math.Max(-half, middle - reach), Math.Min(Math.Min(half, middle + reach), s));
    }

    /// <summary>The middle of a box's edge that is furthest in a direction.</summary>
    private static Double3 MiddleOfEdge(in Double3 half, in Double3 direction, int edge) => new(
        edge == 0 ? 0 : half.X * Math.Sign(direction.X), edge == 1 ? 0 : half.Y * Math.Sign(direction.Y),
        edge == 2 ? 0 : half.Z * Math.Sign(direction.Z));

    private static double Along(in Double3 half, int axis) => axis == 0 ? half.X : axis == 1 ? half.Y : half.Z;

    private static Sides SidesOfA(in BoxPair p) => new(BoxPair.Unit(0), BoxPair.Unit(1), BoxPair.Unit(2), p.HalfA);

    private static Sides SidesOfB(in BoxPair pair) => new(pair.X, pair.Y, pair.Z, pair.HalfB);

    /// <summary>A box's axes and half of its sides, which may be 0.</summary>
    private readonly struct Sides(in Double3 x, in Double3 y, in Double3 z, in Double3 half)
    {
        private readonly Double3 _x = x, _y = y, _z = z, _half = half;

        public Double3 this[int index] => Axis(index) * Half(index);

        public Double3 Axis(int index) => index == 0 ? _x : index == 1 ? _y : _z;

        public double Half(int index) => Along(_half, index);
    }
}

/// <summary>What of a segment or parallelogram lies opposite a parallelogram: clipped by its four sides, one after the
/// other (Sutherland and Hodgman 1974).</summary>
internal static unsafe class FaceClip
{
    /// <summary>Count: four corners, and one more for each side that clips them; one to spare.</summary>
    private const int MostCorners = 9;

    /// <summary>The mean of the corners of what is left.</summary>
    /// <param name="middle">The middle of what is clipped.</param>
    /// <param name="first">Half of its one side.</param>
    /// <param name="second">Half of its other side; 0 for a segment.</param>
    /// <param name="center">The middle of what clips it.</param>
    /// <param name="u">The direction of that one's side.</param>
    /// <param name="halfU">Half of its length.</param>
    /// <param name="v">The direction of its other side, perpendicular to the first.</param>
    /// <param name="halfV">Half of its length.</param>
    /// <param name="slack">How far beside it a point still counts as opposite.</param>
    /// <param name="more">How far where nothing else does.</param>
    public static Double3 Middle(
        in Double3 middle, in Double3 first, in Double3 second, in Double3 center, in Double3 u, double halfU,
        in Double3 v, double halfV, double slack, double more)
    {
        Double3* corners = stackalloc Double3[MostCorners], clipped = stackalloc Double3[MostCorners];
        corners[0] = middle + first + second;
        corners[1] = middle + first - second;
        corners[2] = middle - first - second;
        corners[3] = middle - first + second;
        int count = 4;
        bool isLeft = TryClip(ref corners, ref count, ref clipped, center, u, halfU + slack)
            && TryClip(ref corners, ref count, ref clipped, center, -u, halfU + slack)
            && TryClip(ref corners, ref count, ref clipped, center, v, halfV + slack)
            && TryClip(ref corners, ref count, ref clipped, center, -v, halfV + slack);
        if (!isLeft && slack < more) return Middle(middle, first, second, center, u, halfU, v, halfV, more, more);
        Double3 sum = default;
        for (int i = 0; i < count; i++) sum += corners[i];
        return sum * (1.0 / count);
    }

    /// <summary>Leaves what lies no further from the centre along a direction than a reach, if anything does.</summary>
    private static bool TryClip(
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

        if (kept == 0) return false;
        Double3* left = to;
        to = from;
        from = left;
        count = kept;
        return true;
    }
}
