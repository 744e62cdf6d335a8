#if NET
using Floats = System.Runtime.Intrinsics.Vector256<float>;
#endif

namespace Gjk.Core;

/// <summary>Measures all pairs of two leaves' triangles in float, and gives out those that may be the nearest, the one
/// that seems nearest first.</summary>
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

    /// <summary>How many pairs there are.</summary>
    private int _left;

    private float _room;

    /// <summary>Prepares for another query.</summary>
    public void Reset(in TreeFrame frame)
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
        if (_turnedLeaf != leafA) TurnCorners(frame, a, leafA);
        PlaceCorners(frame, b, leafB, countA);
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

    /// <summary>Gives out the pair that seems nearest, of those whose bounds do not exceed the limit.</summary>
    public bool TryPopNearest(float reached, out int first, out int second)
    {
        int best = -1;
        for (int i = 0; i < _left; i++)
            if (_bounds[i] <= reached && (best < 0 || _seeming[i] < _seeming[best])) best = i;
        first = best / _countB;
        second = best % _countB;
        if (best >= 0) _bounds[best] = float.PositiveInfinity;
        return best >= 0;
    }

    /// <summary>Writes A's corners in the frame of B's tree and in pair units.</summary>
    private void TurnCorners(in TreeFrame frame, PartSide a, int leaf)
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

    /// <summary>Writes both leaves' corners in float, relative to B's first one.</summary>
    private void PlaceCorners(in TreeFrame frame, PartSide b, int leaf, int countA)
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

/// <summary>Measures eight pairs of triangles: how far apart they seem, and a lower bound of their distance. Compares
/// each edge of one with each edge of the other (9), and each corner with the inside of the other triangle (6):
/// Ericson, "Real-Time Collision Detection", 5.1.9.</summary>
/// <remarks>What is found only proposes a direction. The bound is the gap between the two planes across it that the
/// corners leave, so that it holds however the direction was found; pairs that pierce each other have none. Rounding,
/// with u = 2^-24, M the largest coordinate and |w| the sum of the direction's: a corner is rounded by u M in each
/// coordinate, its product with w by 3 u M |w|; both corners' by 8 u M |w|, their difference by 2 u M |w| more. <see
/// cref="CornerError"/> is 16 u. The square, the squared length and the quotient take 6 u, which <see
/// cref="BoxLanes.Squared"/> has room for. What underflows before is far below the room, 2^-45 of the sizes.</remarks>
internal static unsafe class TriangleLanes
{
    /// <summary>Floats of eight triangles: x, y and z of each corner, eight each.</summary>
    public const int Stride = 72;

    /// <summary>Ratio: 16 u; see the remarks. Pinned by TriangleLanesTests.</summary>
    private const float CornerError = 16f / (1 << 24);

    /// <summary>Squared lengths in pair units: shorter vectors have no direction.</summary>
    private const float Tiny = 1e-36f;

    /// <summary>Ratio: edges more nearly parallel are taken as parallel. The bound holds all the same.</summary>
    private const float Parallel = 1e-6f;

    private struct Best
    {
        public Floats Squared;
        public Lanes3 Way;

#if NET
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
        public void KeepNearer(Floats squared, in Lanes3 way)
        {
            Way = new Lanes3(
                FloatLanes.IfLess(squared, Squared, way.X, Way.X), FloatLanes.IfLess(squared, Squared, way.Y, Way.Y),
                FloatLanes.IfLess(squared, Squared, way.Z, Way.Z));
            Squared = FloatLanes.Min(squared, Squared);
        }
    }

    /// <summary>Whether planes across the lines of the centres show all eight pairs further apart.</summary>
    /// <param name="p">The first triangles, then the second.</param>
    /// <param name="room">Pair units: the error of the corners before they were rounded.</param>
    /// <param name="reached">A squared distance, from <see cref="BoxLanes.Squared"/>.</param>
    public static bool AreApart(float* p, float room, float reached)
    {
        float* bounds = stackalloc float[PartTree.Lanes];
        for (int lane = 0; lane < PartTree.Lanes; lane += FloatLanes.Count)
        {
            float* a = p + lane, b = a + Stride;
            Lanes3 way = Load(a) + Load(a + 24) + Load(a + 48) - (Load(b) + Load(b + 24) + Load(b + 48));
            FloatLanes.Store(Bound(a, way, room), bounds + lane);
        }

        for (int i = 0; i < PartTree.Lanes; i++)
            if (!(bounds[i] > reached)) return false;
        return true;
    }

    /// <summary>How far apart the pairs seem, squared, and squared bounds that hold.</summary>
    /// <inheritdoc cref="AreApart"/>
#if NET
    [SkipLocalsInit]
#endif
    public static void Measure(float* p, float room, float* seeming, float* bounds)
    {
        for (int lane = 0; lane < PartTree.Lanes; lane += FloatLanes.Count)
        {
            float* a = p + lane, b = a + Stride;
            Best best = default;
            best.Squared = FloatLanes.All(float.MaxValue);
            Edges(a, b, ref best);
            Faces(a, b, 1, ref best);
            Faces(b, a, -1, ref best);
            FloatLanes.Store(best.Squared, seeming + lane);
            FloatLanes.Store(Bound(a, best.Way, room), bounds + lane);
        }
    }

