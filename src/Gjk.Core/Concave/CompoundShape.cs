namespace Gjk.Core;

/// <summary>The union of convex parts, triangles and solids, each in its place, with a tree for queries. Build it once
/// and share it: it is immutable, and any number of shapes and threads may use it. Parts keep the caller's
/// numbers.</summary>
/// <remarks>What it is made of are its children. Those of several parts are taken apart when it is built: parts have
/// their numbers in the order of the children, and those of one child in its own order. Poses are composed in double,
/// and no coordinate is rounded to float on the way, however deep a part was nested. A placed part takes some 300 to
/// 700 bytes, a triangle too, and one of a solid among other children some 350 more: several times as much as in a
/// <see cref="TriangleMesh"/>. It is a copy: <see cref="HeightField.SetHeights"/> does not change it. What is inside a
/// solid child is inside the compound.</remarks>
[DebuggerDisplay("{" + nameof(PartCount) + "} parts")]
public sealed partial class CompoundShape : IPartSource
{
    /// <summary>Ratio to a part's size: more than a curved support may lie inside its shape, so that a box of six
    /// supports holds it.</summary>
    private const double Outward = 1e-9;

    private readonly ConvexShape[] _parts;

    /// <summary>Of each child: the number of its first part; then the number of parts.</summary>
    private readonly int[] _firsts;

    private readonly RigidPose[] _poses;

    /// <summary>What this is a scaled copy of, with the children's poses before the scale; else null.</summary>
    private readonly CompoundShape? _unscaled;

    private readonly Vector3 _scale;

    /// <summary>The tree over the parts.</summary>
    internal readonly PartTree Tree;

    /// <summary>Builds a compound.</summary>
    /// <param name="parts">The children, at least one. Copied.</param>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The list is empty, or holds a <c>default</c> struct.</exception>
    public CompoundShape(IReadOnlyList<CompoundPart> parts)
    {
        CompoundPart[] children = CopyChildren(Guard.NotNull(parts, nameof(parts)));
        _poses = Array.ConvertAll(children, child => child.Pose);
        _firsts = new int[children.Length + 1];
        for (int i = 0; i < children.Length; i++) _firsts[i + 1] = _firsts[i] + children[i].Shape.PartCount;
        _parts = new ConvexShape[_firsts[children.Length]];
        for (int i = 0; i < children.Length; i++)
            for (int part = _firsts[i]; part < _firsts[i + 1]; part++)
                _parts[part] = children[i].Shape.PartAt(part - _firsts[i]).Placed(_poses[i]);
        Boxes = Array.ConvertAll(_parts, BoxOf);
        Tree = BuildTree(null);
        Insides = InsidesOf(children);
        Units = MakeUnits(null);
    }

    /// <summary>A compound whose children are elsewhere.</summary>
    private CompoundShape(CompoundShape like, RigidPose[] poses)
    {
        (_firsts, _poses) = (like._firsts, poses);
        _parts = (ConvexShape[])like._parts.Clone();
        Boxes = ((Double3, Double3)[])like.Boxes.Clone();
        for (int i = 0; i < poses.Length; i++)
        {
            for (int part = _firsts[i]; part < _firsts[i + 1] && poses[i] != like._poses[i]; part++)
            {
                _parts[part] = _parts[part].PlacedAnew(like._poses[i], poses[i]);
                Boxes[part] = BoxOf(_parts[part]);
            }
        }

        Tree = BuildTree(like.Tree);
        Insides = Array.ConvertAll(like.Insides, inside => inside.Moved(poses[GetChild(inside.First, out _)]));
        Units = MakeUnits(like);
    }

    /// <summary>A compound that is scaled.</summary>
    private CompoundShape(CompoundShape unscaled, Vector3 scale, CompoundShape? like)
    {
        (_firsts, _poses, _unscaled, _scale) = (unscaled._firsts, unscaled._poses, unscaled, scale);
        _parts = Array.ConvertAll(unscaled._parts, part => part.Scaled(scale));
        Boxes = Array.ConvertAll(_parts, BoxOf);
        Tree = BuildTree(like?.Tree);
        Insides = Array.ConvertAll(
            unscaled.Insides, inside => new SolidInside(inside, inside.First, RigidPose.Identity, scale));
        Units = MakeUnits(like);
    }

    /// <summary>How many convex parts and triangles there are, at least one.</summary>
    public int PartCount => _parts.Length;

    /// <summary>How many shapes it was made of, at least one.</summary>
    public int ChildCount => _poses.Length;

    /// <summary>A part, placed in the compound's frame.</summary>
    /// <param name="index">From 0 to <see cref="PartCount"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such part.</exception>
    public ConvexShape GetPart(int index) => _parts[CheckIndex(index, _parts.Length, nameof(index))];

    /// <summary>The child that a part is of.</summary>
    /// <param name="part">From 0 to <see cref="PartCount"/> - 1, as results name it.</param>
    /// <param name="partOfChild">The number that the part has in the child, from 0: a triangle of a mesh, a part of a
    /// compound; 0 of a convex shape.</param>
    /// <returns>From 0 to <see cref="ChildCount"/> - 1, as given.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such part.</exception>
    public int GetChild(int part, out int partOfChild)
    {
        int found = Array.BinarySearch(_firsts, CheckIndex(part, _parts.Length, nameof(part)));
        int child = found < 0 ? ~found - 1 : found;
        partOfChild = part - _firsts[child];
        return child;
    }

