using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Gjk.Core;
using Gjk.Exact.Scenes;

namespace Gjk.Targets;

/// <summary>Asks every question about the pairs of shapes of all kinds, and about a scene of them, and counts what that
/// allocates once everything has run.</summary>
internal static class Allocation
{
    private const int WarmUpFrames = 20, Frames = 20;

    private static readonly Vector3 Motion = new(0.3f, -0.2f, 0.1f);

    /// <summary>Bytes in all frames together.</summary>
    public static long OfQueries()
    {
        ConvexShape[] shapes =
        [
            ConvexShape.Mesh(BuiltInScenes.Cubes().Vertices), ConvexShape.Mesh(BuiltInScenes.Spheres().Vertices),
            ConvexShape.Box(new Vector3(0.5f)), ConvexShape.Sphere(0.5f), ConvexShape.Capsule(0.3f, 0.4f),
            ConvexShape.Cylinder(0.5f, 0.5f), ConvexShape.Cone(0.5f, 0.5f),
            ConvexShape.Box(new Vector3(0.3f)).Rounded(0.1f),
        ];
        RigidPose[] poses = [.. BuiltInScenes.Cubes().Poses];
        ConvexShape[] objects = [.. poses.Select((_, i) => shapes[i % shapes.Length])];
        var scene = new CollisionScene();
        for (int i = 0; i < poses.Length; i++) scene.Add(objects[i], poses[i]);
        var found = new List<ObjectPair>();
        var warmStarts = new WarmStart[poses.Length * poses.Length];
        for (int i = 0; i < WarmUpFrames; i++) Frame(objects, poses, warmStarts, scene, found);
        long before = AllocatedBytes.Now();
        for (int i = 0; i < Frames; i++) Frame(objects, poses, warmStarts, scene, found);
        return AllocatedBytes.Now() - before;
    }

    private static void Frame(
        ConvexShape[] shapes, RigidPose[] poses, WarmStart[] warmStarts, CollisionScene scene, List<ObjectPair> found)
    {
        for (int a = 0; a < poses.Length; a++)
        {
            for (int b = a + 1; b < poses.Length; b++)
            {
                ConvexQuery.Distance(shapes[a], poses[a], shapes[b], poses[b]);
                ConvexQuery.Distance(
                    shapes[a], poses[a], shapes[b], poses[b], ref warmStarts[a * poses.Length + b]);
                ConvexQuery.SignedDistance(shapes[a], poses[a], shapes[b], poses[b]);
                ConvexQuery.Contacts(shapes[a], poses[a], shapes[b], poses[b], 0.02f, out ContactManifold _);
                ConvexQuery.Overlaps(shapes[a], poses[a], shapes[b], poses[b]);
                ConvexQuery.Cast(shapes[a], poses[a], default, shapes[b], poses[b], Motion);
                ConvexQuery.RayCast(shapes[a], poses[a], poses[b].Position, Motion, 10);
            }

            scene.Move(a, poses[a]);
        }

        scene.FindOverlaps(found);
    }
}
