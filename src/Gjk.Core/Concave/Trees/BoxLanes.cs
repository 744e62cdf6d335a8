#if NET
using Floats = System.Runtime.Intrinsics.Vector256<float>;
#endif

namespace Gjk.Core;

/// <summary>The eight boxes of a node against one box: lower bounds of the distances, and of the ways until they
/// meet.</summary>
/// <remarks>
/// Idea: the gap between two boxes along any direction is no more than their distance, and the gaps along the three
/// axes of one box make a bound together, by Pythagoras (Gottschalk, Lin and Manocha, "OBBTree", 1996; Larsen et al.,
/// "Distance queries with rectangular swept sphere volumes", 1999).
///
/// Rounding. Let u = 2^-24, R and S the radii of the trees and T the distance of their origins, in pair units. A box's
/// centre lies within sqrt(3) R, its half sides are below R, and its axes a are perpendicular unit vectors but for the
/// rounding of their coordinates: |A^T A - I| &lt;= 2 sqrt(3) u &lt; 4 u for each pair. A gap is made of
/// - the difference of the centres: rounding the turned one costs u, the difference u, of sqrt(3) (R + S) + T;
/// - its product with an axis: three products and two sums, 3 u of the same (Cauchy and Schwarz);
/// - the half side along that axis, exact; its subtraction costs u of all, and so do the two others;
/// - what the other box reaches along it: the turned axis costs u, its product 3 u, the sum of three 3 u, and that the
///   box is not quite rectangular (the dual of its axes is off by |A^-T - A| &lt; 8 u) 8 u, all of sqrt(3) S.
/// Together (5 + 3) u (sqrt(3) (R + S) + T) + (15 + 3) u sqrt(3) S + 4 u R &lt; 50 u (R + S) + 9 u T, and the same
/// along the line of the centres, with 3 u for the root and the quotient. <see cref="TreeFrame.Slack"/> is 64 u each.
/// Pythagoras: the squares' sum is that of A^T (p - q), so at most 1 + 12 u times the squared distance, and 3 u go to
/// the sum; <see cref="Squared"/> raises what a bound is compared with by 32 u. Underflow: what is less than 2^-126 is
/// lost in the slack, and a square that underflows only makes a bound smaller.
/// </remarks>
internal static unsafe class BoxLanes
{
    /// <summary>Ratio: 32 u for Pythagoras; see the remarks. Four times as much costs time only.</summary>
    private const double SquareUp = 1 + 32.0 / (1 << 24);

    /// <summary>Pair units: no line of centres is shorter, so that nothing is divided by 0.</summary>
    private const float Least = 1e-30f;

    /// <summary>What bounds of squared distances are compared with, for a distance in pair units; see <see
    /// cref="AtMost"/>.</summary>
    public static float Squared(double distance) => AtMost(distance * distance * SquareUp);

    /// <summary>A number raised to float, finite for every input: all bounds of pairs that may count are a few units at
    /// most, and a bound that is infinite stands for a pair that counts at no limit.</summary>
    public static float AtMost(double length) =>
        length < float.MaxValue / 2 ? (float)length * (1 + 1f / (1 << 23)) + float.Epsilon : float.MaxValue;

