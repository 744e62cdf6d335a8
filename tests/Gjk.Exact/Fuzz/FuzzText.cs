using System.Globalization;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz;

/// <summary>A pair as a record's line and back. The library writes a mesh as its hull's corners; this writes the points
/// that it was made of, or a hull that lost one could not be shown.</summary>
internal static class FuzzText
{
    private const string Tag = "gjk1";

    public static string Of(in FuzzShape a, in RigidMotion motionA, in FuzzShape b, in RigidMotion motionB)
    {
        Queue<string> words = Words(new QueryRecord(a.Shape, motionA, b.Shape, motionB).ToString());
        return Of(WithCloud(ShapeWords.Read(words), a.Cloud), WithCloud(ShapeWords.Read(words), b.Cloud));
    }

    public static string Of(ShapeWords a, ShapeWords b) => $"{Tag} {a} {b}";

    public static (ShapeWords A, ShapeWords B) Split(string text)
    {
        Queue<string> words = Words(text);
        ShapeWords a = ShapeWords.Read(words);
        return (a, ShapeWords.Read(words));
    }

    /// <summary>The shapes of a record and where they are. False for what is no record, for a scale that is not of
    /// floats, for rounded or placed shapes, and for shapes that turn.</summary>
    public static bool TryRead(string text, out FuzzShape shapeA, out FuzzShape shapeB, out QueryRecord record)
    {
        (shapeA, shapeB) = (default, default);
        if (!QueryRecord.TryParse(text, out record, out _)) return false;
        if (record.A.IsDecorated || record.B.IsDecorated) return false;
        if (record.MotionA.AngularVelocity != default || record.MotionB.AngularVelocity != default) return false;
        (ShapeWords a, ShapeWords b) = Split(text);
        if (!HasFloatScale(a) || !HasFloatScale(b)) return false;
        (shapeA, shapeB) = (Shape(record.A, a), Shape(record.B, b));
        return true;
    }

    private static Queue<string> Words(string text) => new(text.Split(' ').Skip(1));

    private static ShapeWords WithCloud(ShapeWords words, IReadOnlyList<Vector3>? cloud) =>
        cloud is null
            ? words
            : words with { Numbers = [.. cloud.SelectMany(p => (string[])[Word(p.X), Word(p.Y), Word(p.Z)])] };

    private static FuzzShape Shape(in ConvexShape shape, ShapeWords words)
    {
        if (shape.Kind != ShapeKind.Mesh) return shape;
        var cloud = new Vector3[words.Numbers.Count / 3];
        for (int i = 0; i < cloud.Length; i++)
            cloud[i] = new Vector3(
                Number(words.Numbers[3 * i]), Number(words.Numbers[3 * i + 1]), Number(words.Numbers[3 * i + 2]));
        return FuzzShape.Of(shape, cloud);
    }

    /// <summary>A record may hold other factors, but no user can give them to a shape.</summary>
    private static bool HasFloatScale(ShapeWords words) =>
        words.Scale.All(w => double.Parse(w, CultureInfo.InvariantCulture) == Number(w));

    private static float Number(string word) => float.Parse(word, CultureInfo.InvariantCulture);

    private static string Word(float x) => x.ToString("G9", CultureInfo.InvariantCulture);
}
