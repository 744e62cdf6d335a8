namespace Gjk.Core;

/// <summary>Proves that parts are no nearer than the least distance so far: a plane across its normal leaves a gap
/// between them.</summary>
/// <remarks>Between parallel plates as many pairs of triangles are equally near as there are triangles, and the boxes'
/// bounds in float rule none of them out. Here corners are measured in double. A whole subtree is dropped if its gap
/// exceeds the middle between the distance and the float before it: all its distances then round to that distance or
/// more. While nothing is near enough, the plane of two parts that are too far apart rules out others. The reach of a
/// subtree is kept until the normal changes.</remarks>
internal sealed class PlaneProof
{
    /// <summary>Ratio to twice the lengths: 2^-49, 16 roundings. Rotating the normal into a shape's axes takes 15
    /// roundings at most, its product with a corner and the sums 3. With four times as much, every pair of plates a
    /// millionth apart is measured; a quarter is not proved.</summary>
    public const double Error = 1.0 / (1L << 49);

    /// <summary>Ratio to twice the lengths: what is further apart does not touch. It is four times what the queries
    /// count as touching where a core is curved. More only costs time; SmallBesideLargeTests fails with less.</summary>
    private const double TouchRoom = 4 * GjkTolerances.TouchCurved;

    /// <summary>Ratio to the sizes and the way of a cast: 2^-45, 256 roundings: triangles that stay further apart do
    /// not meet. They touch within 16 roundings of their radii (<see cref="GjkTolerances.Touch"/>), and a plane that
    /// was crossed counts as met within 128 of radii and way (<see cref="CastJump"/>). PlateTests asks for all parts
    /// with the room of curved cores.</summary>
    public const double TriangleRoom = 1.0 / (1L << 45);

    /// <summary>A cosine: normals that differ by less than 2e-4 are taken to be the same. Between plates a millionth of
    /// their size apart a distance's accuracy allows so much. Any unit vector gives a proof; another one only fails
    /// more often.</summary>
    private const double Aligned = 1 - 2e-8;

    /// <summary>Count: so many corners of the larger mesh are read before all are.</summary>
    private const int Looks = 64;

    private readonly Reaches _a = new(), _b = new();
    private Double3 _alongA, _alongB;
    private double _limit, _between, _room, _wholeRoom;
    private Double3 _normal, _way;
    private int _version, _tried;

    /// <summary>Whether there is a plane.</summary>
    public bool IsSet { get; private set; }

    /// <summary>Whether there is a plane that <see cref="IsWholeNoNearer"/> has not been asked about.</summary>
    public bool IsUntried => IsSet && _tried != _version;

    /// <summary>No pair that is dropped is nearer than this, rounded down.</summary>
    public float LowerBound => RoundOff.Down(_limit);

    /// <summary>Forgets the last query's plane.</summary>
    public void Clear() => (IsSet, _room, _wholeRoom) = (false, 0, 0);

    /// <summary>Forgets the last query's plane, for a cast by B's motion relative to A, in the world, for the fraction
    /// 1.</summary>
    public void BeginCast(PartSide a, PartSide b, in Double3 way)
    {
        (IsSet, _way) = (false, way);
        _room = a.Mesh is not null && b.Mesh is not null ? TriangleRoom : TouchRoom;
    }

    /// <summary>Sets the plane of two parts that are apart. Parts are dropped that are no nearer than these.</summary>
    public void SetNearest(PartSide a, int partA, PartSide b, int partB, in DistanceResult best)
    {
        IsSet = !best.IsOverlapping && best.Distance > 0;
        if (!IsSet) return;
        SetPlaneOfParts(a, partA, b, partB, best.Normal, Aligned);
        _limit = 0.5 * ((double)best.Distance + RoundOff.Down(best.Distance * (1 - 1.0 / (1 << 26))));
    }

    /// <summary>Sets the plane of two parts that are further apart than the limit. Parts are dropped that are,
    /// too.</summary>
    public void SetBeyond(PartSide a, int partA, PartSide b, int partB, Vector3 normal, float limit)
    {
        double lengths = SetPlaneOfParts(a, partA, b, partB, normal, 0);
        IsSet = true;
        _limit = LimitWithRoom(limit, lengths);
    }

    /// <summary>Sets the plane of a flat mesh, and tells whether it proves at once that no two parts are within a
    /// limit.</summary>
    public bool IsSlabBeyond(PartSide a, PartSide b, float limit)
    {
        if (a.Mesh is null || b.Mesh is null || (a.Mesh.Slab ?? b.Mesh.Slab) is not { } slab) return false;
        Double3 normal = new RotationD((slab == a.Mesh.Slab ? a : b).Pose.Rotation).Rotate(slab.Normal);
        double lengths = SetPlane(a, b, normal);
        double side = _between - Double3.Dot(_alongA, a.Tree.Origin) - Double3.Dot(_alongB, b.Tree.Origin);
        if (side < 0) SetPlane(a, b, -normal);
        _limit = LimitWithRoom(limit, lengths);
        return IsSlabGap(a.Mesh, b.Mesh);
    }

