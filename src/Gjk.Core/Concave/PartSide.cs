namespace Gjk.Core;

/// <summary>One of a query's two shapes: its parts, their tree, and its pose.</summary>
internal sealed class PartSide
{
    private readonly PartTree _single = PartTree.Single();
    private ConvexShape _convex;
    private Double3 _low, _high;

    public RigidPose Pose;

    /// <summary>World units: by so much rounding may shift it against the objects that it is joined to. The parts of a
    /// compound share one pose, and are not shifted.</summary>
    public double Rounding => IsJoined ? CoveredSides.RoundingAt(Pose.Position) : 0;

    public PartTree Tree = null!;

    public TriangleMesh? Mesh;

    public CompoundShape? Compound;

    /// <summary>Whether it is a solid of its own, and not one in a compound.</summary>
    public bool IsSolid;

    /// <summary>The solids that its triangles enclose.</summary>
    public SolidInside[] Insides = [];

    /// <summary>Whether it is one of several static objects that count as one body.</summary>
    public bool IsJoined { get; private set; }

    /// <summary>Of a joined object: its pair's number in the scene's list.</summary>
    public int PairIndex;

    /// <summary>Of a joined object: the end of its pairs among all pairs.</summary>
    public int PairsEnd;

    /// <summary>Whether the body may go on in another part where one part ends.</summary>
    public bool HasJoints => Compound is not null || IsJoined;

    /// <summary>Whether a part may lie inside its own body.</summary>
    public bool MayHoldParts => IsSolid || HasJoints;

    /// <summary>Of A: what <see cref="ConcaveScratch.IsOneInside"/> has found; null before that.</summary>
    public bool? IsOneInside;

    /// <summary>World units: how far the parts reach beyond their boxes.</summary>
    public double Margin;

    /// <summary>The part number of a convex shape.</summary>
    public const int NoPart = -1;

    /// <summary>Whether it is a single point.</summary>
    public bool IsPoint => IsConvex && _convex.Kind is (ShapeKind.Point or ShapeKind.Sphere) && _convex.Margin == 0;

    /// <summary>Whether it is a half-space. Its box holds everything, so each part of the other shape is
    /// measured.</summary>
    public bool IsEndless => IsConvex && _convex.Kind == ShapeKind.HalfSpace;

    /// <summary>World units: its radius, given one of its parts. Joined objects count as endless: they go on where the
    /// body does not touch them.</summary>
    public double RadiusWith(in ConvexShape part) =>
        IsJoined ? double.PositiveInfinity : IsConvex ? part.BoundingRadius : Tree.Radius;

    /// <summary>Whether it is one convex part.</summary>
    public bool IsConvex => Mesh is null && !HasJoints;

    /// <summary>Joins it to other static objects, as one body.</summary>
    /// <param name="box">The box of the object in the world.</param>
    public void JoinOthers(in Aabb box)
    {
        Double3 min = box.Min, max = box.Max;
        double size = min.SumOfMagnitudes + max.SumOfMagnitudes + ((Double3)Pose.Position).SumOfMagnitudes;
        double room = 4 * CoveredSides.Room * size;
        var all = new Double3(room, room, room);
        (_low, _high, IsJoined) = (min - all, max + all, true);
    }

    /// <summary>Whether a point of the world may be in a joined object, or on it but for rounding.</summary>
    public bool MayHold(in Double3 point) =>
        point.X >= _low.X && point.X <= _high.X && point.Z >= _low.Z && point.Z <= _high.Z
        && point.Y >= _low.Y && point.Y <= _high.Y;

    /// <summary>A point of the world in its frame.</summary>
    public Double3 ToLocal(in Double3 point) => ToLocalDirection(point - Pose.Position);

    /// <summary>A direction of the world in its frame.</summary>
    public Double3 ToLocalDirection(in Double3 direction) => new RotationD(Pose.Rotation).InverseRotate(direction);

    /// <summary>A direction of its frame in the world.</summary>
    public Double3 ToWorldDirection(in Double3 direction) => new RotationD(Pose.Rotation).Rotate(direction);

    /// <summary>A point of its frame in the world.</summary>
    public Double3 ToWorld(in Double3 point) => CoveredSides.InWorld(point, Pose);

    /// <returns>False where the shape or the pose is a <c>default</c> struct.</returns>
    public bool TrySet(in AnyShape shape, in RigidPose pose)
    {
        if (shape.Kind == AnyShapeKind.None || !pose.IsValid) return false;
        Pose = pose;
        Mesh = shape.Mesh;
        Compound = shape.Compound;
        IsSolid = shape.Kind == AnyShapeKind.Solid;
        Insides = shape.Insides;
        Margin = 0;
        IsJoined = false;
        IsOneInside = null;
        Tree = Mesh?.Tree ?? Compound?.Tree ?? _single;
        if (!IsConvex) return true;
        _convex = AnyShape.ConvexOf(shape);
        Margin = _convex.Margin;
        Double3 max = new(HalfSpaceCore.Endless, HalfSpaceCore.Endless, HalfSpaceCore.Endless), min = -max;
        if (!IsEndless) CompoundShape.Box(_convex, 0, out min, out max);
        _single.SetSingle(min, max);
        return true;
    }

    /// <summary>A part as a convex shape; that of a convex shape is the whole. A triangle is written to
    /// <paramref name="room"/>.</summary>
    public ref readonly ConvexShape ShapeOf(int part, ref ConvexShape room)
    {
        if (Mesh is null) return ref ConvexPart(part);
        room = Mesh.GetShape(part);
        return ref room;
    }

    /// <summary>Whether a part is a triangle, of a mesh or among the parts of a compound.</summary>
    public bool IsTriangle(int part) =>
        Mesh is not null || (Compound is not null && Compound.Parts[part].Kind == ShapeKind.Triangle);

