using System;

namespace Gjk.Core;

/// <summary>Finds out which vertices of a list cannot be furthest anywhere in a part of the direction cube. See <see cref="HullCellLists"/> for the proof.</summary>
internal sealed class CellFilter
{
    /// <summary>
    /// Points of a part where the furthest vertex of the list, a champion, is known: three rows of three. Champions beat most others.
    /// </summary>
    public const int Samples = 9;

    /// <summary>
    /// In stretched units. A computed dot product of the scan is off by at most 12 u, u = 2^-53 (three products and two sums, 4 in all); for two of
    /// them, for stretching, and for the comparison here, 2^-46 is more than enough. The rest keeps clear
    /// of the rounding when rectangles are clipped some hundred times. Pinned by HullLookupTests.
    /// </summary>
    private const double Slack = 1.0 / (1L << 40);

    /// <summary>The order in which champions are tried: the centre's beats most.</summary>
    private static readonly byte[] Order = [4, 1, 3, 5, 7, 0, 2, 6, 8];

    private readonly double[] _points;
    private readonly CellGrid _grid;
    private readonly CellClip _clip = new();
    private readonly int[] _champions = new int[Samples];
    private int _championCount, _axisU, _axisV, _axisW;
    private double _u, _v, _w, _halfU, _halfV;

    /// <param name="points">x, y, z of each vertex in stretched units.</param>
    /// <param name="grid">How directions are drawn.</param>
    public CellFilter(double[] points, in CellGrid grid)
    {
        _points = points;
        _grid = grid;
    }

    /// <summary>Makes a part the one that the other methods are about.</summary>
    public void Aim(in CellPart part)
    {
        _grid.Measure(part, out _u, out _v, out _halfU, out _halfV);
        _axisU = _grid.AxisU(part.Face);
        _axisV = _grid.AxisV(part.Face);
        _axisW = _grid.AxisW(part.Face);
        _w = _grid.SignW(part.Face);
    }

    /// <summary>Finds the champions of one of the nine points.</summary>
    public int Champion(int sample, int[] list, int from, int count)
    {
        double u = _u + (sample % 3 - 1) * _halfU, v = _v + (sample / 3 - 1) * _halfV, most = double.NegativeInfinity;
        int champion = list[from];
        for (int k = from; k < from + count; k++)
        {
            int p = 3 * list[k];
            double height = _points[p + _axisU] * u + _points[p + _axisV] * v + _points[p + _axisW] * _w;
            if (!(height > most)) continue;
            most = height;
            champion = list[k];
        }

        return champion;
    }

    /// <summary>Copies a list without the vertices that one of the champions beats everywhere; gives the number that is left.</summary>
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

    /// <summary>Drops the vertices that lie below some other wherever in the part, one here and another there; gives the number that is left.</summary>
    public int Clip(int[] samples, int firstSample, int[] list, int from, int count)
    {
        Distinct(samples, firstSample);
        int kept = from;
        for (int k = from; k < from + count; k++)
        {
            int i = list[k];
            if (Array.IndexOf(_champions, i, 0, _championCount) >= 0 || !IsClipped(i, list, from, kept, k, from + count)) list[kept++] = i;
        }

        return kept - from;
    }

    private void Distinct(int[] samples, int firstSample)
    {
        _championCount = 0;
        foreach (byte sample in Order)
        {
            int champion = samples[firstSample + sample];
            if (Array.IndexOf(_champions, champion, 0, _championCount) < 0) _champions[_championCount++] = champion;
        }
    }

    /// <summary>Some champion is higher by more than the slack at the part's corners, and so everywhere between them.</summary>
    private bool IsBeaten(int i)
    {
        double u = _points[3 * i + _axisU], v = _points[3 * i + _axisV], w = _points[3 * i + _axisW];
        for (int k = 0; k < _championCount; k++)
        {
            int q = 3 * _champions[k];
            double du = _points[q + _axisU] - u, dv = _points[q + _axisV] - v, dw = _points[q + _axisW] - w;
            if (dw * _w + du * _u + dv * _v - Math.Abs(du) * _halfU - Math.Abs(dv) * _halfV > Slack) return true;
        }

        return false;
    }

    /// <summary>Clips by the champions and by the rest of the list: what was kept so far, and what comes after.</summary>
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
