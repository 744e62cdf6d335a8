#if NET
using static System.Runtime.Intrinsics.Vector256;
using Lane = System.Runtime.Intrinsics.Vector256<double>;
#else
using static System.Math;
using Lane = System.Double;
#endif

namespace Gjk.Core;

/// <summary>What it costs to leave a box across each axis that can separate it from another: three axes at a time,
/// across A's faces, across B's, and across each edge of A with B's three. A group has a lane more, which is no
/// axis.</summary>
internal static unsafe class BoxAxes
{
    /// <summary>Counts of lanes: where the edges' begin, and of all.</summary>
    public const int Edges = 8, Lanes = 20;

    private const int Group = 4;

    /// <summary>The lanes of edges, a bit for each.</summary>
    private const int EdgeBits = 0x77700;

    /// <summary>The axis's number, from 0 to 14.</summary>
    public static int AxisOf(int lane) => lane / Group * 3 + lane % Group;

    /// <summary>The first face that costs no more than the cheapest, but for the noise.</summary>
    public static int LeastFace(double* costs, double noise)
    {
        double ofA = Math.Min(Math.Min(costs[0], costs[1]), costs[2]);
        double ofB = Math.Min(Math.Min(costs[Group], costs[Group + 1]), costs[Group + 2]);
        double limit = Math.Min(ofA, ofB) + noise;
        return costs[0] <= limit ? 0 : costs[1] <= limit ? 1 : costs[2] <= limit ? 2
            : costs[Group] <= limit ? Group : costs[Group + 1] <= limit ? Group + 1 : Group + 2;
    }

    /// <summary>The lanes of the edges that cost less than a limit; without a branch, since most do not.</summary>
    public static int EdgesBelow(double* costs, double* squares, double limit)
    {
        int below = 0;
        double squared = limit * Math.Abs(limit);
        for (int i = Edges; i < Lanes; i++) below |= (IsBelow(costs[i], squares[i], squared) ? 1 : 0) << i;
        return below & EdgeBits;
    }

    /// <summary>Whether a cost over its axis's length is below a limit: the signed squares are compared.</summary>
    public static bool IsBelow(double cost, double square, double limitSquared) =>
        cost * Math.Abs(cost) < limitSquared * square;

    /// <summary>How far B must move along each axis, on its side, to leave A behind, times the axis's length; and the
    /// squared lengths of the axes across edges, which are unit vectors of A times those of B.</summary>
    public static void Find(in Double3 halfA, in Double3 halfB, in PairFrame frame, double* costs, double* squares)
    {
#if NET
        Find(
            frame.Inverse.Column0, frame.Inverse.Column1, frame.Inverse.Column2, frame.Rotation.Column0,
            frame.Rotation.Column1, frame.Rotation.Column2, halfA.ToXyz(), frame.Translation.ToXyz(), halfA, halfB,
            frame, costs, squares);
#else
        fixed (double* back = &frame.Inverse.M00, to = &frame.Rotation.M00)
        fixed (Double3* half = &halfA, way = &frame.Translation)
        {
            for (int i = 0; i < 3; i++)
            {
                Find(
                    back[i], back[Group + i], back[2 * Group + i], to[i], to[Group + i], to[2 * Group + i],
                    ((double*)half)[i], ((double*)way)[i], halfA, halfB, frame, costs + i, squares + i);
            }
        }
#endif
    }

    /// <summary>All groups of three axes, or one axis of each where there are no lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Find(
        Lane x, Lane y, Lane z, Lane toX, Lane toY, Lane toZ, Lane half, Lane way, in Double3 halfA, in Double3 halfB,
        in PairFrame frame, double* costs, double* squares)
    {
        ref readonly RotationD m = ref frame.Rotation;
        ref readonly Double3 t = ref frame.Translation;
        Lane absX = Abs(x), absY = Abs(y), absZ = Abs(z);
        Lane onFacesOfB = Abs(toX) * halfB.X + Abs(toY) * halfB.Y + Abs(toZ) * halfB.Z;
        Store(half + onFacesOfB - Abs(way), costs);
        Lane ofA = absX * halfA.X + absY * halfA.Y + absZ * halfA.Z;
        Lane ofB = Abs(x * m.M00 + y * m.M10 + z * m.M20) * halfB.X
            + Abs(x * m.M01 + y * m.M11 + z * m.M21) * halfB.Y
            + Abs(x * m.M02 + y * m.M12 + z * m.M22) * halfB.Z;
        Store(ofA + ofB - Abs(x * t.X + y * t.Y + z * t.Z), costs + Group);

        // (0, -z, y), (z, 0, -x) and (-y, x, 0).
        ofA = absZ * halfA.Y + absY * halfA.Z;
        ofB = Abs(y * m.M20 - z * m.M10) * halfB.X + Abs(y * m.M21 - z * m.M11) * halfB.Y
            + Abs(y * m.M22 - z * m.M12) * halfB.Z;
        Store(ofA + ofB - Abs(y * t.Z - z * t.Y), costs + 2 * Group);
        Store(z * z + y * y, squares + 2 * Group);
        ofA = absZ * halfA.X + absX * halfA.Z;
        ofB = Abs(z * m.M00 - x * m.M20) * halfB.X + Abs(z * m.M01 - x * m.M21) * halfB.Y
            + Abs(z * m.M02 - x * m.M22) * halfB.Z;
        Store(ofA + ofB - Abs(z * t.X - x * t.Z), costs + 3 * Group);
        Store(z * z + x * x, squares + 3 * Group);
        ofA = absY * halfA.X + absX * halfA.Y;
        ofB = Abs(x * m.M10 - y * m.M00) * halfB.X + Abs(x * m.M11 - y * m.M01) * halfB.Y
            + Abs(x * m.M12 - y * m.M02) * halfB.Z;
        Store(ofA + ofB - Abs(x * t.Y - y * t.X), costs + 4 * Group);
        Store(y * y + x * x, squares + 4 * Group);
    }

    private static void Store(Lane v, double* to) => *(Lane*)to = v;
}
