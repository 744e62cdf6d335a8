namespace Gjk.Core;

/// <summary>A part while a tree is built: its box, in tree units.</summary>
internal struct PartItem
{
    public PartBox Box;
    public int Part;

    /// <summary>A part with its box in the shape's frame.</summary>
    public PartItem(IPartSource source, int part)
    {
        source.GetBox(part, out Double3 min, out Double3 max);
        (Box, Part) = (new PartBox(min, max), part);
    }
}

/// <summary>Parts that follow each other while a tree is built.</summary>
internal readonly struct PartRange(int begin, int end, in PartBox box)
{
    public readonly int Begin = begin, End = end;

    /// <summary>The box of all of them.</summary>
    public readonly PartBox Box = box;

    /// <summary>Their surface times their count: the cost of leaving them together.</summary>
    public readonly double Weight = box.Area * (end - begin);

    public int Count => End - Begin;

    /// <summary>The parts from one to before another.</summary>
    public static PartRange Over(PartItem[] items, int begin, int end)
    {
        PartBox box = PartBox.Nothing;
        for (int i = begin; i < end; i++) box.Add(items[i].Box);
        return new PartRange(begin, end, box);
    }
}

/// <summary>The source of a shape's parts for the builder of a tree.</summary>
internal interface IPartSource
{
    /// <summary>How many parts there are; at least 1.</summary>
    int Count { get; }

    /// <summary>A part's box in the shape's frame; holds it for certain.</summary>
    void GetBox(int part, out Double3 min, out Double3 max);

    /// <summary>A part's three corners, where it is a triangle.</summary>
    bool TryGetTriangle(int part, out Double3 a, out Double3 b, out Double3 c);
}
