using System.Globalization;
using System.Text;

namespace Gjk.Core.Diagnostics;

/// <summary>A <see cref="ConvexShape"/> as words of a record. Numbers that a scale was multiplied into are doubles, and
/// are written as such. After the shape's own numbers come <c>*</c> with a scale, <c>+</c> with a radius that it was
/// rounded by, and <c>&gt;</c> with a rotation and a position that it was placed at, in the order in which they
/// apply.</summary>
internal static class ShapeText
{
    public static void Write(StringBuilder text, in ConvexShape shape)
    {
        ShapeParts p = shape.Parts;
        if (p.Layer is ScaledLayer scaled)
        {
            Write(text, scaled.Inner);
            Add(text.Append(" *"), scaled.Factors);
        }
        else
        {
            WriteCore(text, p);
        }

        if (p.Scaling is not null) Add(text.Append(" *"), p.Scale);
        if (p.Rounding > 0) Add(text.Append(" +"), p.Rounding);
        WritePoses(text, p.Placement);
    }

    private static void WritePoses(StringBuilder text, Placement? placement)
    {
        if (placement is null) return;
        WritePoses(text, placement.Before);
        Add(text.Append(" >"), placement.Pose);
    }

    /// <summary>The rotation (x y z w) and the position of a pose.</summary>
    public static void Add(StringBuilder text, in RigidPose pose)
    {
        Quaternion q = pose.Rotation;
        Vector3 p = pose.Position;
        foreach (float number in new[] { q.X, q.Y, q.Z, q.W, p.X, p.Y, p.Z }) Add(text, number);
    }

    /// <summary>The three components of a vector of floats.</summary>
    public static void Add(StringBuilder text, Vector3 v)
    {
        Add(text, v.X);
        Add(text, v.Y);
        Add(text, v.Z);
    }

    public static RigidPose ReadPose(RecordReader words)
    {
        var rotation = new Quaternion(words.Float(), words.Float(), words.Float(), words.Float());
        var position = new Vector3(words.Float(), words.Float(), words.Float());
        return words.Build(() => new RigidPose(rotation, position));
    }

    public static ConvexShape Read(RecordReader words)
    {
        var shape = new ConvexShape(ReadCore(words));
        while (words.Peek is "*" or "+" or ">")
        {
            string decorator = words.Word("a decorator");
            shape = decorator == ">" ? shape.Placed(ReadPose(words))
                : decorator == "+" ? Rounded(words, shape)
                : Scaled(words, shape);
        }

        return shape;
    }

    private static ConvexShape Rounded(RecordReader words, in ConvexShape shape)
    {
        ConvexShape inner = shape;
        if (shape.Kind == ShapeKind.HalfSpace) return words.Build(() => inner.Rounded(words.Float()));
        ShapeParts parts = shape.Parts;
        parts.Rounding += words.Number();
        if (parts.Rounding < 0) throw words.Wrong("should not be negative");
        return new ConvexShape(parts);
    }

    /// <summary>Factors behind a shape's own numbers are kept as they are; later ones scale what was
    /// decorated.</summary>
    private static ConvexShape Scaled(RecordReader words, in ConvexShape shape)
    {
        Double3 factors = words.Vector();
        if (factors.X == 0 || factors.Y == 0 || factors.Z == 0) throw words.Wrong("ends a scale with a factor of 0");
        ConvexShape inner = shape;
        if (shape.IsDecorated || shape.Kind == ShapeKind.HalfSpace)
            return words.Build(() => inner.Scaled((Vector3)factors));
        ShapeParts parts = shape.Parts;
        parts.Scale = Double3.Multiply(parts.Scale, factors);
        return new ConvexShape(parts);
    }

