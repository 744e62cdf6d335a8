namespace Gjk.Core.Tests.Concave;

/// <summary>A height field by its numbers, and its triangles as the documentation promises them.</summary>
internal sealed class RandomField
{
    public int Columns, Rows;
    public float[] Heights = [];
    public Vector2 Spacing;
    public bool[] IsHole = [];
    public bool IsZUp;
    public float? Base;

    public static RandomField Make(Rng random, float size, bool? hasBase = null)
    {
        int columns = 2 + random.Below(9), rows = 2 + random.Below(9);
        var made = new RandomField
        {
            Columns = columns,
            Rows = rows,
            Heights = new float[columns * rows],
            Spacing = new Vector2(random.Float(0.1f, 0.4f), random.Float(0.1f, 0.4f)) * size,
            IsHole = new bool[(columns - 1) * (rows - 1)],
            IsZUp = random.OneIn(2),
            Base = hasBase ?? random.OneIn(2) ? -size : null,
        };
        for (int i = 0; i < made.Heights.Length; i++) made.Heights[i] = RandomHeight(random, size);
        int oneIn = random.Of(2, 5, int.MaxValue);
        for (int i = 1; i < made.IsHole.Length; i++) made.IsHole[i] = random.OneIn(oneIn);
        return made;
    }

    public static float RandomHeight(Rng random, float size) =>
        random.OneIn(3) ? 0 : random.Float(-0.5f, 0.5f) * size;

    public TriangleMesh Build() => TriangleMesh.FromHeights(
        Heights, Columns, Spacing, Array.IndexOf(IsHole, true) < 0 ? null : IsHole, IsZUp, Base);

    /// <summary>As a mesh of a list, made another way: sides without a neighbour are found by a search.</summary>
    public TriangleMesh Listed()
    {
        var points = new List<Vector3>();
        var top = new List<(int A, int B, int C)>();
        foreach (float? level in Base is null ? new float?[] { null } : [null, Base])
            for (int i = 0; i < Heights.Length; i++)
                points.Add(Place(i % Columns * Spacing.X, level ?? Heights[i], i / Columns * Spacing.Y));
        for (int cell = 0; cell < IsHole.Length; cell++)
        {
            if (IsHole[cell]) continue;
            int i = cell / (Columns - 1) * Columns + cell % (Columns - 1);
            top.Add(Up(i, i + Columns, i + 1));
            top.Add(Up(i + 1, i + Columns, i + Columns + 1));
        }

        List<(int A, int B, int C)> all = [.. top];
        if (Base is not null)
        {
            int below = Heights.Length;
            all.AddRange(top.Select(t => (t.A + below, t.C + below, t.B + below)));
            var sides = top.SelectMany(t => new[] { (t.A, t.B), (t.B, t.C), (t.C, t.A) }).ToList();
            HashSet<(int, int)> known = [.. sides];
            foreach ((int from, int to) in sides)
            {
                if (known.Contains((to, from))) continue;
                all.Add((to, from, from + below));
                all.Add((to, from + below, to + below));
            }
        }

        return new TriangleMesh(points, [.. all.SelectMany(t => new[] { t.A, t.B, t.C })]);
    }

    /// <summary>The height of the surface at a place; minus infinity where there is none.</summary>
    public double GroundAt(double x, double across)
    {
        double u = x / Spacing.X, v = across / Spacing.Y;
        int column = (int)Math.Floor(u), row = (int)Math.Floor(v);
        if (column < 0 || row < 0 || column > Columns - 2 || row > Rows - 2 || IsHole[row * (Columns - 1) + column])
            return double.NegativeInfinity;
        (u, v) = (u - column, v - row);
        int i = row * Columns + column;
        double right = Heights[i + 1], far = Heights[i + Columns];
        return u + v < 1
            ? Heights[i] + u * (right - Heights[i]) + v * (far - Heights[i])
            : right + far - Heights[i + Columns + 1] + (u * (Heights[i + Columns + 1] - far))
                + (v * (Heights[i + Columns + 1] - right));
    }

    public double Volume()
    {
        double sum = 0;
        for (int cell = 0; cell < IsHole.Length; cell++)
        {
            if (IsHole[cell]) continue;
            int i = cell / (Columns - 1) * Columns + cell % (Columns - 1);
            double middle = (double)Heights[i + 1] + Heights[i + Columns];
            double mean = (2 * middle + Heights[i] + Heights[i + Columns + 1]) / 6 - Base!.Value;
            sum += mean * Spacing.X * Spacing.Y;
        }

        return sum;
    }

    private Vector3 Place(float x, float height, float across) =>
        IsZUp ? new(x, across, height) : new(x, height, across);

    private (int A, int B, int C) Up(int a, int b, int c) => IsZUp ? (a, c, b) : (a, b, c);
}
