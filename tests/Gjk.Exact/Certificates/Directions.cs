namespace Gjk.Exact.Certificates;

/// <summary>Unit directions to look at a shape from.</summary>
public static class Directions
{
    /// <summary>Across the faces, edges and corners of a cube.</summary>
    public static readonly Double3[] Few = Lattice(1);

    /// <summary>Those and finer ones, and some that are on no lattice.</summary>
    public static readonly Double3[] Many = [.. Lattice(2), .. Scattered(60)];

    private static Double3[] Lattice(int reach)
    {
        var found = new List<Double3>();
        for (int x = -reach; x <= reach; x++)
        {
            for (int y = -reach; y <= reach; y++)
            {
                for (int z = -reach; z <= reach; z++)
                {
                    var v = new Double3(x, y, z);
                    if (v.LengthSquared > 0) found.Add(v * (1 / v.Length));
                }
            }
        }

        return [.. found];
    }

    private static IEnumerable<Double3> Scattered(int count)
    {
        var random = new Rng(1);
        for (int i = 0; i < count; i++) yield return random.Direction();
    }
}