    /// <summary>The squared gap between planes across a direction, less what rounding can have made of it.</summary>
#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    private static Floats Bound(float* a, in Lanes3 way, float room)
    {
        float* b = a + Stride;
        Floats low = FloatLanes.Min(
            FloatLanes.Min(Lanes3.Dot(way, Load(a)), Lanes3.Dot(way, Load(a + 24))), Lanes3.Dot(way, Load(a + 48)));
        Floats high = FloatLanes.Max(
            FloatLanes.Max(Lanes3.Dot(way, Load(b)), Lanes3.Dot(way, Load(b + 24))), Lanes3.Dot(way, Load(b + 48)));
        Floats most = FloatLanes.Abs(FloatLanes.Load(a));
        for (int k = 8; k < 2 * Stride; k += 8) most = FloatLanes.Max(most, FloatLanes.Abs(FloatLanes.Load(a + k)));
        Floats length = FloatLanes.Abs(way.X) + FloatLanes.Abs(way.Y) + FloatLanes.Abs(way.Z);
        Floats error = (most * FloatLanes.All(CornerError) + FloatLanes.All(room)) * length;
        Floats gap = FloatLanes.Max(low - high - error, FloatLanes.All(0));

        // Not gap * gap first, which small triangles beside large ones lose: a float may round it up to its least.
        return gap * (gap / FloatLanes.Max(Lanes3.Dot(way, way), FloatLanes.All(Tiny)));
    }

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    private static Lanes3 Load(float* p) => new(FloatLanes.Load(p), FloatLanes.Load(p + 8), FloatLanes.Load(p + 16));

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    private static Floats Clamp(Floats x) => FloatLanes.Min(FloatLanes.Max(x, FloatLanes.All(0)), FloatLanes.All(1));

    private static void Edges(float* a, float* b, ref Best best)
    {
        Floats one = FloatLanes.All(1), tiny = FloatLanes.All(Tiny), parallel = FloatLanes.All(Parallel);
        for (int i = 0; i < 3; i++)
        {
            Lanes3 p = Load(a + 24 * i), d = Load(a + 24 * ((i + 1) % 3)) - p;
            Floats dd = Lanes3.Dot(d, d) + tiny, inverseD = one / dd;
            for (int j = 0; j < 3; j++)
            {
                Lanes3 q = Load(b + 24 * j), e = Load(b + 24 * ((j + 1) % 3)) - q, r = p - q;
                Floats ee = Lanes3.Dot(e, e) + tiny, de = Lanes3.Dot(d, e);
                Floats dr = Lanes3.Dot(d, r), er = Lanes3.Dot(e, r), product = dd * ee;
                Floats area = FloatLanes.Max(product - de * de, product * parallel + tiny);
                Floats s = Clamp((de * er - dr * ee) / area);
                Floats t = Clamp((de * s + er) / ee);
                s = Clamp((de * t - dr) * inverseD);
                var way = new Lanes3(r.X + s * d.X - t * e.X, r.Y + s * d.Y - t * e.Y, r.Z + s * d.Z - t * e.Z);
                best.KeepNearer(Lanes3.Dot(way, way), way);
            }
        }
    }

    /// <summary>The corners of the second triangle over the inside of the first.</summary>
    private static void Faces(float* face, float* other, float sign, ref Best best)
    {
        Lanes3 a = Load(face), b = Load(face + 24), c = Load(face + 48);
        Lanes3 e0 = b - a, e1 = c - b, e2 = a - c, n = Lanes3.Cross(e0, e1);
        Lanes3 s0 = Lanes3.Cross(n, e0), s1 = Lanes3.Cross(n, e1), s2 = Lanes3.Cross(n, e2);
        Floats nn = FloatLanes.Max(Lanes3.Dot(n, n), FloatLanes.All(Tiny)), zero = FloatLanes.All(0);
        for (int i = 0; i < 3; i++)
        {
            Lanes3 p = Load(other + 24 * i), pa = p - a;
            Floats h = Lanes3.Dot(n, pa), share = h / nn;
            Floats inside = FloatLanes.Min(
                FloatLanes.Min(Lanes3.Dot(s0, pa), Lanes3.Dot(s1, p - b)), Lanes3.Dot(s2, p - c));
            Floats squared = FloatLanes.IfLess(zero, inside, h * share, FloatLanes.All(float.MaxValue));
            Floats along = share * FloatLanes.All(-sign);
            best.KeepNearer(squared, new Lanes3(n.X * along, n.Y * along, n.Z * along));
        }
    }
}
