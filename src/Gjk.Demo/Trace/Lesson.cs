using System.Text.Json;

namespace Gjk.Demo.Trace;

/// <summary>The two algorithms as the page prints them beside the picture. Each line has an id, by which the page
/// lights it, and says where the source does it.</summary>
internal static class Lesson
{
    private const string Core = "src/Gjk.Core/", Book = "src/Gjk.Demo/Trace/Textbook/";

    /// <summary>The library's GJK.</summary>
    public static IReadOnlyList<LessonLine> Exact { get; } =
    [
        new("start", 0, "d = from A’s centre to B’s; simplex = {}", Core + "Minkowski/PairFrame.cs", "FirstNormal"),
        new("repeat", 0, "repeat", Core + "Solvers/GjkDistance.cs", "Solve"),
        new("support", 1, "w = A’s furthest along d − B’s against d",
            Core + "Minkowski/MinkowskiDifference.cs", "Support"),
        new("bound", 1, "lower = height of the plane through w across d", Core + "Solvers/GjkDistance.cs", "Judge"),
        new("met", 1, "if lower meets |v|: apart by |v|, end", Core + "Solvers/Proofs.cs", "IsClosed"),
        new("join", 1, "simplex = simplex + w", Core + "Simplex/NextSimplex.cs", "TryAdvance"),
        new("inside", 1, "if it holds the origin: intersecting, end",
            Core + "Simplex/NextSimplex.cs", "TryTakeFace"),
        new("region", 1, "simplex = its part nearest the origin",
            Core + "Simplex/NextSimplex.cs", "Triangle"),
        new("next", 1, "d = from that part to the origin, across it", Core + "Simplex/NextSimplex.cs", "KeepFace"),
        new("touch", 1, "if |v| is 0 but for rounding: touching, end",
            Core + "Solvers/Proofs.cs", "Touch"),
        new("stall", 1, "if |v| falls no more: again, with 106 bits",
            Core + "Solvers/GjkExtendedPrecision.cs", "Solve"),
        new("answer", 0, "answer = v’s weights on A and B, less the margins",
            Core + "Simplex/ClosestPointWeights.cs", "OfFeature"),
    ];

    /// <summary>The textbook's GJK, with which the page compares it.</summary>
    public static IReadOnlyList<LessonLine> Textbook { get; } =
    [
        new("start", 0, "d = from A’s centre to B’s; simplex = {}", Book + "TextbookGjk.cs", "Run"),
        new("repeat", 0, "repeat", Book + "TextbookGjk.cs", "Run"),
        new("support", 1, "w = A’s furthest along d − B’s against d",
            Book + "TextbookBody.cs", "FurthestPoint"),
        new("met", 1, "if w is no further than v: apart by |v|, end", Book + "TextbookGjk.cs", "Run"),
        new("join", 1, "simplex = simplex + w", Book + "TextbookGjk.cs", "Run"),
        new("inside", 1, "if it holds the origin: intersecting, end",
            Book + "TextbookSimplex.cs", "Tetrahedron"),
        new("region", 1, "simplex = its part that faces the origin", Book + "TextbookSimplex.cs", "Reduce"),
        new("next", 1, "v = its point nearest the origin; d = −v", Book + "TextbookClosestPoint.cs", "Weights"),
    ];

    public static void Write(Utf8JsonWriter json)
    {
        json.WriteStartObject("code");
        Write(json, "exact", Exact);
        Write(json, "textbook", Textbook);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, string name, IReadOnlyList<LessonLine> lines)
    {
        json.WriteStartArray(name);
        foreach (LessonLine line in lines)
        {
            json.WriteStartObject();
            json.WriteString("id", line.Id);
            json.WriteNumber("indent", line.Indent);
            json.WriteString("text", line.Text);
            json.WriteString("file", line.File);
            json.WriteString("member", line.Member);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }
}

/// <summary>One line of an algorithm.</summary>
/// <param name="Id">By which the page lights the line.</param>
/// <param name="Indent">How deep it is in the loop.</param>
/// <param name="Text">What is done.</param>
/// <param name="File">The source file that does it, from the root of the repository.</param>
/// <param name="Member">The method there.</param>
internal sealed record LessonLine(string Id, int Indent, string Text, string File, string Member);
