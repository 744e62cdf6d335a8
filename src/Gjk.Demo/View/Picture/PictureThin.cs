namespace Gjk.Demo.View;

/// <summary>Points and segments, which have no surface. They are drawn as dots and as strokes of one width.</summary>
internal sealed class PictureThin
{
    /// <summary>In the units of the picture.</summary>
    private const double StrokeWidth = 3.5, DotRadius = 4;

    /// <summary>What stripes are to a surface that intersects: a ring round a dot, gaps in a stroke.</summary>
    private const string Ring = " stroke=\"#fff\" stroke-width=\"1.5\"", Dashes = " stroke-dasharray=\"7 5\"";

    private readonly PictureCamera _camera;
    private readonly List<string> _elements = [];

    public PictureThin(PictureCamera camera) => _camera = camera;

    public void Add(PictureBody body, PictureTone tone, List<PictureBody> before)
    {
        string color = PictureColors.Of(tone, 1);
        Double3 from = body.Vertices[0], to = body.Vertices[^1];
        if (body.Vertices.Length == 1)
        {
            (double x, double y) = _camera.Project(from);
            _elements.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"<circle cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"{DotRadius}\" fill=\"{color}\"")
                + (tone == PictureTone.Hit ? Ring : "") + "/>");
            return;
        }

        var path = new SvgPath();
        foreach ((double start, double end) in Visible(from, to, before))
            path.Line([_camera.Project(from + (to - from) * start), _camera.Project(from + (to - from) * end)]);
        if (path.IsEmpty) return;
        string dashes = tone == PictureTone.Hit ? Dashes : "";
        _elements.Add(string.Create(
            CultureInfo.InvariantCulture,
            $"<path fill=\"none\" stroke=\"{color}\" stroke-width=\"{StrokeWidth}\"{dashes} d=\"{path}\"/>"));
    }

    public void Write(TextWriter writer)
    {
        foreach (string element in _elements) writer.WriteLine(element);
    }

    /// <summary>The parts of a segment that no body hides, as shares of its length.</summary>
    public static List<(double From, double To)> Visible(in Double3 from, in Double3 to, List<PictureBody> before)
    {
        List<(double From, double To)> parts = [(0, 1)], next = [];
        foreach (PictureBody body in before)
        {
            next.Clear();
            foreach ((double From, double To) part in parts) body.Shadow.Cut(from, to, part, next);
            (parts, next) = (next, parts);
        }

        return parts;
    }
}
