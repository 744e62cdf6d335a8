using System;
using Gjk.Core;

namespace Gjk.Import;

/// <summary>
/// A linear map as a rotation, a scale along the axes and another rotation: map = After * diag(Factors) * Before. A
/// scene's object can hold all three, so a round shape under skew stays exact.
/// </summary>
/// <remarks>
/// One-sided Jacobi rotations (Hestenes 1958, "Inversion of matrices by biorthogonalization") turn pairs of columns
/// until all are at right angles. Three columns converge within a few rounds; the number of rounds is limited anyway.
/// </remarks>
internal readonly record struct Stretch(TurnD After, Vector3D Factors, TurnD Before)
{
    /// <summary>Rounds over the three pairs of columns. The convergence is quadratic, so ten is plenty.</summary>
    private const int MostRounds = 30;

    /// <summary>Cosine between two columns that counts as a right angle: the rounding of its own computation.</summary>
    private const double RightAngle = 1e-15;

    public static Stretch Of(in Affine map)
    {
        Vector3D[] columns = [map.X, map.Y, map.Z];
        Vector3D[] before = [Affine.Identity.X, Affine.Identity.Y, Affine.Identity.Z];
        bool isDone = false;
        for (int round = 0; round < MostRounds && !isDone; round++)
        {
            isDone = true;
            for (int i = 0; i < 2; i++)
            {
                for (int j = i + 1; j < 3; j++) isDone &= !MakeSquare(columns, before, i, j);
            }
        }

        // The largest column first: the smallest may be 0 and has no direction of its own.
        int[] order = [0, 1, 2];
        Array.Sort(order, (i, j) => columns[j].LengthSquared.CompareTo(columns[i].LengthSquared));
        Vector3D u = Unit(columns[order[0]], Affine.Identity.X);
        Vector3D v = Unit(columns[order[1]], Perpendicular(u));
        Vector3D w = Vector3D.Cross(u, v);
        Vector3D a = before[order[0]], b = before[order[1]], c = Vector3D.Cross(a, b);
        var factors = new Vector3D(
            columns[order[0]].Length, columns[order[1]].Length, Vector3D.Dot(w, map.Turn(c)));
        TurnD toAxes = TurnD.FromAxes(a, b, c);
        return new Stretch(
            TurnD.FromAxes(u, v, w), factors, new TurnD(-toAxes.X, -toAxes.Y, -toAxes.Z, toAxes.W));
    }

    /// <summary>Turns two columns within their plane until they are at right angles. False if they were.</summary>
    private static bool MakeSquare(Vector3D[] columns, Vector3D[] before, int i, int j)
    {
        double dot = Vector3D.Dot(columns[i], columns[j]);
        double lengths = columns[i].Length * columns[j].Length;
        if (Math.Abs(dot) <= RightAngle * lengths || lengths == 0) return false;
        double zeta = (columns[j].LengthSquared - columns[i].LengthSquared) / (2 * dot);
        double tangent = (zeta >= 0 ? 1 : -1) / (Math.Abs(zeta) + Math.Sqrt(1 + zeta * zeta));
        double cosine = 1 / Math.Sqrt(1 + tangent * tangent);
        Turn(columns, i, j, cosine, cosine * tangent);
        Turn(before, i, j, cosine, cosine * tangent);
        return true;
    }

    private static void Turn(Vector3D[] columns, int i, int j, double cosine, double sine)
    {
        Vector3D x = columns[i], y = columns[j];
        columns[i] = x * cosine - y * sine;
        columns[j] = x * sine + y * cosine;
    }

    private static Vector3D Unit(in Vector3D v, in Vector3D otherwise) =>
        v.LengthSquared > 0 ? v * (1 / v.Length) : otherwise;

    private static Vector3D Perpendicular(in Vector3D u)
    {
        Vector3D axis = Math.Abs(u.X) < 0.5 ? Affine.Identity.X : Affine.Identity.Y;
        Vector3D across = Vector3D.Cross(u, axis);
        return across * (1 / across.Length);
    }
}