    /// <summary>A part of a compound, or the convex shape: no mesh has one.</summary>
    public ref readonly ConvexShape ConvexPart(int part)
    {
        if (Compound is not null) return ref Compound.Parts[part];
        return ref _convex;
    }

    /// <summary>The number of a part in results.</summary>
    public int NumberOf(int part) => IsConvex ? NoPart : part;

    /// <summary>Whether it has an inside that its parts do not hold.</summary>
    public bool HasInside => Insides.Length > 0;

    /// <summary>The inside, if all parts are the triangles around it; else null.</summary>
    public SolidInside? Solid => IsSolid || (HasInside && Compound!.Units[0] == Compound) ? Insides[0] : null;

    /// <summary>Whether each part is a triangle of a solid.</summary>
    public bool IsAllSolid => HasInside && (IsSolid || Compound!.Units.Length == Insides.Length);

    /// <summary>Whether queries treat it as a whole, and not each of a compound's solids in turn.</summary>
    public bool IsUnit => !HasInside || Solid is not null;

    /// <summary>A unit of a compound with solids; else the whole shape.</summary>
    public AnyShape UnitShape(int index) => Mesh is not null
        ? AnyShape.Surface(Mesh)
        : AnyShape.Of(IsUnit ? Compound! : Compound!.Units[index]);

    /// <summary>Replaces the compound by one of its units, or by the whole again, at the same pose.</summary>
    public void SetCompound(CompoundShape compound) =>
        (Compound, Tree, Insides) = (compound, compound.Tree, compound.Insides);

    /// <summary>1 where the corners of a solid's triangle run counter-clockwise seen from outside, else -1; 0 if the
    /// part is no triangle of a solid.</summary>
    public int OutwardOf(int part)
    {
        int low = 0, high = Insides.Length;
        while (low < high)
        {
            int middle = (low + high) / 2;
            SolidInside inside = Insides[middle];
            if (part < inside.First) high = middle;
            else if (part >= inside.End) low = middle + 1;
            else return inside.OutwardOf(part);
        }

        return 0;
    }

    /// <summary>The corners of a triangle.</summary>
    public void GetCorners(int part, out Double3 a, out Double3 b, out Double3 c)
    {
        if (Mesh is not null) Mesh.GetCorners(part, out a, out b, out c);
        else Compound!.GetCorners(part, out a, out b, out c);
    }

    /// <summary>The outward unit normal of a solid's triangle, and a corner of it, in the world.</summary>
    /// <returns>False where the triangle has no area, or is of no solid.</returns>
    public bool TryGetOutward(int part, out Double3 outward, out Double3 corner)
    {
        outward = corner = default;
        int sign = OutwardOf(part);
        if (sign == 0) return false;
        GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
        Double3 across = Double3.Cross((b - a) * (1 / Tree.Unit), (c - a) * (1 / Tree.Unit));
        double length = across.Length;
        var rotation = new RotationD(Pose.Rotation);
        corner = rotation.Rotate(a) + Pose.Position;
        if (length > 0) outward = rotation.Rotate(across * (sign / length));
        return length > 0;
    }

    /// <summary>The mesh of which all parts are triangles.</summary>
    private TriangleMesh? WholeMesh => Mesh ?? Solid?.Mesh;

    /// <summary>How many parts there are.</summary>
    public int PartCount => Mesh?.TriangleCount ?? Compound?.PartCount ?? 1;

    /// <summary>Whether its parts are the triangles of one mesh, which move out of a solid together.</summary>
    public bool IsMesh => WholeMesh is not null;

    /// <summary>How many connected pieces its parts have, at most.</summary>
    public int PieceCount => WholeMesh?.Components.Length ?? Compound?.PartCount ?? 1;

    /// <summary>A point of a piece, without rounding, and its part.</summary>
    public Double3 PointOf(int piece, out int part)
    {
        part = WholeMesh?.Components[piece] ?? piece;
        if (IsMesh)
        {
            GetCorners(part, out Double3 corner, out _, out _);
            return corner;
        }

        // Not the centre: that is the middle of a hull's box, which need not be in the hull.
        ref readonly ConvexShape shape = ref ConvexPart(part);
        shape.Support(new Double3(1, 0, 0), out Double3 point);
        return shape.Center + point;
    }

    /// <summary>The middle of a triangle, or a convex part's centre, in the world; double rounds it.</summary>
    public Double3 CenterOf(int part) =>
        ToWorld(Mesh is null ? ConvexPart(part).Center : MiddleOf(part));

    /// <summary>The middle of a triangle, or of a part's box, in the world.</summary>
    public Double3 MiddleOfPart(int part)
    {
        if (Compound is null) return CenterOf(part);
        (Double3 min, Double3 max) = Compound.Boxes[part];
        return ToWorld((min + max) * 0.5);
    }

    /// <summary>The middle of a piece's first triangle, or a point inside a convex part, rounded to double.</summary>
    public Double3 MiddleOf(int piece, out int part)
    {
        part = WholeMesh?.Components[piece] ?? piece;
        if (IsMesh) return MiddleOf(part);
        ref readonly ConvexShape shape = ref ConvexPart(part);
        Double3 sum = default;
        for (int i = 0; i < 6; i++)
        {
            double sign = i < 3 ? 1 : -1;
            shape.Support(
                new Double3(i % 3 == 0 ? sign : 0, i % 3 == 1 ? sign : 0, i % 3 == 2 ? sign : 0), out Double3 point);
            sum += point;
        }

        return shape.Center + sum * (1.0 / 6);
    }

    /// <summary>The middle of a triangle, rounded to double.</summary>
    public Double3 MiddleOf(int triangle)
    {
        GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        return TriangleShape.Centroid(a, b, c);
    }
}
