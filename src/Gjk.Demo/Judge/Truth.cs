namespace Gjk.Demo.Judge;

/// <summary>What the answers of a file are.</summary>
internal enum TruthKind
{
    Distance,
    Depth,
    Point,
    Cast,
}

/// <summary>The proved answer of one pair of a scene.</summary>
internal sealed class Truth
{
    private Truth(TruthKind kind, CsvRow row, Scene scene)
    {
        Kind = kind;
        (IndexA, IndexB) = (row.Index("a"), row.Index("b"));
        (A, B) = (scene.Objects[IndexA], scene.Objects[IndexB]);
        Case = row["case"];
        Row = row;
        Scale = row.Has("scale") ? row.Number("scale") : Math.Max(LongestSide(A.Shape), LongestSide(B.Shape));
        Tolerance = row.Has("tolerance") ? row.Number("tolerance") : 0;
        if (kind == TruthKind.Cast) return;
        switch (kind)
        {
            case TruthKind.Distance:
                Overlaps = row.Flag("overlap");
                Distance = row.Number("distance");
                Depth = row.Number(row.Has("depth") ? "depth" : "depth_hint");
                break;
            case TruthKind.Depth:
                double depth = row.Number("depth");
                Overlaps = depth >= 0;
                (Distance, Depth) = (Math.Max(-depth, 0), Math.Max(depth, 0));
                break;
            default:
                Overlaps = row["inside"] != "false";
                Distance = Overlaps ? 0 : row.Number("distance");
                Depth = Overlaps ? row.Number("distance") : 0;
                break;
        }
    }

    public TruthKind Kind { get; }

    public int IndexA { get; }

    public int IndexB { get; }

    public SceneObject A { get; }

    public SceneObject B { get; }

    /// <summary>Family, orientation, gap, or whatever the file calls it.</summary>
    public string Case { get; }

    /// <summary>The line of the file.</summary>
    public CsvRow Row { get; }

    /// <summary>Length: the longest side of the two local boxes.</summary>
    public double Scale { get; }

    /// <summary>How far the truth itself may be off: a length, or a fraction of a cast. Most often 0.</summary>
    public double Tolerance { get; }

    /// <summary>Touching is overlapping, too.</summary>
    public bool Overlaps { get; }

    /// <summary>0 where they overlap.</summary>
    public double Distance { get; }

    /// <summary>0 where they are apart. Of distances it says only how clear the overlap is.</summary>
    public double Depth { get; }

    /// <summary>Reads the answers, which must be those of the scene's pairs in their order.</summary>
    /// <exception cref="RefusedException">They are not.</exception>
    public static List<Truth> Read(CsvTable table, Scene scene)
    {
        table.Require("a", "b", "case");
        TruthKind kind = KindOf(table);
        var truths = new List<Truth>();
        ScenePairs.Enumerator pairs = scene.Pairs.GetEnumerator();
        foreach (CsvRow row in table.Rows)
        {
            if (!pairs.MoveNext()) throw row.Refuse("a", "the scene has no further pair");
            (int a, int b) = pairs.Current;
            if (row.Index("a") != a) throw row.Refuse("a", $"the scene's next pair is {a},{b}");
            if (row.Index("b") != b) throw row.Refuse("b", $"the scene's next pair is {a},{b}");
            truths.Add(new Truth(kind, row, scene));
        }

        if (truths.Count != scene.Pairs.Count)
            throw table.Refuse(truths.Count + 1, $"ends after {truths.Count} of the scene's {scene.Pairs.Count} pairs");
        return truths;
    }

    private static TruthKind KindOf(CsvTable table)
    {
        if (table.Has("outcome")) table.Require("fraction");
        else if (table.Has("inside")) table.Require("distance");
        else if (!table.Has("overlap")) table.Require("depth");
        else table.Require("distance", table.Has("depth") ? "depth" : "depth_hint");
        if (table.Has("outcome")) return TruthKind.Cast;
        if (table.Has("inside")) return TruthKind.Point;
        return table.Has("overlap") ? TruthKind.Distance : TruthKind.Depth;
    }

    private static double LongestSide(in ConvexShape shape)
    {
        double longest = 0;
        foreach (Double3 axis in (ReadOnlySpan<Double3>)[new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)])
        {
            shape.Support(axis, out Double3 most);
            shape.Support(-axis, out Double3 least);
            longest = Math.Max(longest, Double3.Dot(axis, most - least) + 2 * shape.Margin);
        }

        return longest;
    }
}