    /// <summary>Sets the plane of two parts that a cast does not bring together. Parts are dropped that it does not
    /// bring together either.</summary>
    /// <param name="a">The first side, at the start.</param>
    /// <param name="partA">A part of it.</param>
    /// <param name="b">The second side.</param>
    /// <param name="partB">A part of it.</param>
    /// <param name="normal">The normal of their distance.</param>
    /// <param name="isFace">Whether to take a triangle's own plane, at whatever angle to the normal.</param>
    /// <param name="most">The last fraction.</param>
    public void SetCast(
        PartSide a, int partA, PartSide b, int partB, Vector3 normal, bool isFace, double most)
    {
        double lengths = SetPlaneOfParts(a, partA, b, partB, normal, isFace ? 0 : Aligned);
        double closing = Math.Max(-Double3.Dot(_normal, _way), 0) + TriangleRoom * _way.SumOfMagnitudes;
        IsSet = true;
        _limit = Error * lengths + closing * most;
        _wholeRoom = _room * lengths;
    }

    /// <summary>Whether a triangle's own plane shows that two parts are no nearer.</summary>
    public bool IsFaceNoNearer(PartSide a, int partA, PartSide b, int partB)
    {
        if (!IsSet) return false;
        Double3 between = b.CenterOf(partB) - a.CenterOf(partA);
        return IsFaceGap(a, partA, b, partB, a, partA, between) || IsFaceGap(a, partA, b, partB, b, partB, between);
    }

    private bool IsFaceGap(PartSide a, int partA, PartSide b, int partB, PartSide side, int part, in Double3 direction)
    {
        Double3 normal = direction;
        if (!TryUseFaceNormal(side, part, 0, ref normal)) return false;
        ToBothFrames(a, b, normal, out Double3 alongA, out Double3 alongB, out double between);
        return between - ReachOf(a, partA, alongA) - ReachOf(b, partB, alongB) > _limit;
    }

    /// <summary>Whether a plane across the line of two parts' centres proves that they are further apart than the
    /// limit. It rules out most parts that a box lets pass, and costs far less than the exact query. It leaves the
    /// plane that is set.</summary>
    public static bool IsBeyond(PartSide a, int partA, PartSide b, int partB, float limit)
    {
        Double3 normal = b.CenterOf(partB) - a.CenterOf(partA);
        normal *= 1 / normal.Length;
        double lengths = ToBothFrames(a, b, normal, out Double3 alongA, out Double3 alongB, out double between);
        return between - ReachOf(a, partA, alongA) - ReachOf(b, partB, alongB) > LimitWithRoom(limit, lengths);
    }

    private static double LimitWithRoom(float limit, double lengths) =>
        limit * (1 + GjkTolerances.FloatBand) + TouchRoom * lengths;

    /// <summary>Sets the plane across a direction, or that of a triangle whose normal has at least the cosine to it.
    /// Returns the lengths that rounding is measured by.</summary>
    private double SetPlaneOfParts(PartSide a, int partA, PartSide b, int partB, Vector3 direction, double aligned)
    {
        Double3 normal = direction;
        normal *= 1 / normal.Length;
        if (!TryUseFaceNormal(a, partA, aligned, ref normal)) TryUseFaceNormal(b, partB, aligned, ref normal);
        return SetPlane(a, b, normal);
    }

    private double SetPlane(PartSide a, PartSide b, in Double3 normal)
    {
        _version++;
        _normal = normal;
        return ToBothFrames(a, b, normal, out _alongA, out _alongB, out _between);
    }

    /// <summary>Gives a normal in both sides' axes, and how far apart the origins are along it, less what rounding may
    /// do. Returns the lengths that this is measured by.</summary>
    private static double ToBothFrames(
        PartSide a, PartSide b, in Double3 normal, out Double3 alongA, out Double3 alongB, out double between)
    {
        alongA = a.ToLocalDirection(normal);
        alongB = -b.ToLocalDirection(normal);
        Double3 origins = (Double3)b.Pose.Position - a.Pose.Position;
        double lengths = origins.SumOfMagnitudes + LengthsOf(a) + LengthsOf(b);
        between = Double3.Dot(normal, origins) - Error * lengths;
        return lengths;
    }

    /// <summary>Whether no pair of parts at all is nearer. Each plane is tried once. A few corners show of most planes
    /// that they do not separate.</summary>
    public bool IsWholeNoNearer(PartSide a, PartSide b)
    {
        _tried = _version;
        if (a.Mesh is null || b.Mesh is null) return false;
        int some = Math.Max(1, Math.Max(a.Mesh.VertexCount, b.Mesh.VertexCount) / Looks);
        return IsSlabGap(a.Mesh, b.Mesh) || (IsGap(a.Mesh, b.Mesh, some) && IsGap(a.Mesh, b.Mesh, 1));
    }

