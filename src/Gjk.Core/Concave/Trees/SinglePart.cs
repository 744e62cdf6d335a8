namespace Gjk.Core;

/// <summary>Writes the tree of one part, which a convex shape is to the searches.</summary>
internal static class SinglePart
{
    /// <summary>Ratio: 2^-22, more than rounding the half side to float takes.</summary>
    private const double Outward = 1 + 1.0 / (1 << 22);

    /// <param name="tree">Made by <see cref="PartTree.Single"/>.</param>
    /// <param name="min">Of a box that holds the part, in its own frame.</param>
    /// <param name="max">The other corner of the box.</param>
    public static void Write(PartTree tree, in Double3 min, in Double3 max)
    {
        tree.Origin = (min + max) * 0.5;
        Double3 half = (max - min) * (0.5 * Outward);
        double most = half.SumOfMagnitudes;
        tree.Unit = most > 0 ? PowerOfTwo.AtMost(Math.Max(most, float.Epsilon)) : 1;
        half *= 1 / tree.Unit;
        tree.Radius = half.Length * tree.Unit * Outward;
        tree.Boxes[PartTree.Halves] = (float)half.X;
        tree.Boxes[PartTree.Halves + PartTree.Lanes] = (float)half.Y;
        tree.Boxes[PartTree.Halves + 2 * PartTree.Lanes] = (float)half.Z;
    }
}