    /// <summary>Lower bounds of the squared distances of the eight boxes of a node and a box.</summary>
    /// <param name="node">The node's boxes.</param>
    /// <param name="factor">Pair units per tree unit.</param>
    /// <param name="q">The box, in the node's frame and pair units.</param>
    /// <param name="room">In pair units: by how much lengths are lowered.</param>
    /// <param name="bounds">Eight floats to write to.</param>
#if NET
    [SkipLocalsInit]
#endif
    public static void DistanceSquared(float* node, float factor, in TurnedBox q, float room, float* bounds)
    {
        Floats f = FloatLanes.All(factor), s = FloatLanes.All(room), zero = FloatLanes.All(0);
        Floats qx = FloatLanes.All(q.Half.X), qy = FloatLanes.All(q.Half.Y), qz = FloatLanes.All(q.Half.Z);
        Floats ux = FloatLanes.All(q.U.X), uy = FloatLanes.All(q.U.Y), uz = FloatLanes.All(q.U.Z);
        Floats vx = FloatLanes.All(q.V.X), vy = FloatLanes.All(q.V.Y), vz = FloatLanes.All(q.V.Z);
        Floats wx = FloatLanes.All(q.W.X), wy = FloatLanes.All(q.W.Y), wz = FloatLanes.All(q.W.Z);
        for (int lane = 0; lane < PartTree.Lanes; lane += FloatLanes.Count)
        {
            float* p = node + lane;
            Floats tx = FloatLanes.Load(p) * f - FloatLanes.All(q.Center.X);
            Floats ty = FloatLanes.Load(p + 8) * f - FloatLanes.All(q.Center.Y);
            Floats tz = FloatLanes.Load(p + 16) * f - FloatLanes.All(q.Center.Z);
            Floats along0 = zero, along1 = zero, along2 = zero, reach = zero, own = zero;
            for (int i = 0; i < 3; i++)
            {
                float* axis = p + PartTree.Axes + 24 * i;
                Floats ax = FloatLanes.Load(axis), ay = FloatLanes.Load(axis + 8), az = FloatLanes.Load(axis + 16);
                Floats h = FloatLanes.Load(p + PartTree.Halves + 8 * i) * f;
                Floats r0 = FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, ux, uy, uz));
                Floats r1 = FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, vx, vy, vz));
                Floats r2 = FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, wx, wy, wz));
                Floats way = FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, tx, ty, tz));
                Floats gap = FloatLanes.Max(way - h - (r0 * qx + r1 * qy + r2 * qz) - s, zero);
                own = own + gap * gap;
                reach = reach + way * h;
                along0 = along0 + r0 * h;
                along1 = along1 + r1 * h;
                along2 = along2 + r2 * h;
            }

            Floats w0 = FloatLanes.Abs(FloatLanes.Dot(ux, uy, uz, tx, ty, tz));
            Floats w1 = FloatLanes.Abs(FloatLanes.Dot(vx, vy, vz, tx, ty, tz));
            Floats w2 = FloatLanes.Abs(FloatLanes.Dot(wx, wy, wz, tx, ty, tz));
            Floats g0 = FloatLanes.Max(w0 - qx - along0 - s, zero), g1 = FloatLanes.Max(w1 - qy - along1 - s, zero);
            Floats g2 = FloatLanes.Max(w2 - qz - along2 - s, zero);

            // Along the line of the centres: their distance less what either box reaches towards the other.
            Floats tt = FloatLanes.Dot(tx, ty, tz, tx, ty, tz);
            Floats length = FloatLanes.Max(FloatLanes.Sqrt(tt), FloatLanes.All(Least));
            Floats towards = w0 * qx + w1 * qy + w2 * qz;
            Floats between = FloatLanes.Max((tt - (reach + towards)) / length - s, zero);
            Floats best = FloatLanes.Max(own, g0 * g0 + g1 * g1 + g2 * g2);
            FloatLanes.Store(FloatLanes.Max(best, between * between), bounds + lane);
        }
    }

    /// <summary>Lower bounds of the ways along which a box moves until it meets the eight boxes; +infinity where it
    /// does not.</summary>
    /// <remarks>Along each axis of a node's box the gap is closed at no more than the way's own part along it, and a
    /// box that has passed stays behind it. Both speeds are widened by <see cref="SpeedError"/>.</remarks>
    /// <param name="node">The node's boxes.</param>
    /// <param name="factor">Pair units per tree unit.</param>
    /// <param name="q">The box at the start, in the node's frame and pair units.</param>
    /// <param name="way">The direction in the node's frame, a unit vector rounded to float, or zero.</param>
    /// <param name="room">In pair units: by how much lengths are lowered.</param>
    /// <param name="entries">Eight floats to write to: ways in pair units.</param>
#if NET
    [SkipLocalsInit]
