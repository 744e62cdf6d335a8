namespace Gjk.Exact.Meshes;

/// <summary>Outlines drawn up along y, and the torus, whose outline goes round.</summary>
public static class Extrusions
{
    /// <summary>A regular prism, as a "cylinder" with so many sides.</summary>
    public static Vector3[] Prism(Rng random)
    {
        var t = Trigonometry.Any(random);
        int sides = random.OneIn(6) ? 3 + random.Below(62) : Lathe.Count(random);
        double radius = random.Range(0.2, 1);
        double half = random.OneIn(4) ? random.Magnitude(1e-4, 1e-1) : random.Range(0.2, 2);
        (double, double)[] profile = random.OneIn(2)
            ? [(radius, half), (radius, -half)]
            : [(0, half), (radius, half), (radius, -half), (0, -half)];
        return Lathe.Turned(t, profile, sides, random.OneIn(2));
    }

    /// <summary>Teeth with flat heads on a wheel: every other pair of corners is inside of the hull.</summary>
    public static Vector3[] Gear(Rng random)
    {
        var t = Trigonometry.Any(random);
        int teeth = 3 + random.Below(14);
        double root = random.Range(0.6, 0.95), half = random.Range(0.05, 0.5);
        var points = new List<Vector3>();
        for (int i = 0; i < 4 * teeth; i++)
        {
            double radius = i % 4 < 2 ? 1 : root;
            points.Add(t.OnRing(radius, half, i, 4 * teeth));
            points.Add(t.OnRing(radius, -half, i, 4 * teeth));
        }

        return [.. points];
    }

    /// <summary>A ring of rings: the hull has two wide flat faces, a belt of quads and nothing of the hole.</summary>
    public static Vector3[] Torus(Rng random)
    {
        var t = Trigonometry.Any(random);
        int around = Lathe.Count(random), across = Lathe.Count(random);
        double tube = random.Range(0.05, 0.5);
        var points = new List<Vector3>();
        for (int j = 0; j < across; j++)
        {
            (double sin, double cos) = t.OfHalfTurns(2 * j, across);
            for (int i = 0; i < around; i++) points.Add(t.OnRing(1 + tube * cos, tube * sin, i, around));
        }

        return [.. points];
    }

    /// <summary>A logarithmic spiral, flat or rising: neighbours of every size in one outline.</summary>
    public static Vector3[] Spiral(Rng random)
    {
        var points = new Vector3[6 + random.Below(60)];
        double grow = random.Range(0.01, 0.3), rise = random.OneIn(2) ? 0 : random.Range(0.01, 0.2);
        for (int i = 0; i < points.Length; i++)
        {
            double radius = Math.Exp(-grow * i);
            (double sin, double cos) = Math.SinCos(0.5 * i);
            points[i] = new Vector3((float)(radius * cos), (float)(rise * i), (float)(radius * sin));
        }

        return points;
    }
}
