namespace Gjk.Core;

/// <summary>Finds out which vertices of a list cannot be furthest anywhere in a rectangle of the direction cube. See
/// <see cref="HullCellLists"/> for the proof.</summary>
/// <param name="points">x, y, z of each vertex in stretched units.</param>
/// <param name="grid">How directions are drawn.</param>
internal sealed class CellFilter(double[] points, CellGrid grid)
{
    /// <summary>Count: sample points of a rectangle, three rows of three. The furthest vertex of the list is known
    /// there; it is a champion, and champions beat most others.</summary>
    public const int Samples = 9;

    /// <summary>In stretched units. A computed dot product of the scan is off by at most 36 u, u = 2^-53: three
    /// products of up to 4 and two sums. For two of them, for stretching, and for the comparison here, 278 u is enough
    /// (proofs/cell-slack.g). This is 8192 u, which also covers the corners of a rectangle that is clipped a hundred
    /// times. Pinned by HullLookupTests.</summary>
    private const double Slack = 1.0 / (1L << 40);

    /// <summary>Count: the samples, filled up to whole registers.</summary>
    private const int Padded = 12;

    /// <summary>The order in which champions are tried: the centre's beats most.</summary>
    private readonly byte[] _order = [4, 1, 3, 5, 7, 0, 2, 6, 8];

    private readonly double[] _points = points;
    private readonly CellGrid _grid = grid;
    private readonly CellClip _clip = new();
    private readonly int[] _champions = new int[Samples];
    private readonly double[] _championU = new double[Padded], _championV = new double[Padded];
    private readonly double[] _championHeight = new double[Padded];
    private int _championCount, _axisU, _axisV, _axisW;
    private double _u, _v, _w, _halfU, _halfV;

    /// <summary>Chooses the rectangle for the other methods.</summary>
    public void Aim(in CellRect rect)
    {
        _grid.Measure(rect, out _u, out _v, out _halfU, out _halfV);
        _axisU = _grid.AxisU(rect.Face);
        _axisV = _grid.AxisV(rect.Face);
        _axisW = _grid.AxisW(rect.Face);
        _w = _grid.SignW(rect.Face);
    }

    /// <summary>Finds the champions of three points in a row.</summary>
    /// <param name="first">The first of the three.</param>
    /// <param name="step">From one to the next.</param>
    /// <param name="list">Holds the list of vertices.</param>
    /// <param name="from">Where the list begins.</param>
    /// <param name="count">How long it is.</param>
    /// <param name="samples">Receives the champions.</param>
    /// <param name="at">Where the rectangle's samples begin.</param>
    public void FindChampions(int first, int step, int[] list, int from, int count, int[] samples, int at)
    {
        double u = _u + (first % 3 - 1) * _halfU, v = _v + (first / 3 - 1) * _halfV;
        double stepU = step == 1 ? _halfU : 0, stepV = step == 3 ? _halfV : 0;
        double most0 = double.NegativeInfinity, most1 = most0, most2 = most0;
        int champion0 = list[from], champion1 = champion0, champion2 = champion0;
        for (int k = from; k < from + count; k++)
        {
            int i = list[k], p = 3 * i;
            double pu = _points[p + _axisU], pv = _points[p + _axisV];
            double height = pu * u + pv * v + _points[p + _axisW] * _w;
            double rise = pu * stepU + pv * stepV;
            if (height > most0) (most0, champion0) = (height, i);
            if (height + rise > most1) (most1, champion1) = (height + rise, i);
            if (height + 2 * rise > most2) (most2, champion2) = (height + 2 * rise, i);
        }

        samples[at + first] = champion0;
        samples[at + first + step] = champion1;
        samples[at + first + 2 * step] = champion2;
    }

    /// <summary>Copies a list without the vertices that one of the champions beats everywhere; gives the number that is
    /// left.</summary>
    public int Copy(int[] samples, int firstSample, int[] list, int from, int count, int[] target, int to)
    {
        Distinct(samples, firstSample);
        int kept = to;
        for (int k = from; k < from + count; k++)
        {
            if (!IsBeaten(list[k])) target[kept++] = list[k];
        }

        return kept - to;
    }

