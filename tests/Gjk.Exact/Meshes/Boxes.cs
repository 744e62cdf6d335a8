namespace Gjk.Exact.Meshes;

/// <summary>Boxes as modellers store them: bevelled, with every corner once for each of its three faces, welded or
/// nearly.</summary>
public static class Boxes
{
    /// <summary>Every corner becomes three, each moved in along the other two axes by the width of the bevel, from a
    /// tenth down to the last place of a float.</summary>
    public static Vector3[] Bevelled(Rng random)
    {
        float bevel = (float)random.Magnitude(1e-7, 1e-1);
        Vector3 half = Half(random);
        var points = new List<Vector3>();
        foreach (Vector3 corner in Clouds.Box(Vector3.One))
        {
            for (int axis = 0; axis < 3; axis++)
            {
                var inward = new Vector3(axis == 0 ? 0 : bevel, axis == 1 ? 0 : bevel, axis == 2 ? 0 : bevel);
                points.Add(corner * (half - half * inward));
            }
        }

        return [.. points];
    }

    /// <summary>A cube of 24 vertices, four for each face.</summary>
    public static Vector3[] ByFaces(Rng random)
    {
        Vector3[] corners = Clouds.Box(random.OneIn(2) ? new Vector3(0.5f) : Half(random));
        return [.. corners, .. corners, .. corners];
    }

    /// <summary>The same where the three copies of a corner were computed in three ways, and differ by a last
    /// place.</summary>
    public static Vector3[] NearlyWelded(Rng random) => Copies.OneFloatApart(random, ByFaces(random), 1);

    private static Vector3 Half(Rng random) =>
        new(random.Float(0.1, 1), random.Float(0.1, 1), random.Float(0.1, 1));
}
