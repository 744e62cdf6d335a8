using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// What it costs to leave a box across each axis that can separate it from another: three axes at a time, across A's
/// faces, across B's, and across each edge of A with B's three. A group has a lane more, which is no axis.
/// </summary>
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
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsBelow(double cost, double square, double limitSquared) =>
        cost * Math.Abs(cost) < limitSquared * square;

    /// <summary>
    /// How far B must move along each axis, on its side, to leave A behind, times the axis's length; and the squared
    /// lengths of the axes across edges, which are unit vectors of A times those of B.
    /// </summary>
    public static void Find(
        in Double3 halfA, in Double3 halfB, in PairFrame frame, double* costs, double* squares)
    {
        ref readonly RotationD m = ref frame.Rotation;
        Xyz x = frame.Inverse.Column0, y = frame.Inverse.Column1, z = frame.Inverse.Column2;
        Xyz absX = x.Abs(), absY = y.Abs(), absZ = z.Abs(), xx = x.Times(x), yy = y.Times(y), zz = z.Times(z);
        Double3 t = frame.Translation;
        Xyz onFacesOfB = m.Column0.Abs() * halfB.X + m.Column1.Abs() * halfB.Y + m.Column2.Abs() * halfB.Z;
        (halfA.ToXyz() + onFacesOfB - t.ToXyz().Abs()).StoreAt(costs);
        Xyz ofA = absX * halfA.X + absY * halfA.Y + absZ * halfA.Z;
        Xyz ofB = (x * m.M00 + y * m.M10 + z * m.M20).Abs() * halfB.X
            + (x * m.M01 + y * m.M11 + z * m.M21).Abs() * halfB.Y
            + (x * m.M02 + y * m.M12 + z * m.M22).Abs() * halfB.Z;
        (ofA + ofB - (x * t.X + y * t.Y + z * t.Z).Abs()).StoreAt(costs + Group);

        // (0, -z, y), (z, 0, -x) and (-y, x, 0).
        ofA = absZ * halfA.Y + absY * halfA.Z;
        ofB = (y * m.M20 - z * m.M10).Abs() * halfB.X + (y * m.M21 - z * m.M11).Abs() * halfB.Y
            + (y * m.M22 - z * m.M12).Abs() * halfB.Z;
        (ofA + ofB - (y * t.Z - z * t.Y).Abs()).StoreAt(costs + 2 * Group);
        (zz + yy).StoreAt(squares + 2 * Group);
        ofA = absZ * halfA.X + absX * halfA.Z;
        ofB = (z * m.M00 - x * m.M20).Abs() * halfB.X + (z * m.M01 - x * m.M21).Abs() * halfB.Y
            + (z * m.M02 - x * m.M22).Abs() * halfB.Z;
        (ofA + ofB - (z * t.X - x * t.Z).Abs()).StoreAt(costs + 3 * Group);
        (zz + xx).StoreAt(squares + 3 * Group);
        ofA = absY * halfA.X + absX * halfA.Y;
        ofB = (x * m.M10 - y * m.M00).Abs() * halfB.X + (x * m.M11 - y * m.M01).Abs() * halfB.Y
            + (x * m.M12 - y * m.M02).Abs() * halfB.Z;
        (ofA + ofB - (x * t.Y - y * t.X).Abs()).StoreAt(costs + 4 * Group);
        (yy + xx).StoreAt(squares + 4 * Group);
    }
}
