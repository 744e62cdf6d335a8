using System;
using System.Numerics;
using Gjk.Core;

namespace NearestObstacle;

/// <summary>Convex meshes in all directions around the arm, the same for the same seed.</summary>
internal static class Obstacles
{
    /// <summary>Metres from the shoulder: the obstacles leave room for the upper arm, not for the hand.</summary>
    private const float NearRadius = 0.9f, FarRadius = 1.9f;

    private static readonly Vector3 Shoulder = new(0, 0.3f, 0);

    public static void AddTo(CollisionScene scene, int count, int seed)
    {
        var random = new Random(seed);
        for (int i = 0; i < count; i++)
        {
            float radius = NearRadius + (FarRadius - NearRadius) * random.NextSingle();
            var pose = new RigidPose(Shoulder + radius * Direction(random));
            scene.Add(ConvexShape.Mesh(Rock(random)), pose, new ObjectSettings(isStatic: true));
        }
    }

    /// <summary>The corners of a rock: points on an ellipsoid, whose hull the mesh is.</summary>
    private static Vector3[] Rock(Random random)
    {
        var radii = new Vector3(Size(random), Size(random), Size(random));
        var points = new Vector3[12 + random.Next(30)];
        for (int i = 0; i < points.Length; i++) points[i] = radii * Direction(random);
        return points;
    }

    private static float Size(Random random) => 0.03f + 0.07f * random.NextSingle();

    /// <summary>A unit vector; all directions are equally likely.</summary>
    private static Vector3 Direction(Random random)
    {
        float y = 2 * random.NextSingle() - 1, angle = MathF.Tau * random.NextSingle();
        float r = MathF.Sqrt(1 - y * y);
        return new Vector3(r * MathF.Cos(angle), y, r * MathF.Sin(angle));
    }
}
