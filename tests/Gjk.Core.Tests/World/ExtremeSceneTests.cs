namespace Gjk.Core.Tests.World;

/// <summary>Objects with sides from 1e-38 to the largest float in one scene: for every broad phase, what is found is
/// what asking each object alone says.</summary>
public class ExtremeSceneTests
{
    private const int Objects = 24, Frames = 3, Questions = 12;

    [Fact]
    public void ASphereBesideAPlateAsLargeAsFloats()
    {
        ConvexShape sphere = ConvexShape.Sphere(1), plate = ConvexShape.Box(new Vector3(3e38f, 1, 3e38f));
        foreach (CollisionScene scene in Scenes())
        {
            int id = scene.Add(plate, RigidPose.Identity);
            var above = new RigidPose(4e37f * Vector3.UnitY);
            List<int> touching = [];
            Vector3 down = -2 * above.Position;
            Assert.True(scene.TryFindCastHit(sphere, above, down, out CastHit cast));
            Assert.True(id == cast.Id && cast.Fraction == 0.5f, $"{cast.Fraction}");
            Assert.True(scene.TryFindRayHit(new RayQuery(above.Position, down), out RayHit _));
            Assert.True(scene.TryFindNearest(sphere, above, out PairDistance r));
            Assert.Equal(4e37f, r.Distance);
            scene.FindObjectsOverlapping(sphere, new RigidPose(1.5f * Vector3.UnitY), touching);
            Assert.Equal([id], touching);
        }
    }

    [Fact]
    public void WhatIsFoundIsWhatAskingAloneSays()
    {
        int found = 0, asked = 0;
        for (ulong seed = 0; seed < (ulong)Budget.Count(20); seed++)
        {
            var rng = new Rng(seed);
            CollisionScene[] scenes = Scenes();
            var shapes = new ConvexShape[Objects];
            var poses = new RigidPose[Objects];
            for (int i = 0; i < Objects; i++)
            {
                (shapes[i], poses[i]) = (Shape(rng), Pose(rng));
                foreach (CollisionScene scene in scenes) Assert.Equal(i, scene.Add(shapes[i], poses[i]));
            }

            for (int frame = 0; frame < Frames; frame++)
            {
                for (int k = 0; k < Questions; k++, asked += 3 * Objects)
                    found += Check(rng, scenes, shapes, poses, $"seed {seed}, frame {frame}, {k}");
                int moved = rng.Below(Objects);
                poses[moved] = Pose(rng);
                foreach (CollisionScene scene in scenes) scene.Move(moved, poses[moved]);
            }
        }

        Assert.InRange((double)found / asked, 0.1, 0.7);
    }

    private static int Check(
        Rng rng, CollisionScene[] scenes, ConvexShape[] shapes, RigidPose[] poses, string message)
    {
        ConvexShape shape = Shape(rng);
        RigidPose pose = Pose(rng);
        Vector3 motion = Vector(rng);
        int[] all = [.. Enumerable.Range(0, Objects)];
        int[] touching = [.. all.Where(i => ConvexQuery.Overlaps(shape, pose, shapes[i], poses[i]))];
        var ray = new RayQuery(pose.Position, motion);
        int[] rays = [.. all.Where(
            i => ConvexQuery.RayCast(shapes[i], poses[i], ray.Origin, ray.Direction, ray.MaxDistance).MayHit)];
        int[] casts = [.. all.Where(
            i => ConvexQuery.Cast(shape, pose, motion, shapes[i], poses[i], Vector3.Zero).MayHit)];
        float nearest = all.Min(i => ConvexQuery.Distance(shape, pose, shapes[i], poses[i]).Distance);
        foreach (CollisionScene scene in scenes)
        {
            string where = $"{message}";
            List<int> ids = [];
            scene.FindObjectsOverlapping(shape, pose, ids);
            Assert.True(touching.SequenceEqual(ids), $"{where}: overlapping");
            List<RayHit> rayHits = [];
            scene.FindRayHits(ray, rayHits);
            Assert.True(rays.SequenceEqual(rayHits.Select(h => h.Id).Order()), $"{where}: on the ray");
            List<CastHit> castHits = [];
            scene.FindCastHits(shape, pose, motion, castHits);
            Assert.True(casts.SequenceEqual(castHits.Select(h => h.Id).Order()), $"{where}: in the way");
            Assert.True(scene.TryFindNearest(shape, pose, out PairDistance r) && r.Distance == nearest, where);
        }

        return touching.Length + rays.Length + casts.Length;
    }

    private static CollisionScene[] Scenes() =>
        [.. Enum.GetValues<BroadPhaseKind>().Select(kind => new CollisionScene(kind))];

    private static ConvexShape Shape(Rng rng) => rng.Below(3) == 0
        ? ConvexShape.Sphere(Math.Abs(Number(rng)))
        : ConvexShape.Box(Vector3.Abs(Vector(rng)));

    private static RigidPose Pose(Rng rng) =>
        new(rng.Below(2) == 0 ? Quaternion.Identity : rng.Rotation(), rng.Below(2) == 0 ? default : Vector(rng));

    private static Vector3 Vector(Rng rng) => new(Number(rng), Number(rng), Number(rng));

    /// <summary>Distances of such numbers are floats still.</summary>
    private static float Number(Rng rng)
    {
        float size = rng.Below(3) switch { 0 => 3e37f, 1 => 1 + rng.Below(3), _ => rng.LogFloat(1e-38, 3e37) };
        return rng.Below(2) == 0 ? size : -size;
    }
}