    private bool IsSlabGap(TriangleMesh a, TriangleMesh b) =>
        _between - SlabReach(a, _alongA) - SlabReach(b, _alongB) > _limit + _wholeRoom;

    /// <summary>A bound of how far a mesh reaches, without reading its vertices.</summary>
    private static double SlabReach(TriangleMesh mesh, in Double3 along) =>
        mesh.Slab?.Reach(along) ?? Double3.Dot(along, mesh.Tree.Origin) + mesh.Tree.Radius;

    private bool IsGap(TriangleMesh a, TriangleMesh b, int step) =>
        _between - a.Reach(_alongA, step) - b.Reach(_alongB, step) > _limit + _wholeRoom;

    /// <summary>Whether no pair of parts below two boxes is nearer.</summary>
    public bool IsNoNearer(PartSide a, int boxA, PartSide b, int boxB) =>
        _between - _a.BelowBox(a, boxA, _alongA, _room, _version) - _b.BelowBox(b, boxB, _alongB, _room, _version)
        > _limit;

    /// <summary>Whether a part of A is no nearer than what is below a box of B.</summary>
    public bool IsNoNearerPart(PartSide a, int partA, PartSide b, int boxB) =>
        _between - ReachOf(a, partA, _alongA) - _b.BelowBox(b, boxB, _alongB, _room, _version) > _limit;

    /// <inheritdoc cref="IsNoNearerPart"/>
    public bool IsPartNoNearer(PartSide a, int boxA, PartSide b, int partB) =>
        _between - _a.BelowBox(a, boxA, _alongA, _room, _version) - ReachOf(b, partB, _alongB) > _limit;

    /// <summary>Replaces a normal by a triangle's own one if that is close enough, since rounding to float tilts a
    /// plane.</summary>
    private static bool TryUseFaceNormal(PartSide side, int part, double aligned, ref Double3 normal)
    {
        if (side.Mesh is null) return false;
        side.Mesh.GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
        Double3 face = side.ToWorldDirection(Double3.Cross(b - a, c - a));
        face *= 1 / face.Length;
        double along = Double3.Dot(face, normal);
        if (!(Math.Abs(along) > aligned)) return false;
        normal = along > 0 ? face : -face;
        return true;
    }

    /// <summary>How far a part reaches along a direction of its shape's frame, and a share of its size beyond
    /// that.</summary>
    public static double ReachOf(PartSide side, int part, in Double3 along, double room = 0)
    {
        if (side.Mesh is not null)
        {
            side.Mesh.GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
            double reach = Math.Max(Math.Max(Double3.Dot(along, a), Double3.Dot(along, b)), Double3.Dot(along, c));
            return reach + room * ((b - a).SumOfMagnitudes + (c - a).SumOfMagnitudes);
        }

        ref readonly ConvexShape shape = ref side.ConvexPart(part);
        shape.Support(along, out Double3 point);
        return Double3.Dot(along, shape.Center + point) + shape.Margin + room * (shape.BoundingRadius + shape.Margin);
    }

    /// <summary>Twice the lengths of a side that rounding is measured by.</summary>
    public static double LengthsOf(PartSide side) =>
        2 * (side.Tree.Origin.SumOfMagnitudes + side.Tree.Radius) + side.Margin;

    /// <summary>Keeps how far the parts below each box of a side reach along the normal.</summary>
    private sealed class Reaches
    {
        private double[] _values = [];
        private int[] _versions = [];

        public double BelowBox(PartSide side, int box, in Double3 along, double room, int version)
        {
            int boxes = side.Tree.Children.Length;
            if (_values.Length < boxes)
            {
                _values = new double[boxes];
                _versions = new int[boxes];
            }

            return Find(side, box, along, room, version);
        }

        private double Find(PartSide side, int box, in Double3 along, double room, int version)
        {
            if (_versions[box] == version) return _values[box];
            PartTree tree = side.Tree;
            int child = tree.Children[box];
            double most = double.NegativeInfinity;
            if (child >= 0)
            {
                for (int i = PartTree.Lanes * child; i < PartTree.Lanes * (child + 1); i++)
                    if (tree.Children[i] != PartTree.Empty) most = Math.Max(most, Find(side, i, along, room, version));
            }
            else
            {
                int first = PartTree.FirstOf(child), end = first + PartTree.CountOf(child);
                for (int i = first; i < end; i++) most = Math.Max(most, ReachOf(side, tree.Order[i], along, room));
            }

            _versions[box] = version;
            return _values[box] = most;
        }
    }
}
