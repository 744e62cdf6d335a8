namespace Gjk.Demo.View;

/// <summary>Draws the first frame of a scene as an SVG picture. It shows what the page shows at first, and contains
/// only the visible parts of shapes and lines. The picture has a dark background of its own, so that the white lines
/// are readable on any page.</summary>
internal sealed class ScenePicture
{
    /// <summary>The width in the picture's own units. These are pixels if the picture is not scaled.</summary>
    private const double Width = 960;

    /// <summary>With more pairs than this, only the lines to nearest partners are drawn. The page starts in the same
    /// way.</summary>
    private const int ManyPairs = 400;

    /// <summary>The distance from the middle of the scene to its end as it is drawn. It does not depend on the scene's
    /// size, as on the page.</summary>
    private const double DrawnRadius = 10;

    /// <summary>Ratio. Angles that differ by no more than this count as equal. It is far more than the rounding of the
    /// arc functions.</summary>
    private const double Rounding = 1 + 1e-9;

    private readonly Scene _scene;
    private readonly SceneResults _results;
    private readonly Double3 _middle;
    private readonly double _unit;
    private readonly PictureCamera _camera;
    private readonly PictureBody[] _bodies;
    private readonly bool[] _hit;
    private readonly HashSet<(int Object, int Part)> _lit;
    private readonly int[] _nearest;
    private readonly PictureIndex _index;
    private readonly List<int> _candidates = [];

    private ScenePicture(Scene scene, ShapeTable shapes, SceneResults results)
    {
        _scene = scene;
        _results = results;
        int count = scene.Objects.Length;
        (_middle, _unit) = Measure(scene, shapes);
        var balls = new List<(Double3, double)>(count);
        for (int i = 0; i < count; i++)
        {
            double radius = shapes.Meshes[shapes.OfObject[i]].Radius * _unit;
            balls.Add((Drawn(scene.Objects[i].Pose.Position), radius));
        }
        _camera = new PictureCamera(balls);
        _bodies = PicturePieces.Of(scene, shapes, v => Drawn(v), _camera.Eye);
        _index = new PictureIndex(_camera, _bodies);
        _camera.Frame(_bodies.SelectMany(body => body.Vertices), Width);
        _hit = new bool[count];
        _nearest = new int[count];
        Array.Fill(_nearest, -1);
        Rank();
        _lit = PicturePieces.Lit(results, _nearest);
    }

    /// <returns>How often a body was looked at because it may hide a part of another body or of a line.</returns>
    public static long Write(
        Stream stream, Scene scene, ShapeTable shapes, SceneResults results, Action<double> progress,
        CancellationToken cancel)
    {
        using var writer = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
        var picture = new ScenePicture(scene, shapes, results);
        picture.Write(writer, progress, cancel);
        return picture._index.Found;
    }

