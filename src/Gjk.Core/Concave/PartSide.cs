namespace Gjk.Core;

/// <summary>One of a query's two shapes: its parts, their tree and its pose.</summary>
internal sealed class PartSide
{
    private readonly PartTree _single = PartTree.Single();
    private ConvexShape _convex;
    private Double3 _low, _high;

    public RigidPose Pose;

    /// <summary>World units: what rounding may make of its place beside others that it is joined to; the parts of a
    /// compound are in their places as one.</summary>
    public double Rounding => IsJoined ? CoveredSides.RoundingAt(Pose.Position) : 0;

    public PartTree Tree = null!;

    public TriangleMesh? Mesh;

    public CompoundShape? Compound;

    /// <summary>Whether it is a solid of its own, and not one in a compound.</summary>
    public bool IsSolid;

    /// <summary>What it holds besides its parts.</summary>
    public SolidInside[] Insides = [];

    /// <summary>Whether it is one of several static objects that count as one body.</summary>
    public bool IsJoined { get; private set; }

    /// <summary>Of one that is joined: the number that the caller knows it by.</summary>
    public int Name;

    /// <summary>Of one that is joined: where its pairs end among those of all.</summary>
    public int PairsEnd;

    /// <summary>Whether its body may go on in another part where one of its parts ends.</summary>
    public bool HasJoints => Compound is not null || IsJoined;

    /// <summary>Whether a part may lie within the body that it is of.</summary>
    public bool MayHoldParts => IsSolid || HasJoints;

    /// <summary>World units: by so much the parts reach beyond their boxes.</summary>
    public double Margin;

    /// <summary>The number that a convex shape has instead of a part's.</summary>
    public const int NoPart = -1;

    /// <summary>Whether it is a single point.</summary>
    public bool IsPoint => IsConvex && _convex.Kind is (ShapeKind.Point or ShapeKind.Sphere) && _convex.Margin == 0;

    /// <summary>Whether it is a half-space: its box holds everything, so each part of the other is asked.</summary>
    public bool IsEndless => IsConvex && _convex.Kind == ShapeKind.HalfSpace;

    /// <summary>World units: how far it reaches around its middle, given a part of it. Static objects that are joined
    /// go on where the body does not touch them.</summary>
    public double RadiusWith(in ConvexShape part) =>
        IsJoined ? double.PositiveInfinity : IsConvex ? part.BoundingRadius : Tree.Radius;

    /// <summary>Whether it is one convex part.</summary>
    public bool IsConvex => Mesh is null && !HasJoints;

    /// <summary>Joins it to other static objects.</summary>
    /// <param name="box">Holds it, in the world.</param>
    public void Join(in Aabb box)
    {
        Double3 min = box.Min, max = box.Max;
        double size = min.SumOfMagnitudes + max.SumOfMagnitudes + ((Double3)Pose.Position).SumOfMagnitudes;
        double room = 4 * CoveredSides.Room * size;
        var all = new Double3(room, room, room);
        (_low, _high, IsJoined) = (min - all, max + all, true);
    }

    /// <summary>Whether a point of the world may be in one that is joined, or as good as on it.</summary>
    public bool MayHold(in Double3 point) =>
        point.X >= _low.X && point.X <= _high.X && point.Z >= _low.Z && point.Z <= _high.Z
        && point.Y >= _low.Y && point.Y <= _high.Y;

    /// <summary>A point of the world in its frame.</summary>
    public Double3 Local(in Double3 point) => new RotationD(Pose.Rotation).InverseRotate(point - Pose.Position);

