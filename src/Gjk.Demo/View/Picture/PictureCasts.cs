namespace Gjk.Demo.View;

/// <summary>The paths of the objects that move over the first frame, dashed; their outlines where they first meet
/// another; and the points at which they do, each with its normal. All of it is drawn over the bodies.</summary>
internal sealed class PictureCasts
{
    /// <summary>The page's colour of paths and impacts.</summary>
    public const string Color = "#ffb86b";

    /// <summary>In the units of the picture.</summary>
    private const double Width = 1.2, Radius = 3, Outline = 1;

    /// <summary>The length of a normal, in the units of the drawn scene, which is 20 across.</summary>
    private const double NormalLength = 1.1;

    private readonly Scene _scene;
    private readonly SceneResults _results;
    private readonly PictureCamera _camera;
    private readonly Func<Double3, Double3> _drawn;

    /// <summary>For every object the fraction at which it first meets another; infinite where it meets none.</summary>
    private readonly float[] _first;

    /// <param name="scene">The scene.</param>
    /// <param name="results">Its answers.</param>
    /// <param name="camera">The camera.</param>
    /// <param name="drawn">From the world to the units of the drawn scene.</param>
    public PictureCasts(Scene scene, SceneResults results, PictureCamera camera, Func<Double3, Double3> drawn)
    {
        _scene = scene;
        _results = results;
        _camera = camera;
        _drawn = drawn;
        _first = new float[scene.Objects.Length];
        Array.Fill(_first, float.PositiveInfinity);
        foreach ((int a, int b, float fraction, _, _) in Hits())
        {
            _first[a] = Math.Min(_first[a], fraction);
            _first[b] = Math.Min(_first[b], fraction);
        }
    }

    /// <summary>Writes everything. Nothing is written for a scene at rest.</summary>
    /// <param name="writer">Where to write.</param>
    /// <param name="bodies">The objects and their parts, where they are.</param>
    public void Write(TextWriter writer, PictureBody[] bodies)
    {
        SvgPath paths = new(), ghosts = new();
        for (int i = 0; i < _scene.Objects.Length; i++)
        {
            Double3 velocity = _scene.Objects[i].Velocity, start = _scene.Objects[i].Pose.Position;
            if (velocity == default) continue;
            paths.Line([_camera.Project(_drawn(start)), _camera.Project(_drawn(start + velocity))]);
        }

        foreach (PictureBody body in bodies)
        {
            SceneObject one = _scene.Objects[body.Source.Object];
            float first = _first[body.Source.Object];
            if (one.Velocity == Vector3.Zero || float.IsInfinity(first)) continue;
            Double3 velocity = one.Velocity, start = one.Pose.Position;
            Double3 moved = _drawn(start + velocity * first) - _drawn(start);
            foreach ((int from, int to) in body.Lines())
            {
                Double3[] corners = body.Vertices;
                ghosts.Line([_camera.Project(corners[from] + moved), _camera.Project(corners[to] + moved)]);
            }
        }

        Write(writer, paths, "5 4");
        Write(writer, ghosts, null);
        foreach ((int a, int b, float fraction, Double3 point, Double3 normal) in Hits())
        {
            if (fraction > _first[a] && fraction > _first[b]) continue;
            Double3 at = _drawn(point);
            (double x, double y) = _camera.Project(at);
            (double X, double Y) tip = _camera.Project(at + normal * NormalLength);
            string title = Say($"{NameOf(a)} – {NameOf(b)}: meet after {fraction:G6} of the frame");
            var stroke = new SvgPath();
            stroke.Line([(x, y), tip]);
            writer.WriteLine($"<g><title>{PlainText.Markup(title)}</title>");
            writer.WriteLine(Say($"<path fill=\"none\" stroke=\"{Color}\" stroke-width=\"2\" d=\"{stroke}\"/>"));
            writer.WriteLine(Say(
                $"<circle cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"{Radius}\" fill=\"{Color}\" stroke=\"#0a0d12\" ")
                + Say($"stroke-width=\"{Outline}\"/></g>"));
        }
    }

    private static void Write(TextWriter writer, SvgPath path, string? dashes)
    {
        if (path.IsEmpty) return;
        string dashed = dashes is null ? "" : $" stroke-dasharray=\"{dashes}\"";
        writer.WriteLine(Say(
            $"<path fill=\"none\" stroke=\"{Color}\" stroke-width=\"{Width}\"{dashed} d=\"{path}\"/>"));
    }

    /// <summary>The hits of the first frame.</summary>
    private IEnumerable<(int A, int B, float Fraction, Double3 Point, Double3 Normal)> Hits()
    {
        int pair = 0, entry = 0;
        foreach ((int a, int b) in _results.Pairs)
        {
            int index = pair++;
            if (entry == _results.Casts.Indices.Length) break;
            if (_results.Casts.Indices[entry] != index) continue;
            ReadOnlySpan<float> hit = _results.Casts.Entries.Slice(SceneCasts.EntrySize * entry++);
            (Vector3 point, Vector3 normal) = (new Vector3(hit[1..]), new Vector3(hit[4..]));
            if (!float.IsNaN(point.X)) yield return (a, b, hit[0], point, normal);
        }
    }

    private string NameOf(int index) => _scene.Objects[index].Name ?? Say($"#{index}");

    private static string Say(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