    private static (Double3 Middle, double Unit) Measure(Scene scene, ShapeTable shapes)
    {
        if (scene.Objects.Length == 0) return (default, 1);
        double[] low = [double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity];
        double[] high = [-low[0], -low[0], -low[0]];
        for (int i = 0; i < scene.Objects.Length; i++)
        {
            double radius = shapes.Meshes[shapes.OfObject[i]].Radius;
            for (int axis = 0; axis < 3; axis++)
            {
                low[axis] = Math.Min(low[axis], scene.Objects[i].Pose.Position[axis] - radius);
                high[axis] = Math.Max(high[axis], scene.Objects[i].Pose.Position[axis] + radius);
            }
        }

        var middle = new Double3((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
        double size = (new Double3(high[0], high[1], high[2]) - middle).Length;
        return (middle, size > 0 ? DrawnRadius / size : 1);
    }

    private Double3 Drawn(in Double3 world) => (world - _middle) * _unit;

    /// <summary>Finds the objects that overlap another, and the pair of each object with its nearest partner.</summary>
    private void Rank()
    {
        int pair = 0;
        foreach ((int a, int b) in _results.Pairs)
        {
            float distance = _results.Distance[pair];
            if (_results.Overlaps(pair))
            {
                _hit[a] = _hit[b] = true;
            }
            else if (float.IsFinite(distance))
            {
                if (_nearest[a] < 0 || distance < _results.Distance[_nearest[a]]) _nearest[a] = pair;
                if (_nearest[b] < 0 || distance < _results.Distance[_nearest[b]]) _nearest[b] = pair;
            }

            pair++;
        }
    }

    private PictureTone ToneOf((int Object, int Part) source) =>
        _lit.Contains(source) ? PictureTone.Lit : _hit[source.Object] ? PictureTone.Hit : PictureTone.Free;

    private void Write(StreamWriter writer, Action<double> progress, CancellationToken cancel)
    {
        string title = $"{_scene.Name}: {Count(_scene.Objects.Length, "object")}, "
            + $"{Count(_scene.Pairs.Count, "pair")}, {_results.Overlapping[0]} intersecting";
        writer.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {_camera.Width} {_camera.Height}\" role=\"img\" "
            + $"stroke-linejoin=\"round\" stroke-linecap=\"round\">"));
        writer.WriteLine($"<title>{PlainText.Markup(title)}</title>");
        string lit = _lit.Count > 0 ? " Where an object is nearest to another, its triangle or part is yellow." : "";
        writer.WriteLine($"<desc>Bodies that intersect are red and striped, the others green.{lit}</desc>");
        writer.WriteLine("<rect width=\"100%\" height=\"100%\" rx=\"14\" fill=\"#12161d\"/>");
        if (_bodies.Length == 0)
            writer.WriteLine("<text x=\"50%\" y=\"50%\" fill=\"#97a3b4\" text-anchor=\"middle\" "
                + "font-family=\"sans-serif\" font-size=\"20\">This scene has no objects.</text>");
        var faces = new PictureFaces(_camera);
        var edges = new SvgPath();
        var thin = new PictureThin(_camera);
        var hatch = new PictureHatch();
        for (int i = 0; i < _bodies.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            progress((double)i / _bodies.Length);
            if (!TryBefore(_bodies[i].Center, _bodies[i].Radius, i, out List<PictureBody> before)) continue;
            PictureTone tone = ToneOf(_bodies[i].Source);
            faces.Add(_bodies[i], tone, before);
            if (_bodies[i].Dimension < 2)
            {
                thin.Add(_bodies[i], tone, before);
                continue;
            }

            foreach ((int from, int to) in _bodies[i].Lines())
                AddLine(edges, _bodies[i].Vertices[from], _bodies[i].Vertices[to], before);
        }

        foreach ((PictureTone tone, double brightness, string path) in faces.Paths)
        {
            string color = PictureColors.Of(tone, brightness), id = tone == PictureTone.Hit ? hatch.Next() : "";
            writer.WriteLine($"<path fill=\"{color}\" stroke=\"{color}\" stroke-width=\".5\"{id} d=\"{path}\"/>");
        }

        hatch.Write(writer);
        if (!edges.IsEmpty)
            writer.WriteLine($"<path fill=\"none\" stroke=\"#0a0d12\" stroke-opacity=\".75\" d=\"{edges}\"/>");
        thin.Write(writer);
        WriteLines(writer, cancel);
        WriteContacts(writer, cancel);
        WriteArrows(writer, cancel);
        new PictureCasts(_scene, _results, _camera, v => Drawn(v)).Write(writer, _bodies);
        progress(1);
        writer.WriteLine("</svg>");
    }

    /// <summary>Writes the lines between closest points. The line to each object's nearest partner is bright, the
    /// others are faint.</summary>
    private void WriteLines(StreamWriter writer, CancellationToken cancel)
    {
        SvgPath bright = new(), faint = new();
        int pair = -1;
        foreach ((int a, int b) in _results.Pairs)
        {
            cancel.ThrowIfCancellationRequested();
            pair++;
            bool isNearest = _nearest[a] == pair || _nearest[b] == pair;
            double distance = _results.Distance[pair];
            if (!(distance > 0) || double.IsInfinity(distance) || (!isNearest && _results.Pairs.Count > ManyPairs))
                continue;
            Double3 from = new Vector3(_results.PointA.AsSpan(3 * pair));
            Double3 normal = new Vector3(_results.Normal.AsSpan(3 * pair));
            Double3 start = Drawn(from), end = Drawn(from + normal * distance), middle = (start + end) * 0.5;
            if (TryBefore(middle, (end - middle).Length, -1, out List<PictureBody> before))
                AddLine(isNearest ? bright : faint, start, end, before);
        }

        const string White = "<path fill=\"none\" stroke=\"#fff\"";
        if (!faint.IsEmpty) writer.WriteLine($"{White} stroke-opacity=\".38\" stroke-width=\".8\" d=\"{faint}\"/>");
        if (!bright.IsEmpty) writer.WriteLine($"{White} stroke-width=\"1.8\" d=\"{bright}\"/>");
    }