#endif
    public static void Entries(float* node, float factor, in TurnedBox q, Vector3 way, float room, float* entries)
    {
        Floats f = FloatLanes.All(factor), s = FloatLanes.All(room), zero = FloatLanes.All(0);
        Floats infinity = FloatLanes.All(float.PositiveInfinity), error = FloatLanes.All(SpeedError);
        Floats qx = FloatLanes.All(q.Half.X), qy = FloatLanes.All(q.Half.Y), qz = FloatLanes.All(q.Half.Z);
        Floats ux = FloatLanes.All(q.U.X), uy = FloatLanes.All(q.U.Y), uz = FloatLanes.All(q.U.Z);
        Floats vx = FloatLanes.All(q.V.X), vy = FloatLanes.All(q.V.Y), vz = FloatLanes.All(q.V.Z);
        Floats wx = FloatLanes.All(q.W.X), wy = FloatLanes.All(q.W.Y), wz = FloatLanes.All(q.W.Z);
        Floats dx = FloatLanes.All(way.X), dy = FloatLanes.All(way.Y), dz = FloatLanes.All(way.Z);
        for (int lane = 0; lane < PartTree.Lanes; lane += FloatLanes.Count)
        {
            float* p = node + lane;
            Floats tx = FloatLanes.All(q.Center.X) - FloatLanes.Load(p) * f;
            Floats ty = FloatLanes.All(q.Center.Y) - FloatLanes.Load(p + 8) * f;
            Floats tz = FloatLanes.All(q.Center.Z) - FloatLanes.Load(p + 16) * f;
            Floats enter = zero, leave = infinity;
            for (int i = 0; i < 3; i++)
            {
                float* axis = p + PartTree.Axes + 24 * i;
                Floats ax = FloatLanes.Load(axis), ay = FloatLanes.Load(axis + 8), az = FloatLanes.Load(axis + 16);
                Floats h = FloatLanes.Load(p + PartTree.Halves + 8 * i) * f + s;
                h = h + FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, ux, uy, uz)) * qx;
                h = h + FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, vx, vy, vz)) * qy;
                h = h + FloatLanes.Abs(FloatLanes.Dot(ax, ay, az, wx, wy, wz)) * qz;
                Floats o = FloatLanes.Dot(ax, ay, az, tx, ty, tz), d = FloatLanes.Dot(ax, ay, az, dx, dy, dz);

                // From before the box, at the fastest; where it leads away for certain, never.
                Floats fast = FloatLanes.Abs(d) + error, slow = FloatLanes.Abs(d) - error;
                Floats ahead = FloatLanes.IfLess(d, zero, o, zero - o), gap = FloatLanes.Abs(o) - h;
                Floats away = FloatLanes.Min(slow, zero - ahead);
                Floats wayIn = FloatLanes.IfLess(zero, away, infinity, gap / fast);
                wayIn = FloatLanes.IfLess(zero, gap, wayIn, zero);
                Floats wayOut = FloatLanes.IfLess(zero, slow, (ahead + h) / slow, infinity);
                enter = FloatLanes.Max(enter, wayIn);
                leave = FloatLanes.Min(leave, wayOut);
            }

            enter = enter * FloatLanes.All(Earlier);
            FloatLanes.Store(FloatLanes.IfLess(leave * FloatLanes.All(Later), enter, infinity, enter), entries + lane);
        }
    }

    /// <summary>Ratio: 16 u. The rounding of a unit vector, u, its product with an axis, 3 u, and that the axis itself
    /// is off by 4 u. Pinned by BoxLanesTests.</summary>
    private const float SpeedError = 16f / (1 << 24);

    /// <summary>Ratios: 8 u, for a quotient and a product with this.</summary>
    private const float Earlier = 1 - 8f / (1 << 24), Later = 1 + 8f / (1 << 24);
}

/// <summary>A box with axes of its own.</summary>
internal struct TurnedBox
{
    public Vector3 Center, Half, U, V, W;

    /// <summary>The sum of the half sides: which of two boxes is opened first.</summary>
    public readonly float Size => Half.X + Half.Y + Half.Z;

    /// <summary>Reads a lane of a tree.</summary>
    /// <param name="boxes">The tree's.</param>
    /// <param name="reference">Eight times the node, and the lane.</param>
    /// <param name="factor">A power of two, for the lengths.</param>
    /// <param name="box">The box.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Read(float* boxes, int reference, float factor, out TurnedBox box)
    {
        float* p = boxes + (reference >> 3) * PartTree.Stride + (reference & 7);
        box.Center = new Vector3(p[0] * factor, p[8] * factor, p[16] * factor);
        box.Half = new Vector3(p[24] * factor, p[32] * factor, p[40] * factor);
        box.U = new Vector3(p[48], p[56], p[64]);
        box.V = new Vector3(p[72], p[80], p[88]);
        box.W = new Vector3(p[96], p[104], p[112]);
    }
}
