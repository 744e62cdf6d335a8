namespace Gjk.Core;

/// <summary>The triangles of two leaves: all pairs are measured in float, and those that may be the nearest are given
/// out, the one that seems nearest first.</summary>
internal sealed unsafe class TriangleFilter
{
    /// <summary>Ratio to the trees' sizes and distance: 2^-45; turning corners in double loses less.</summary>
    private const double TurnError = 1.0 / (1L << 45);

    /// <summary>Triangles in a leaf, at most.</summary>
    private const int Most = PartTree.Lanes - 1;

    private readonly float[] _first = new float[9 * Most], _second = new float[9 * Most];
    private readonly float[] _lanes = new float[2 * TriangleLanes.Stride];
    private readonly Double3[] _turned = new Double3[3 * Most];
    private readonly float[] _seeming = new float[Most * Most + PartTree.Lanes];
    private readonly float[] _bounds = new float[Most * Most + PartTree.Lanes];
    private int _turnedLeaf, _countB;

    /// <summary>How many pairs may count still.</summary>
    private int _left;

    private float _room;

    /// <summary>Forgets the leaf of another query.</summary>
    public void Begin(in TreeFrame frame)
    {
        _turnedLeaf = PartTree.Empty;
        _room = (float)((frame.RadiusA + frame.RadiusB + frame.Translation.Length) * TurnError) + frame.FarRoom;
    }

    /// <summary>Measures the pairs of two leaves.</summary>
    public void Measure(in TreeFrame frame, PartSide a, int leafA, PartSide b, int leafB, float reached)
    {
        int countA = PartTree.CountOf(leafA);
        _countB = PartTree.CountOf(leafB);
        int total = countA * _countB;
        if (_turnedLeaf != leafA) Turn(frame, a, leafA);
        Place(frame, b, leafB, countA);
        _left = 0;
        fixed (float* lanes = _lanes, first = _first, second = _second, seeming = _seeming, bounds = _bounds)
        {
            for (int begin = 0; begin < total; begin += PartTree.Lanes)
            {
                for (int lane = 0; lane < PartTree.Lanes; lane++)
                {
                    int pair = Math.Min(begin + lane, total - 1);
                    float* x = first + 9 * (pair / _countB), y = second + 9 * (pair % _countB), to = lanes + lane;
                    for (int k = 0; k < 9; k++)
                    {
                        to[8 * k] = x[k];
                        to[TriangleLanes.Stride + 8 * k] = y[k];
                    }
                }

                if (TriangleLanes.AreApart(lanes, _room, reached))
                {
                    for (int lane = 0; lane < PartTree.Lanes; lane++) bounds[begin + lane] = float.PositiveInfinity;
                    continue;
                }

                TriangleLanes.Measure(lanes, _room, seeming + begin, bounds + begin);
            }
        }

        _left = total;
    }

    /// <summary>Takes the pair that seems nearest of those whose bounds are within what is reached.</summary>
    public bool TryTake(float reached, out int first, out int second)
    {
        int best = -1;
        for (int i = 0; i < _left; i++)
            if (_bounds[i] <= reached && (best < 0 || _seeming[i] < _seeming[best])) best = i;
        first = best / _countB;
        second = best % _countB;
        if (best >= 0) _bounds[best] = float.PositiveInfinity;
        return best >= 0;
    }

    /// <summary>A's corners in the frame of B's tree and pair units.</summary>
    private void Turn(in TreeFrame frame, PartSide a, int leaf)
    {
        _turnedLeaf = leaf;
        int first = PartTree.FirstOf(leaf), count = PartTree.CountOf(leaf);
        double inverse = 1 / frame.Unit;
        for (int i = 0; i < count; i++)
        {
            a.Mesh!.GetCorners(a.Tree.Order[first + i], out Double3 p, out Double3 q, out Double3 r);
            _turned[3 * i] = frame.PlacedInB((p - a.Tree.Origin) * inverse);
            _turned[3 * i + 1] = frame.PlacedInB((q - a.Tree.Origin) * inverse);
            _turned[3 * i + 2] = frame.PlacedInB((r - a.Tree.Origin) * inverse);
        }
    }

    /// <summary>Both leaves' corners in float, measured from B's first one.</summary>
    private void Place(in TreeFrame frame, PartSide b, int leaf, int countA)
    {
        int first = PartTree.FirstOf(leaf);
        double inverse = 1 / frame.Unit;
        Double3 origin = default;
        for (int i = 0; i < _countB; i++)
        {
            b.Mesh!.GetCorners(b.Tree.Order[first + i], out Double3 p, out Double3 q, out Double3 r);
            if (i == 0) origin = p;
            Write(_second, 9 * i, (p - origin) * inverse);
            Write(_second, 9 * i + 3, (q - origin) * inverse);
            Write(_second, 9 * i + 6, (r - origin) * inverse);
        }

        Double3 from = (origin - b.Tree.Origin) * inverse;
        for (int i = 0; i < 3 * countA; i++) Write(_first, 3 * i, _turned[i] - from);
    }

    private static void Write(float[] to, int at, in Double3 v) =>
        (to[at], to[at + 1], to[at + 2]) = ((float)v.X, (float)v.Y, (float)v.Z);
}