    /// <summary>Writes the way out of each intersecting pair, from B's deepest point to A's. It lies inside both
    /// bodies, so it is drawn over all of them. Where only bounds of the depth are known, there are no deepest
    /// points.</summary>
    private void WriteArrows(StreamWriter writer, CancellationToken cancel)
    {
        int pair = -1;
        foreach ((int a, int b) in _results.Pairs)
        {
            cancel.ThrowIfCancellationRequested();
            pair++;
            float distance = _results.Distance[pair];
            if (_results.Status[pair] != StatusCode.Of(GjkStatus.Overlapping) || !(distance < 0)) continue;
            Double3 onA = new Vector3(_results.PointA.AsSpan(3 * pair));
            Double3 normal = new Vector3(_results.Normal.AsSpan(3 * pair));
            string title = string.Create(
                CultureInfo.InvariantCulture, $"{NameOf(a)} – {NameOf(b)}: depth {-distance:G6}");
            PictureArrow.Write(
                writer, _camera.Project(Drawn(onA + normal * distance)), _camera.Project(Drawn(onA)), title);
        }
    }

    /// <summary>Writes the contact points of each intersecting pair over all bodies. They are below the arrows, whose
    /// tips are the deepest points.</summary>
    private void WriteContacts(StreamWriter writer, CancellationToken cancel)
    {
        int pair = -1;
        var contacts = new PictureContacts(_results.Contacts);
        foreach ((int a, int b) in _results.Pairs)
        {
            cancel.ThrowIfCancellationRequested();
            if (!_results.Overlaps(++pair)) continue;
            Double3 normal = new Vector3(_results.Normal.AsSpan(3 * pair));
            contacts.WriteNext(writer, $"{NameOf(a)} – {NameOf(b)}", normal, at => _camera.Project(Drawn(at)));
        }
    }

    private static string Count(long number, string noun) =>
        string.Create(CultureInfo.InvariantCulture, $"{number} {noun}{(number == 1 ? "" : "s")}");

    private string NameOf(int index) => _scene.Objects[index].Name ?? $"#{index}";

    /// <summary>Finds the bodies that hide a part of a ball. Returns false if one of them hides the whole
    /// ball.</summary>
    private bool TryBefore(in Double3 center, double radius, int except, out List<PictureBody> before)
    {
        before = [];
        double distance = (center - _camera.Eye).Length;
        _index.Collect(center, radius, _candidates);
        foreach (int i in _candidates)
        {
            PictureBody body = _bodies[i];
            if (i == except || IsAside(body, center, radius, distance) || body.Shadow.Misses(center, radius)) continue;
            if (body.Shadow.Hides(center, radius)) return false;
            before.Add(body);
        }

        // The nearest body hides the most. Hidden parts need no further cuts.
        before.Sort((x, y) => x.EyeDistance.CompareTo(y.EyeDistance));
        return true;
    }

    /// <summary>A quick test of two balls. True if the body is behind the ball, or if the eye sees them
    /// apart.</summary>
    private bool IsAside(PictureBody body, in Double3 center, double radius, double distance)
    {
        if (body.EyeDistance - body.Radius > distance + radius) return true;
        if (body.Radius >= body.EyeDistance || radius >= distance) return false;
        double cosine = Double3.Dot(body.Center - _camera.Eye, center - _camera.Eye) / (body.EyeDistance * distance);
        double between = Math.Acos(Math.Min(1, cosine));
        return between > (Math.Asin(body.Radius / body.EyeDistance) + Math.Asin(radius / distance)) * Rounding;
    }

    private void AddLine(SvgPath path, Double3 from, Double3 to, List<PictureBody> before)
    {
        foreach ((double start, double end) in PictureThin.Visible(from, to, before))
            path.Line([_camera.Project(from + (to - from) * start), _camera.Project(from + (to - from) * end)]);
    }
}
