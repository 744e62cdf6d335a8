namespace Gjk.Exact.Meshes;

/// <summary>Meshes of about unit size as people and programs make them.</summary>
public static class MadeMeshes
{
    public static Vector3[] Any(Rng random) => random.Below(8) switch
    {
        0 => Copies.OneFloatApart(random, Small(random), 1 + random.Below(3)),
        1 => Copies.Unwelded(random, Small(random)),
        2 => Copies.Scanned(random, Regular(random), random.Magnitude(1e-7, 1e-2)),
        3 => Copies.Welded(Regular(random)),
        _ => Regular(random),
    };

    /// <summary>Resized and turned in float, as an exporter bakes a transform into the vertices.</summary>
    public static Vector3[] Baked(Rng random)
    {
        Vector3[] cloud = Any(random);
        Quaternion turn = Rotations.Any(random);
        Vector3 size = random.OneIn(2)
            ? Vector3.One
            : new Vector3(random.Float(0.2, 3), random.Float(0.2, 3), random.Float(0.2, 3));
        return Array.ConvertAll(cloud, p => Vector3.Transform(p * size, turn));
    }

    private static Vector3[] Regular(Rng random) => random.Below(15) switch
    {
        0 => Lathe.Egg(random),
        1 => Lathe.Hemisphere(random),
        2 => Lathe.Capsule(random),
        3 => Lathe.Bottle(random),
        4 => Lathe.Vase(random),
        5 => Lathe.Cone(random),
        6 => Extrusions.Torus(random),
        7 => Extrusions.Prism(random),
        8 => Extrusions.Gear(random),
        9 => Extrusions.Spiral(random),
        10 => Boxes.Bevelled(random),
        11 => Boxes.ByFaces(random),
        12 => Icosphere.Any(random),
        13 => Boxes.NearlyWelded(random),
        _ => Lathe.Sphere(random),
    };

    /// <summary>What may be repeated without becoming large.</summary>
    private static Vector3[] Small(Rng random) => random.Below(4) switch
    {
        0 => Boxes.Bevelled(random),
        1 => Clouds.InBox(random, 4 + random.Below(20), Vector3.One),
        2 => Extrusions.Prism(random),
        _ => Lathe.Sphere(random),
    };
}
