namespace Gjk.Demo.Trace;

/// <summary>Why the textbook's loop ended.</summary>
internal enum TextbookEnding
{
    /// <summary>The new vertex is no nearer than v: A and B are apart by |v|.</summary>
    NoNearer,

    /// <summary>The tetrahedron seems to hold the origin: they intersect.</summary>
    Encloses,

    /// <summary>v is the origin, to the last bit: they touch.</summary>
    Touches,

    /// <summary>A number was not finite: nothing can be said.</summary>
    NotFinite,

    /// <summary>The simplex is one that was there before. The loop keeps nothing else, so it goes round for
    /// ever.</summary>
    Repeats,

    /// <summary>The page's own limit. The textbook has none.</summary>
    StepCap,
}

/// <summary>All steps of the textbook's GJK on one pair.</summary>
internal sealed class TextbookRun
{
    public List<TextbookStep> Steps { get; } = [];

    public TextbookEnding Ending { get; set; }

    /// <summary>Where the loop repeats itself, the first step that left the same simplex; otherwise -1.</summary>
    public int RepeatOf { get; set; } = -1;

    /// <summary>|v| less both margins, at least 0; 0 where the textbook says that they intersect.</summary>
    public float Distance { get; set; }
}

/// <summary>One step: the direction, the vertex found in it, and the simplex that is left.</summary>
/// <param name="Direction">In world coordinates, of any length.</param>
/// <param name="Vertex">The new vertex.</param>
/// <param name="Before">The simplex before, oldest first, each as the step that found it.</param>
internal sealed record TextbookStep(Vector3 Direction, TextbookVertex Vertex, int[] Before)
{
    /// <summary>The simplex after; null where the vertex ended the loop.</summary>
    public int[]? After { get; set; }

    public float[] Weights { get; set; } = [];

    public Vector3 Nearest { get; set; }
}
