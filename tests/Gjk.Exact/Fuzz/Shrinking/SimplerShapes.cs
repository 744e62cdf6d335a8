using System.Globalization;

namespace Gjk.Exact.Fuzz.Shrinking;

/// <summary>What a shape might be replaced by, the greatest simplifications first.</summary>
internal static class SimplerShapes
{
    private static readonly string[] Identity = ["0", "0", "0", "1"];

    public static IEnumerable<ShapeWords> Of(ShapeWords shape)
    {
        if (shape.Kind != "point") yield return shape with { Kind = "point", Numbers = ["0"], Scale = [] };
        if (shape.Motion.Count > 0) yield return shape with { Motion = [] };
        if (shape.Scale.Count > 0) yield return shape with { Scale = [] };
        if (!shape.Pose.Take(4).SequenceEqual(Identity))
            yield return shape with { Pose = [.. Identity, .. shape.Pose.Skip(4)] };
        if (shape.Pose.Skip(4).Any(p => p != "0"))
            yield return shape with { Pose = [.. shape.Pose.Take(4), "0", "0", "0"] };
        foreach (ShapeWords fewer in shape.Kind == ShapeWords.Mesh ? FewerCorners(shape) : []) yield return fewer;
        foreach (IReadOnlyList<string> numbers in Rounder(shape.Numbers)) yield return shape with { Numbers = numbers };
        foreach (IReadOnlyList<string> scale in Rounder(shape.Scale)) yield return shape with { Scale = scale };
        foreach (IReadOnlyList<string> pose in Rounder(shape.Pose)) yield return shape with { Pose = pose };
        foreach (IReadOnlyList<string> motion in Rounder(shape.Motion)) yield return shape with { Motion = motion };
    }

    /// <summary>Without the first half, the second half, each quarter and so on, down to single corners.</summary>
    private static IEnumerable<ShapeWords> FewerCorners(ShapeWords mesh)
    {
        int corners = mesh.Numbers.Count / 3;
        for (int size = corners / 2; size >= 1; size /= 2)
        {
            for (int start = 0; start + size <= corners; start += size)
            {
                int end = start + size;
                yield return mesh with { Numbers = [.. mesh.Numbers.Take(3 * start), .. mesh.Numbers.Skip(3 * end)] };
            }
        }
    }

    /// <summary>One number as 0 or with fewer digits.</summary>
    private static IEnumerable<IReadOnlyList<string>> Rounder(IReadOnlyList<string> numbers)
    {
        for (int i = 0; i < numbers.Count; i++)
        {
            foreach (string simpler in Rounder(numbers[i]))
            {
                string[] changed = [.. numbers];
                changed[i] = simpler;
                yield return changed;
            }
        }
    }

    private static IEnumerable<string> Rounder(string number)
    {
        double value = double.Parse(number, CultureInfo.InvariantCulture);
        if (value == 0) yield break;
        yield return "0";
        foreach (string format in (string[])["G1", "G2", "G4", "G6"])
        {
            string rounded = value.ToString(format, CultureInfo.InvariantCulture);
            if (rounded.Length >= number.Length) yield break;
            yield return rounded;
        }
    }
}
