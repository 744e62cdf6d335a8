namespace Gjk.Exact.Fuzz.Concave;

/// <summary>A height field by its numbers.</summary>
/// <param name="Heights">Row by row.</param>
/// <param name="Columns">How many a row has.</param>
/// <param name="Spacing">Between columns and between rows.</param>
/// <param name="IsHole">By cell, row by row; null: none.</param>
/// <param name="IsZUp">Whether heights are z.</param>
/// <param name="Base">The height of the bottom, or null.</param>
internal sealed record RawField(
    float[] Heights, int Columns, Vector2 Spacing, bool[]? IsHole = null, bool IsZUp = false, float? Base = null)
{
    /// <summary>As the library makes it.</summary>
    public TriangleMesh Build() => TriangleMesh.FromHeights(Heights, Columns, Spacing, IsHole, IsZUp, Base);

    /// <summary>The triangles that the documentation promises: those on top, as many at the bottom, then walls below
    /// each side that no other triangle on top goes along the other way.</summary>
    public TriangleSoup List()
    {
        var top = new List<(int A, int B, int C)>();
        int below = Heights.Length, cell = 0;
        for (int i = 0; i + Columns < below; i++)
        {
            if (i % Columns == Columns - 1) continue;
            if (IsHole is not null && IsHole[cell++]) continue;
            top.Add(Up(i, i + Columns, i + 1));
            top.Add(Up(i + 1, i + Columns, i + Columns + 1));
        }

        List<(int A, int B, int C)> all = [.. top];
        if (Base is not null)
        {
            all.AddRange(top.Select(t => (t.A + below, t.C + below, t.B + below)));
            (int From, int To)[] sides = [.. top.SelectMany(t => new[] { (t.A, t.B), (t.B, t.C), (t.C, t.A) })];
            HashSet<(int, int)> known = [.. sides];
            foreach ((int from, int to) in sides)
            {
                if (known.Contains((to, from))) continue;
                all.Add((to, from, from + below));
                all.Add((to, from + below, to + below));
            }
        }

        IEnumerable<Vector3> points = Enumerable.Range(0, below).Select(i => Place(i, Heights[i]));
        if (Base is { } low) points = points.Concat(Enumerable.Range(0, below).Select(i => Place(i, low)));
        return new TriangleSoup([.. points], [.. all.SelectMany(t => new[] { t.A, t.B, t.C })]);
    }

    private Vector3 Place(int vertex, float height)
    {
        float x = vertex % Columns * Spacing.X, across = vertex / Columns * Spacing.Y;
        return IsZUp ? new Vector3(x, across, height) : new Vector3(x, height, across);
    }

    private (int A, int B, int C) Up(int a, int b, int c) => IsZUp ? (a, c, b) : (a, b, c);
}
