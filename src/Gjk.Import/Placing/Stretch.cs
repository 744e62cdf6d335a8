namespace Gjk.Import;

/// <summary>A linear map as a rotation, a scale along the axes and another rotation: map = After * diag(Factors) *
/// Before. A scene's object can hold all three, so a round shape under skew stays exact.</summary>
/// <remarks>One-sided Jacobi rotations (Hestenes 1958, "Inversion of matrices by biorthogonalization") turn pairs of
/// columns until all are at right angles. Three columns converge within a few rounds; the number of rounds is limited
/// anyway.</remarks>
internal readonly record struct Stretch(TurnD After, Double3 Factors, TurnD Before)
{
    /// <summary>Rounds over the three pairs of columns. The convergence is quadratic, so ten is plenty.</summary>
    private const int MostRounds = 30;

    /// <summary>Cosine between two columns that counts as a right angle: the rounding of its own computation.</summary>
    private const double RightAngle = 1e-15;

    public static Stretch Of(in Affine map)
    {
        Double3[] columns = [map.X, map.Y, map.Z];
        Double3[] before = [Affine.Identity.X, Affine.Identity.Y, Affine.Identity.Z];
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
        Double3 u = Unit(columns[order[0]], Affine.Identity.X);
        Double3 v = Unit(columns[order[1]], Perpendicular(u));
        Double3 w = Double3.Cross(u, v);
        Double3 a = before[order[0]], b = before[order[1]], c = Double3.Cross(a, b);
        var factors = new Double3(
            columns[order[0]].Length, columns[order[1]].Length, Double3.Dot(w, map.Turn(c)));
        TurnD toAxes = TurnD.FromAxes(a, b, c);
        return new Stretch(
            TurnD.FromAxes(u, v, w), factors, new TurnD(-toAxes.X, -toAxes.Y, -toAxes.Z, toAxes.W));
    }

    /// <summary>Turns two columns within their plane until they are at right angles. False if they were.</summary>
    private static bool MakeSquare(Double3[] columns, Double3[] before, int i, int j)
    {
        double dot = Double3.Dot(columns[i], columns[j]);
        double lengths = columns[i].Length * columns[j].Length;
        if (Math.Abs(dot) <= RightAngle * lengths || lengths == 0) return false;
        double zeta = (columns[j].LengthSquared - columns[i].LengthSquared) / (2 * dot);
        double tangent = (zeta >= 0 ? 1 : -1) / (Math.Abs(zeta) + Math.Sqrt(1 + zeta * zeta));
        double cosine = 1 / Math.Sqrt(1 + tangent * tangent);
        Turn(columns, i, j, cosine, cosine * tangent);
        Turn(before, i, j, cosine, cosine * tangent);
        return true;
    }

    private static void Turn(Double3[] columns, int i, int j, double cosine, double sine)
    {
        Double3 x = columns[i], y = columns[j];
        columns[i] = x * cosine - y * sine;
        columns[j] = x * sine + y * cosine;
    }

    private static Double3 Unit(in Double3 v, in Double3 otherwise) =>
        v.LengthSquared > 0 ? v * (1 / v.Length) : otherwise;

    private static Double3 Perpendicular(in Double3 u)
    {
        Double3 axis = Math.Abs(u.X) < 0.5 ? Affine.Identity.X : Affine.Identity.Y;
        Double3 across = Double3.Cross(u, axis);
        return across * (1 / across.Length);
    }
}