    /// <summary>Where a child is in the compound's frame, before its <see cref="Scaled"/>.</summary>
    /// <param name="child">From 0 to <see cref="ChildCount"/> - 1, as given.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such child.</exception>
    public RigidPose GetPose(int child) => _poses[CheckIndex(child, _poses.Length, nameof(child))];

    /// <summary>The same compound with a child elsewhere; <see cref="WithPoses"/> moves several at once.</summary>
    /// <param name="child">From 0 to <see cref="ChildCount"/> - 1, as given.</param>
    /// <param name="pose">Where the child is in the compound's frame, before its <see cref="Scaled"/>.</param>
    /// <returns>As of <see cref="WithPoses"/>.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such child, or the pose is a <c>default</c>
    /// struct.</exception>
    public CompoundShape WithPose(int child, in RigidPose pose)
    {
        CheckIndex(child, _poses.Length, nameof(child));
        var poses = (RigidPose[])_poses.Clone();
        poses[child] = Guard.Pose(pose, nameof(pose));
        return Moved(poses);
    }

    /// <summary>The same compound with its children elsewhere, as the limbs of a body that moves.</summary>
    /// <param name="poses">Where each child is in the compound's frame, before its <see cref="Scaled"/>; as many as
    /// there are children. Copied.</param>
    /// <returns>A compound with the same numbers and the answers of a new one; only of equally near parts another one
    /// may be named. Its tree keeps its form and is fitted to the new places: that is faster than a new build, and
    /// takes some 400 bytes for each part of the compound, and 300 more for each that moves. Build anew where parts
    /// have moved far from their neighbours.</returns>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">There are more or fewer poses.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A pose is a <c>default</c> struct.</exception>
    public CompoundShape WithPoses(IReadOnlyList<RigidPose> poses)
    {
        if (Guard.NotNull(poses, nameof(poses)).Count != _poses.Length)
            throw new ArgumentException($"There must be {_poses.Length} poses.", nameof(poses));
        var copy = new RigidPose[_poses.Length];
        for (int i = 0; i < copy.Length; i++) copy[i] = Guard.Pose(poses[i], nameof(poses));
        return Moved(copy);
    }

    /// <summary>The same parts scaled about the compound's origin.</summary>
    /// <param name="scale">Along its axes; negative factors mirror.</param>
    /// <returns>A compound that keeps this one, so that its children can still be moved.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A factor is 0, NaN or infinite.</exception>
    public CompoundShape Scaled(Vector3 scale) => new(this, Guard.Scale(scale, nameof(scale)), null);

    /// <summary>The parts, not to be written to.</summary>
    internal ConvexShape[] Parts => _parts;

    /// <summary>Boxes that hold the parts for certain.</summary>
    internal (Double3 Min, Double3 Max)[] Boxes { get; }

    /// <summary>A box of a convex shape in its own frame, margin included; holds it for certain.</summary>
    internal static void Box(in ConvexShape shape, double margin, out Double3 min, out Double3 max)
    {
        ConvexShape copy = shape;
        CoreExtent.Box(ref copy, out min, out max);
        double room = Outward * (max - min).SumOfMagnitudes + margin * (1 + Outward);
        var all = new Double3(room, room, room);
        min = shape.Center + min - all;
        max = shape.Center + max + all;
    }

    private PartTree BuildTree(PartTree? like) => like is null
        ? PartTreeBuilder.Build(this, leafSize: 1, mostInLeaf: 1)
        : PartTreeRefit.Fit(this, like);

    private CompoundShape Moved(RigidPose[] poses) => _unscaled is null
        ? new CompoundShape(this, poses)
        : new CompoundShape(_unscaled.Moved(poses), _scale, this);

    private static (Double3 Min, Double3 Max) BoxOf(ConvexShape part)
    {
        Box(part, part.Margin, out Double3 min, out Double3 max);
        return (min, max);
    }

    private static CompoundPart[] CopyChildren(IReadOnlyList<CompoundPart> parts)
    {
        var copy = new CompoundPart[Math.Max(parts.Count, 0)];
        if (copy.Length == 0) throw new ArgumentException("At least one part is needed.", nameof(parts));
        for (int i = 0; i < copy.Length; i++)
        {
            copy[i] = parts[i];
            if (copy[i].Shape.Kind == AnyShapeKind.None)
                throw new ArgumentException($"Part {i} is a default struct.", nameof(parts));
        }

        return copy;
    }

    private static int CheckIndex(int index, int count, string name) => (uint)index < (uint)count
        ? index
        : throw new ArgumentOutOfRangeException(name, index, $"There are {count}, counted from 0.");

    int IPartSource.Count => PartCount;

    void IPartSource.GetBox(int part, out Double3 min, out Double3 max) => (min, max) = Boxes[part];

    bool IPartSource.TryGetTriangle(int part, out Double3 a, out Double3 b, out Double3 c)
    {
        a = b = c = default;
        return false;
    }
}
