using System;
using System.Collections.Generic;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Bench.Scenes;

/// <summary>
/// The report's two scenes after its description: 20 objects of unit size in random orientations, ten on a 5 x 2 grid two apart so that none
/// touch, ten on another, 2.25 above, whose two columns stand so close that its five pairs overlap.
/// </summary>
public static class ReportScenes
{
    public const string Cubes = "cubes";
    public const string Spheres = "spheres";

    private const float Spacing = 2;
    private const float Height = 2.25f;

    /// <summary>Less than twice the radius of the largest ball inside either mesh, so that a pair overlaps in any orientation.</summary>
    private const float CloseSpacing = 0.75f;

    private const ulong Seed = 2022;

    public static IReadOnlyList<string> Names { get; } = [Cubes, Spheres];

    public static BenchScene Create(string name)
    {
        Vector3[] vertices = name switch
        {
            Cubes => MeshVertices.Cube(0.5f),
            Spheres => MeshVertices.Sphere(0.5f),
            _ => throw new ArgumentOutOfRangeException(nameof(name), name, "No such scene."),
        };
        var shape = ConvexShape.Mesh(vertices);
        var prng = new Prng(Seed);
        var scene = new BenchScene();
        for (int level = 0; level < 2; level++)
        {
            float columnSpacing = level == 0 ? Spacing : CloseSpacing;
            for (int row = 0; row < 5; row++)
                for (int column = 0; column < 2; column++)
                    scene.Add(shape, vertices, new RigidPose(prng.Rotation(), new Vector3(column * columnSpacing, level * Height, row * Spacing)));
        }

        return scene.WithAllPairs();
    }
}
