namespace Gjk.Core;

/// <summary>The union of convex parts, each in its place, with a tree for queries. Build it once and share it: it is
/// immutable, and any number of shapes and threads may use it. Parts keep the caller's numbers.</summary>
[DebuggerDisplay("{" + nameof(PartCount) + "} parts")]
public sealed class CompoundShape
{
    /// <summary>Ratio to a part's size: more than a curved support may lie inside its shape, so that a box of six
    /// supports holds it.</summary>
    private const double Outward = 1e-9;

    private readonly ConvexShape[] _parts;

    /// <summary>The tree over the parts.</summary>
    internal readonly PartTree Tree;

    /// <summary>Builds a compound.</summary>
    /// <param name="parts">At least one. Copied.</param>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The list is empty, or holds a <c>default</c> struct.</exception>
    public CompoundShape(IReadOnlyList<CompoundPart> parts)
        : this(Placed(Guard.NotNull(parts, nameof(parts))))
    {
    }

    private CompoundShape(ConvexShape[] parts)
    {
        _parts = parts;
        Boxes = Array.ConvertAll(parts, part =>
        {
            Box(part, part.Margin, out Double3 min, out Double3 max);
            return (min, max);
        });
        Tree = PartTreeBuilder.Build(Source, leafSize: 1, mostInLeaf: 1);
    }

    /// <summary>How many parts there are, at least one.</summary>
    public int PartCount => _parts.Length;

    /// <summary>A part, placed in the compound's frame.</summary>
    /// <param name="index">From 0 to <see cref="PartCount"/> - 1, as given.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such part.</exception>
    public ConvexShape GetPart(int index)
    {
        if ((uint)index >= (uint)_parts.Length)
            throw new ArgumentOutOfRangeException(nameof(index), index, "There is no such part.");
        return _parts[index];
    }

    /// <summary>The same parts scaled about the compound's origin.</summary>
    /// <param name="scale">Along its axes; negative factors mirror.</param>
    /// <exception cref="ArgumentOutOfRangeException">A factor is 0, NaN or infinite.</exception>
    public CompoundShape Scaled(Vector3 scale)
    {
        Guard.Scale(scale, nameof(scale));
        return new CompoundShape(Array.ConvertAll(_parts, part => part.Scaled(scale)));
    }

    /// <summary>Volume, mass, centre of mass and inertia: the sum of the parts, so that what lies in two of them counts
    /// twice.</summary>
    /// <param name="density">Mass in a unit of volume, of all parts; at least 0 and finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The density is negative, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">A part has none; see
    /// <see cref="ConvexShape.GetMassProperties"/>.</exception>
    public MassProperties GetMassProperties(float density = 1)
    {
        MassProperties all = _parts[0].GetMassProperties(density);
        for (int i = 1; i < _parts.Length; i++) all += _parts[i].GetMassProperties(density);
        return all;
    }

    /// <summary>The parts as a tree is built of them.</summary>
    internal IPartSource Source => new PartSource(this);

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

    private static ConvexShape[] Placed(IReadOnlyList<CompoundPart> parts)
    {
        var placed = new ConvexShape[Math.Max(parts.Count, 0)];
        if (placed.Length == 0) throw new ArgumentException("At least one part is needed.", nameof(parts));
        for (int i = 0; i < placed.Length; i++)
        {
            CompoundPart part = parts[i];
            if (part.Shape.Kind == ShapeKind.None)
                throw new ArgumentException($"Part {i} is a default struct.", nameof(parts));
            placed[i] = part.Shape.Placed(part.Pose);
        }

        return placed;
    }

    private sealed class PartSource(CompoundShape compound) : IPartSource
    {
        public int Count => compound.PartCount;

        public void GetBox(int part, out Double3 min, out Double3 max) => (min, max) = compound.Boxes[part];

        public bool TryGetTriangle(int part, out Double3 a, out Double3 b, out Double3 c)
        {
            a = b = c = default;
            return false;
        }
    }
}