    /// <summary>A direction of the world in its frame.</summary>
    public Double3 Turned(in Double3 direction) => new RotationD(Pose.Rotation).InverseRotate(direction);

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
        Tree = Mesh?.Tree ?? Compound?.Tree ?? _single;
        if (!IsConvex) return true;
        _convex = AnyShape.ConvexOf(shape);
        Margin = _convex.Margin;
        Double3 max = new(HalfSpaceCore.Endless, HalfSpaceCore.Endless, HalfSpaceCore.Endless), min = -max;
        if (!IsEndless) CompoundShape.Box(_convex, 0, out min, out max);
        _single.SetSingle(min, max);
        return true;
    }

    /// <summary>A part as a convex shape, of a convex shape the whole; it may be written to the room that is
    /// given.</summary>
    public ref readonly ConvexShape Part(int part, ref ConvexShape room)
    {
        if (Mesh is null) return ref Convex(part);
        room = Mesh.GetShape(part);
        return ref room;
    }

    /// <summary>Whether a part is a triangle, of a mesh or among the parts of a compound.</summary>
    public bool IsTriangle(int part) =>
        Mesh is not null || (Compound is not null && Compound.Parts[part].Kind == ShapeKind.Triangle);

    /// <summary>A part of what is no mesh.</summary>
    public ref readonly ConvexShape Convex(int part)
    {
        if (Compound is not null) return ref Compound.Parts[part];
        return ref _convex;
    }

    /// <summary>The number of a part in results.</summary>
    public int NumberOf(int part) => IsConvex ? NoPart : part;

    /// <summary>Whether it has an inside that its parts do not hold.</summary>
    public bool HasInside => Insides.Length > 0;

    /// <summary>The inside, where all parts are the triangles around it; else null.</summary>
    public SolidInside? Solid => IsSolid || (HasInside && Compound!.Units[0] == Compound) ? Insides[0] : null;

    /// <summary>Whether each part is a triangle of a solid.</summary>
    public bool IsAllSolid => HasInside && (IsSolid || Compound!.Units.Length == Insides.Length);

    /// <summary>Whether it is asked as a whole, and not as a compound whose solids are asked one by one.</summary>
    public bool IsUnit => !HasInside || Solid is not null;

    /// <summary>A unit of a compound with solids; else all of it.</summary>
    public AnyShape Unit(int index) => Mesh is not null
        ? AnyShape.Surface(Mesh)
        : AnyShape.Of(IsUnit ? Compound! : Compound!.Units[index]);

    /// <summary>Takes another compound at the same pose: a unit of the one, or all of it again.</summary>
    public void Take(CompoundShape compound) =>
        (Compound, Tree, Insides) = (compound, compound.Tree, compound.Insides);

    /// <summary>1 where the corners of a solid's triangle run counter-clockwise seen from outside, else -1; 0 of what
    /// is no triangle of a solid.</summary>
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

    /// <summary>The unit normal of a solid's triangle that leads out of the solid, and a corner of it, in the
    /// world.</summary>
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
    private TriangleMesh? Whole => Mesh ?? Solid?.Mesh;

    /// <summary>How many parts there are.</summary>
    public int PartCount => Mesh?.TriangleCount ?? Compound?.PartCount ?? 1;

    /// <summary>Whether its parts are those of one mesh, which leave together.</summary>
    public bool IsMesh => Whole is not null;

    /// <summary>How many connected pieces its parts have, at most.</summary>
    public int PieceCount => Whole?.Components.Length ?? Compound?.PartCount ?? 1;

    /// <summary>A point of a piece, as exact as the piece is given, and the part that it is of.</summary>
    public Double3 PointOf(int piece, out int part)
    {
        part = Whole?.Components[piece] ?? piece;
        if (IsMesh)
        {
            GetCorners(part, out Double3 corner, out _, out _);
            return corner;
        }

        // Not the centre, which is the middle of a hull's box and need not be in the hull.
        ref readonly ConvexShape shape = ref Convex(part);
        shape.Support(new Double3(1, 0, 0), out Double3 point);
        return shape.Center + point;
    }

    /// <summary>The middle of a triangle, or a convex part's centre, in the world; double rounds it.</summary>
    public Double3 CenterOf(int part) =>
        CoveredSides.InWorld(Mesh is null ? Convex(part).Center : MiddleOf(part), Pose);

    /// <summary>The middle of a triangle, or of a part's box, in the world.</summary>
    public Double3 MiddleOfPart(int part)
    {
        if (Compound is null) return CenterOf(part);
        (Double3 min, Double3 max) = Compound.Boxes[part];
        return CoveredSides.InWorld((min + max) * 0.5, Pose);
    }

    /// <summary>The middle of a piece's first triangle, or a point inside a convex part, as double has it.</summary>
    public Double3 MiddleOf(int piece, out int part)
    {
        part = Whole?.Components[piece] ?? piece;
        if (IsMesh) return MiddleOf(part);
        ref readonly ConvexShape shape = ref Convex(part);
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

    /// <summary>The middle of a triangle, as double has it.</summary>
    public Double3 MiddleOf(int triangle)
    {
        GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        return TriangleShape.Centroid(a, b, c);
    }
}
