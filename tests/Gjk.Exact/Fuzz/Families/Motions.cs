namespace Gjk.Exact.Fuzz.Families;

/// <summary>How a pair may move, each kind hard for a cast in its own way.</summary>
internal static class Motions
{
    /// <summary>Halvings of an interval until doubles end it.</summary>
    private const int Halvings = 60;

    /// <summary>The largest motion that is drawn, in world units: positions stay within floats.</summary>
    private const double Largest = 1e37;

    private static readonly (string Name, int Weight, Func<Rng, FuzzPair, Double3> Draw)[] All =
    [
        ("any", 3, (r, p) => r.Direction() * (r.Range(0, 2) * Reach(p))),
        ("aimed", 5, Aimed),
        ("grazing", 5, Grazing),
        ("sliding", 5, Sliding),
        ("tiny", 2, (r, p) => Toward(r, p) * (p.Scale * r.Magnitude(1e-7, 1e-5))),
        ("huge", 2, (r, p) => Toward(r, p) * (p.Scale * r.Magnitude(1e4, 1e6))),
        ("leaving", 2, (r, p) => (Double3)p.Answer.Normal * (r.Range(0.1, 2) * Reach(p))),
        ("none", 1, (_, _) => default),
    ];

    /// <summary>Draws how the pair moves; either shape or both do.</summary>
    public static PairMotion Draw(Rng random, FuzzPair pair)
    {
        int weights = 0, i = 0;
        foreach ((_, int weight, _) in All) weights += weight;
        int left = random.Below(weights);
        while (left >= All[i].Weight) left -= All[i++].Weight;
        Double3 relative = All[i].Draw(random, pair);
        if (!(relative.Length < Largest)) relative = default;
        switch (random.Below(4))
        {
            case 0:
                return new PairMotion((Vector3)(-relative), Vector3.Zero);
            case 1:
                // Both go the same way and one goes on: what they share cancels, but for the rounding to float.
                Double3 shared = random.Direction() * (random.Range(0, 2) * Math.Min(Reach(pair), Largest));
                return new PairMotion((Vector3)shared, (Vector3)(shared + relative));
            default:
                return new PairMotion(Vector3.Zero, (Vector3)relative);
        }
    }

    /// <summary>From centre to centre, or past it; half of what it meets is met before the end.</summary>
    private static Double3 Aimed(Rng random, FuzzPair pair)
    {
        Double3 aside = random.Direction() * (0.5 * pair.Scale * random.Unit());
        return (aside - pair.Centers) * random.Range(0.3, 2);
    }

    /// <summary>So that a plane stays between the shapes, or nearly: of two directions, one with a gap and one without,
    /// the mean is found across which the gap is next to nothing. B's furthest point then goes past A's in that
    /// plane.</summary>
    private static Double3 Grazing(Rng random, FuzzPair pair)
    {
        Double3 open = pair.Answer.Normal, closed = Placement.FaceNormal(random, pair.BodyA);
        if (open == default) return Aimed(random, pair);
        double gap = random.OneIn(3) ? 0 : random.Sign() * random.Magnitude(1e-12, 1e-6) * pair.Scale;
        if (pair.Gap(closed) > gap) closed = -closed;
        if (!(pair.Gap(open) > gap && pair.Gap(closed) <= gap)) return Aimed(random, pair);
        Double3 n = open;
        for (int i = 0; i < Halvings; i++)
        {
            Double3 mean = open + closed;
            double length = mean.Length;
            if (!(length > 0)) break;
            n = mean * (1 / length);
            if (pair.Gap(n) > gap) open = n;
            else closed = n;
        }

        Double3 way = FurthestOf(pair.A, pair.BodyA, n) - FurthestOf(pair.B, pair.BodyB, -n) - pair.Centers;
        return (way - n * Double3.Dot(way, n)) * random.Range(0.8, 3);
    }

    /// <summary>Along the plane between the shapes, or along a face of A.</summary>
    private static Double3 Sliding(Rng random, FuzzPair pair)
    {
        Double3 n = pair.Answer.Normal;
        if (n == default || random.OneIn(3)) n = Placement.FaceNormal(random, pair.BodyA);
        double length = n.Length;
        n *= 1 / length;
        Double3 to = random.OneIn(2) ? random.Direction() : pair.Centers * (1 / Math.Max(pair.Centers.Length, 1e-300));
        Double3 along = to - n * Double3.Dot(to, n);
        return along * (random.Sign() * random.Range(0.1, 3) * Reach(pair));
    }

    private static Double3 Toward(Rng random, FuzzPair pair)
    {
        Double3 n = random.OneIn(2) ? -(Double3)pair.Answer.Normal : -pair.Centers;
        double length = n.Length;
        return length > 0 && !random.OneIn(4) ? n * (1 / length) : random.Direction();
    }

    private static Double3 FurthestOf(in ConvexShape shape, PosedShape body, in Double3 direction)
    {
        shape.Support(body.InverseRotate(direction), out Double3 point);
        return body.Rotate(shape.Center - body.Center + point) + direction * shape.Margin;
    }

    /// <summary>A way that leads past the other shape.</summary>
    private static double Reach(FuzzPair pair) => pair.Scale + pair.Centers.Length;
}
