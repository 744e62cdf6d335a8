namespace Gjk.Demo.View;

/// <summary>The way out of an intersecting pair, as an arrow of the page's colour. A dark outline keeps it readable on
/// bodies of any colour.</summary>
internal static class PictureArrow
{
    /// <summary>The page's colour of the ways out.</summary>
    public const string Color = "#7cc4ff";

    /// <summary>In the units of the picture.</summary>
    private const double Width = 2.2, Outline = 5, LongestHead = 11;

    /// <summary>Shares: the head of the arrow, half its breadth of its length.</summary>
    private const double Head = 0.5, HalfBreadth = 0.42;

    /// <param name="writer">Where to write.</param>
    /// <param name="from">Where the arrow begins, in the picture.</param>
    /// <param name="to">Its tip.</param>
    /// <param name="title">The words that a viewer shows on hovering.</param>
    public static void Write(TextWriter writer, (double X, double Y) from, (double X, double Y) to, string title)
    {
        (double x, double y) = (to.X - from.X, to.Y - from.Y);
        double length = Math.Sqrt(x * x + y * y), share = length > 0 ? Math.Min(Head, LongestHead / length) : 0;

        // The shaft ends where the head begins, or its broad end would blunt the tip.
        (double X, double Y) neck = (to.X - share * x, to.Y - share * y);
        (double aside, double down) = (-y * share * HalfBreadth, x * share * HalfBreadth);
        var path = new SvgPath();
        path.Line([from, neck]);
        path.Polygon([to, (neck.X + aside, neck.Y + down), (neck.X - aside, neck.Y - down)]);
        writer.WriteLine($"<g><title>{PlainText.Markup(title)}</title>");
        writer.WriteLine(Say($"<path stroke=\"#0a0d12\" stroke-width=\"{Outline}\" d=\"{path}\"/>"));
        writer.WriteLine(Say(
            $"<path stroke=\"{Color}\" stroke-width=\"{Width}\" fill=\"{Color}\" d=\"{path}\"/></g>"));
    }

    private static string Say(FormattableString text) => FormattableString.Invariant(text);
}
