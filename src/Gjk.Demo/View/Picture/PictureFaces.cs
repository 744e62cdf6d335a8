namespace Gjk.Demo.View;

/// <summary>The visible surfaces of a picture, with one path for each colour and brightness.</summary>
internal sealed class PictureFaces
{
    /// <summary>How many levels of brightness there are, from the darkest to the brightest face.</summary>
    private const int Levels = 24;

    /// <summary>Brightness of a face turned away from the light, and of one turned towards it.</summary>
    private const double Darkest = 0.42, Brightest = 1.12;

    private readonly PictureCamera _camera;
    private readonly Double3 _light;
    private readonly SortedDictionary<(PictureTone Tone, int Level), SvgPath> _paths = [];

    public PictureFaces(PictureCamera camera)
    {
        _camera = camera;
        _light = camera.Direction(-0.45, 0.8, 0.6);
    }

    public IEnumerable<(PictureTone Tone, double Brightness, string Path)> Paths
    {
        get
        {
            foreach (((PictureTone tone, int level), SvgPath path) in _paths)
            {
                if (!path.IsEmpty)
                    yield return (tone, Darkest + (Brightest - Darkest) * level / (Levels - 1), path.ToString());
            }
        }
    }

    /// <summary>Adds the parts of a body that the other bodies leave visible. Whole triangles of one level are joined,
    /// so that only their common outline is written.</summary>
    public void Add(PictureBody body, PictureTone tone, List<PictureBody> before)
    {
        var outlines = new SortedDictionary<int, HashSet<(int From, int To)>>();
        List<Double3[]> pieces = [], next = [];
        for (int i = 0; i < body.TriangleCount; i++)
        {
            if (!body.FacesEye(i)) continue;
            int level = Level(body.Normal(i));
            var whole = new Double3[3];
            for (int k = 0; k < 3; k++) whole[k] = body.Vertices[body.Corner(i, k)];
            pieces.Clear();
            pieces.Add(whole);
            foreach (PictureBody other in before)
            {
                next.Clear();
                foreach (Double3[] piece in pieces) other.Shadow.Cut(piece, next);
                (pieces, next) = (next, pieces);
            }

            if (pieces.Count == 1 && pieces[0] == whole)
            {
                if (!outlines.TryGetValue(level, out HashSet<(int From, int To)>? sides))
                    outlines.Add(level, sides = []);
                for (int k = 0; k < 3; k++) Join(sides, body.Corner(i, k), body.Corner(i, k == 2 ? 0 : k + 1));
                continue;
            }

            foreach (Double3[] piece in pieces)
                Path(tone, level).Polygon(Array.ConvertAll(piece, p => _camera.Project(p)));
        }

        foreach ((int level, HashSet<(int From, int To)> sides) in outlines) Trace(body, sides, Path(tone, level));
    }

    /// <summary>Adds a side of a triangle. A side that two triangles share lies inside their union and is
    /// removed.</summary>
    private static void Join(HashSet<(int From, int To)> sides, int from, int to)
    {
        if (!sides.Remove((to, from))) sides.Add((from, to));
    }

    private void Trace(PictureBody body, HashSet<(int From, int To)> sides, SvgPath path)
    {
        var after = new SortedDictionary<int, Stack<int>>();
        foreach ((int from, int to) in sides)
        {
            if (!after.TryGetValue(from, out Stack<int>? ends)) after.Add(from, ends = new Stack<int>());
            ends.Push(to);
        }

        foreach ((int start, Stack<int> starts) in after)
        {
            while (starts.Count > 0)
            {
                var points = new List<(double X, double Y)>();
                int at = start;
                do
                {
                    points.Add(_camera.Project(body.Vertices[at]));
                    at = after[at].Pop();
                }
                while (at != start);
                path.Polygon(points);
            }
        }
    }

    private int Level(in Double3 normal)
    {
        double towards = 0.5 + 0.5 * Double3.Dot(normal, _light) / normal.Length;
        return (int)Math.Round(towards * (Levels - 1));
    }

    private SvgPath Path(PictureTone tone, int level)
    {
        if (!_paths.TryGetValue((tone, level), out SvgPath? path)) _paths.Add((tone, level), path = new SvgPath());
        return path;
    }
}