    /// <summary>Drops the vertices that are beaten everywhere in the rectangle, here by one other and there by another;
    /// gives the number that is left.</summary>
    public int Clip(int[] samples, int firstSample, int[] list, int from, int count)
    {
        Distinct(samples, firstSample);
        int kept = from;
        for (int k = from; k < from + count; k++)
        {
            int i = list[k];
            bool isChampion = Array.IndexOf(_champions, i, 0, _championCount) >= 0;
            if (isChampion || !IsClipped(i, list, from, kept, k, from + count)) list[kept++] = i;
        }

        return kept - from;
    }

    private void Distinct(int[] samples, int firstSample)
    {
        _championCount = 0;
        foreach (byte sample in _order)
        {
            int champion = samples[firstSample + sample];
            if (Array.IndexOf(_champions, champion, 0, _championCount) >= 0) continue;
            double u = _points[3 * champion + _axisU], v = _points[3 * champion + _axisV];
            _championU[_championCount] = u;
            _championV[_championCount] = v;
            _championHeight[_championCount] = u * _u + v * _v + _points[3 * champion + _axisW] * _w;
            _champions[_championCount++] = champion;
        }

        for (int k = _championCount; k < Padded; k++)
        {
            _championU[k] = _championU[0];
            _championV[k] = _championV[0];
            _championHeight[k] = _championHeight[0];
        }
    }

    /// <summary>Whether some champion is higher by more than the slack at the rectangle's corners, and so everywhere
    /// between them.</summary>
    private bool IsBeaten(int i)
    {
        double u = _points[3 * i + _axisU], v = _points[3 * i + _axisV];
        double limit = u * _u + v * _v + _points[3 * i + _axisW] * _w + Slack;
#if NET
        Debug.Assert(Math.Min(Math.Min(_championU.Length, _championV.Length), _championHeight.Length) >= Padded);
        ref double us = ref MemoryMarshal.GetArrayDataReference(_championU);
        ref double vs = ref MemoryMarshal.GetArrayDataReference(_championV);
        ref double heights = ref MemoryMarshal.GetArrayDataReference(_championHeight);
        Vector256<double> highest = Vector256.Create(double.NegativeInfinity);
        for (nuint k = 0; k < Padded; k += 4)
        {
            Vector256<double> least = Vector256.LoadUnsafe(ref heights, k)
                - Vector256.Abs(Vector256.LoadUnsafe(ref us, k) - Vector256.Create(u)) * _halfU
                - Vector256.Abs(Vector256.LoadUnsafe(ref vs, k) - Vector256.Create(v)) * _halfV;
            highest = Vector256.ConditionalSelect(Vector256.GreaterThan(least, highest), least, highest);
        }

        return Vector256.GreaterThanAny(highest, Vector256.Create(limit));
#else
        for (int k = 0; k < _championCount; k++)
        {
            double du = Math.Abs(_championU[k] - u), dv = Math.Abs(_championV[k] - v);
            double least = _championHeight[k] - du * _halfU - dv * _halfV;
            if (least > limit) return true;
        }

        return false;
#endif
    }

    /// <summary>Clips by the champions and by the rest of the list: what was kept so far, and what comes
    /// after.</summary>
    private bool IsClipped(int i, int[] list, int from, int kept, int next, int end)
    {
        _clip.Start(_u, _v, _halfU, _halfV);
        for (int k = 0; k < _championCount; k++)
        {
            if (!KeepBelow(_champions[k], i)) return true;
        }

        for (int k = from; k < end; k++)
        {
            // Those between are gone; whatever they beat is beaten by what beat them.
            if (k == kept) k = next;
            if (list[k] != i && !KeepBelow(list[k], i)) return true;
        }

        return false;
    }

    private bool KeepBelow(int j, int i) => _clip.Keep(
        _points[3 * j + _axisU] - _points[3 * i + _axisU],
        _points[3 * j + _axisV] - _points[3 * i + _axisV],
        (_points[3 * j + _axisW] - _points[3 * i + _axisW]) * _w,
        Slack);
}
