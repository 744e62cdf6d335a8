namespace Gjk.Demo.View;

/// <summary>The contact points of the pairs that intersect in the first frame: a dot on A's surface, and a thin line
/// from it to B's. Dark outlines keep the dots readable on bodies of any colour.</summary>
internal sealed class PictureContacts
{
    /// <summary>The page's colour of the contact points.</summary>
    public const string Color = "#f0a6ff";

    /// <summary>In the units of the picture.</summary>
    private const double Radius = 2.6, Outline = 1, Width = 1.2;

    private readonly SceneContacts _contacts;
    private int _pair, _point;

    public PictureContacts(SceneContacts contacts) => _contacts = contacts;

    /// <summary>Writes the next intersecting pair. They come in the order of the pairs.</summary>
    /// <param name="writer">Where to write.</param>
    /// <param name="names">The pair, for the words that a viewer shows on hovering.</param>
    /// <param name="normal">The direction in which B leaves A.</param>
    /// <param name="project">The position of a point of the world in the picture.</param>
    public void WriteNext(
        TextWriter writer, string names, in Double3 normal, Func<Double3, (double X, double Y)> project)
    {
        int count = _contacts.Counts[_pair++];
        if (count is 0 or SceneContacts.LeftOut) return;
        (float least, float most) = (float.PositiveInfinity, float.NegativeInfinity);
        var sticks = new SvgPath();
        var dots = new StringWriter();
        for (int i = 0; i < count; i++)
        {
            ReadOnlySpan<float> point = _contacts.Points.Slice(SceneContacts.PointSize * _point++);
            (Double3 onA, float gap) = (new Vector3(point), point[3]);
            (least, most) = (Math.Min(least, gap), Math.Max(most, gap));
            (double X, double Y) at = project(onA);
            sticks.Line([at, project(onA + normal * gap)]);
            dots.Write(Say($"<circle cx=\"{at.X:0.#}\" cy=\"{at.Y:0.#}\" r=\"{Radius}\"/>"));
        }

        writer.WriteLine($"<g><title>{PlainText.Markup(names + ": " + Words(count, least, most))}</title>");
        writer.WriteLine(Say($"<path stroke=\"{Color}\" stroke-width=\"{Width}\" d=\"{sticks}\"/>"));
        writer.WriteLine(Say($"<g fill=\"{Color}\" stroke=\"#0a0d12\" stroke-width=\"{Outline}\">{dots}</g></g>"));
    }

    /// <summary>For example "4 contact points, gaps -0.01 to 0.002".</summary>
    private static string Words(int count, float least, float most)
    {
        string points = count == 1 ? "1 contact point" : Say($"{count} contact points");
        return least == most ? Say($"{points}, gap {least:G6}") : Say($"{points}, gaps {least:G6} to {most:G6}");
    }

    private static string Say(FormattableString text) => FormattableString.Invariant(text);
}