    private static void WriteCore(StringBuilder text, in ShapeParts p)
    {
        if (p.Kind == ShapeKind.Custom)
            throw new NotSupportedException("A shape of your own cannot be written as text.");
        text.Append(' ').Append(Name(p.Kind));
        if (p.Kind == ShapeKind.Mesh) WriteCorners(text, p.Hull!);
        (int vectors, bool hasMargin) = NumbersOf(p.Kind);
        if (vectors > 0) Add(text, p.A);
        if (vectors > 1) Add(text, p.B);
        if (vectors > 2) Add(text, p.C);
        if (hasMargin) Add(text, p.InnerMargin);
    }

    private static ShapeParts ReadCore(RecordReader words)
    {
        var p = new ShapeParts { Kind = ReadKind(words) };
        if (p.Kind == ShapeKind.Mesh) p.Hull = ReadCorners(words);
        (int vectors, bool hasMargin) = NumbersOf(p.Kind);
        if (vectors > 0) p.A = words.Vector();
        if (vectors == 1 && (p.A.X < 0 || p.A.Y < 0 || p.A.Z < 0))
            throw words.Wrong("ends a shape with a negative size");
        if (vectors > 1) p.B = words.Vector();
        if (vectors > 2) p.C = words.Vector();
        if (p.Kind == ShapeKind.HalfSpace && p.A == default) throw words.Wrong("ends a half-space without a normal");
        if (hasMargin) p.InnerMargin = words.Number();
        if (p.InnerMargin < 0) throw words.Wrong("should not be negative");
        if (p.InnerMargin > 0 && p.Kind == ShapeKind.Point) p.Kind = ShapeKind.Sphere;
        if (p.InnerMargin > 0 && p.Kind == ShapeKind.Segment) p.Kind = ShapeKind.Capsule;
        return p;
    }

    /// <summary>How many vectors a shape of a kind has, and whether a radius follows them.</summary>
    private static (int Vectors, bool HasMargin) NumbersOf(ShapeKind kind) => kind switch
    {
        ShapeKind.Point or ShapeKind.Sphere => (0, true),
        ShapeKind.Segment or ShapeKind.Capsule => (2, true),
        ShapeKind.Triangle or ShapeKind.HalfSpace => (3, false),
        ShapeKind.Mesh => (0, false),
        _ => (1, false),
    };

    /// <summary>A sphere is written as a point with a radius, a capsule as a segment with one.</summary>
    private static string Name(ShapeKind kind) => kind switch
    {
        ShapeKind.Sphere => Name(ShapeKind.Point),
        ShapeKind.Capsule => Name(ShapeKind.Segment),
        _ => kind.ToString().ToLowerInvariant(),
    };

    private static ShapeKind ReadKind(RecordReader words)
    {
        string name = words.Word("a shape");
        for (ShapeKind kind = ShapeKind.Point; kind < ShapeKind.Custom; kind++)
        {
            if (Name(kind) == name && Enum.IsDefined(typeof(ShapeKind), kind)) return kind;
        }

        throw words.Wrong("is no shape");
    }

    private static void WriteCorners(StringBuilder text, ConvexHull hull)
    {
        text.Append(' ').Append(hull.VertexCount.ToString(CultureInfo.InvariantCulture));
        for (int i = 0; i < hull.VertexCount; i++) Add(text, hull.GetVertex(i));
    }

    private static ConvexHull ReadCorners(RecordReader words)
    {
        var corners = new Vector3[words.Count()];
        for (int i = 0; i < corners.Length; i++) corners[i] = new Vector3(words.Float(), words.Float(), words.Float());
        return words.Build(() => new ConvexHull(corners));
    }

    private static void Add(StringBuilder text, in Double3 v)
    {
        Add(text, v.X);
        Add(text, v.Y);
        Add(text, v.Z);
    }

    /// <summary>Seventeen digits bring a double back.</summary>
    private static void Add(StringBuilder text, double number) =>
        text.Append(' ').Append(number.ToString("G17", CultureInfo.InvariantCulture));

    /// <summary>Nine digits bring a float back.</summary>
    private static void Add(StringBuilder text, float number) =>
        text.Append(' ').Append(number.ToString("G9", CultureInfo.InvariantCulture));
}
