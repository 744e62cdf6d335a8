using System.Globalization;
using System.Numerics;
using System.Text;

namespace Gjk.Core;

/// <summary>A <see cref="ConvexShape"/> as words of a record. Numbers that a scale was multiplied into are doubles, and are written as such.</summary>
internal static class ShapeText
{
    public static void Write(StringBuilder text, in ConvexShape shape)
    {
        ShapeParts p = shape.Parts;
        text.Append(' ').Append(Name(p.Kind));
        switch (p.Kind)
        {
            case ShapeKind.Point:
                Add(text, p.InnerMargin);
                break;
            case ShapeKind.Segment:
                Add(text, p.A);
                Add(text, p.B);
                Add(text, p.InnerMargin);
                break;
            case ShapeKind.Triangle:
                Add(text, p.A);
                Add(text, p.B);
                Add(text, p.C);
                break;
            case ShapeKind.Mesh:
                WriteCorners(text, p.Hull!);
                break;
            default:
                Add(text, p.A);
                break;
        }

        if (p.Scale == new Vector3D(1, 1, 1)) return;
        text.Append(" *");
        Add(text, p.Scale);
    }

    public static ConvexShape Read(RecordReader words)
    {
        var p = new ShapeParts { Kind = ReadKind(words), Scale = new Vector3D(1, 1, 1) };
        switch (p.Kind)
        {
            case ShapeKind.Point:
                p.InnerMargin = words.Number();
                break;
            case ShapeKind.Segment:
                p.A = words.Vector();
                p.B = words.Vector();
                p.InnerMargin = words.Number();
                break;
            case ShapeKind.Triangle:
                p.A = words.Vector();
                p.B = words.Vector();
                p.C = words.Vector();
                break;
            case ShapeKind.Mesh:
                p.Hull = ReadCorners(words);
                break;
            default:
                p.A = words.Vector();
                if (p.A.X < 0 || p.A.Y < 0 || p.A.Z < 0) throw words.Wrong("ends a shape with a negative size");
                break;
        }

        if (p.InnerMargin < 0) throw words.Wrong("should not be negative");
        if (words.Peek == "*")
        {
            words.Expect("*");
            p.Scale = words.Vector();
            if (p.Scale.X == 0 || p.Scale.Y == 0 || p.Scale.Z == 0) throw words.Wrong("ends a scale with a factor of 0");
        }

        return new ConvexShape(p);
    }

    private static string Name(ShapeKind kind) => kind.ToString().ToLowerInvariant();

    private static ShapeKind ReadKind(RecordReader words)
    {
        string name = words.Word("a shape");
        for (ShapeKind kind = ShapeKind.Point; kind <= ShapeKind.Mesh; kind++)
        {
            if (Name(kind) == name) return kind;
        }

        throw words.Wrong("is no shape");
    }

    private static void WriteCorners(StringBuilder text, ConvexHull hull)
    {
        text.Append(' ').Append(hull.VertexCount.ToString(CultureInfo.InvariantCulture));
        for (int i = 0; i < hull.VertexCount; i++)
        {
            Vector3 corner = hull.GetVertex(i);
            foreach (float x in new[] { corner.X, corner.Y, corner.Z }) text.Append(' ').Append(x.ToString("G9", CultureInfo.InvariantCulture));
        }
    }

    private static ConvexHull ReadCorners(RecordReader words)
    {
        var corners = new Vector3[words.Count()];
        for (int i = 0; i < corners.Length; i++) corners[i] = new Vector3(words.Float(), words.Float(), words.Float());
        return words.Build(() => new ConvexHull(corners));
    }

    private static void Add(StringBuilder text, in Vector3D v)
    {
        Add(text, v.X);
        Add(text, v.Y);
        Add(text, v.Z);
    }

    /// <summary>Seventeen digits bring a double back.</summary>
    private static void Add(StringBuilder text, double number) =>
        text.Append(' ').Append(number.ToString("G17", CultureInfo.InvariantCulture));
}

/// <summary>What a <see cref="ConvexShape"/> is made of.</summary>
internal struct ShapeParts
{
    public ShapeKind Kind;
    public Vector3D A, B, C, Scale;
    public double InnerMargin;
    public ConvexHull? Hull;
}
