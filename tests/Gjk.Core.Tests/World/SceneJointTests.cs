using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>Parts that are flush or in each other push as their union does: straight up from a floor, whatever is
/// buried in it.</summary>
public class SceneJointTests
{
    private const float Reach = 0.02f;

    private static readonly ObjectSettings Still = new(isStatic: true);

    private readonly List<PairContacts> _contacts = [];

    /// <summary>The shortest way out of each tile leads into the other one.</summary>
    [Theory]
    [InlineData("boxes")]
    [InlineData("compound")]
    [InlineData("solids")]
    public void WhatStandsOnASeamIsLifted(string floor)
    {
        var random = new Rng(9);
        for (int i = 0; i < 60; i++)
        {
            bool isCone = i % 2 == 0;
            float deep = random.Of(0.0032f, 0.02f, 0.1f), beside = random.Of(0, 1e-4f, 1e-3f) * random.Of(-1f, 1f);
            Quaternion turn = isCone
                ? new Quaternion(1, 0, 0, 0)
                : Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 4);
            AnyShape body = AnyShape.Of(isCone ? ConvexShape.Cone(0.5f, 0.4f) : ConvexShape.Box(new Vector3(0.5f)));
            RigidPose at = SeamBodies.Placed(body, new Vector3(beside, 0, random.Float(-0.2, 0.2)), turn, -deep);
            var scene = new CollisionScene();
            AddFloor(scene, floor);
            scene.Add(body, at);
            scene.FindContacts(0.005f, _contacts);
            Assert.All(_contacts, one => Assert.True(one.Manifold.Normal.Y > 0.9999f, $"{i}: {one}"));
            float found = -_contacts.Min(one => one.Result.Distance);
            Assert.True(MathF.Abs(found - deep) < 1e-5f, $"{i}: {found} of {deep}");
        }
    }

    [Theory]
    [InlineData("wall under the seam")]
    [InlineData("boxes in each other")]
    [InlineData("solids")]
    [InlineData("flat and solid")]
    public void BuriedSidesDoNotBrake(string floor)
    {
        AnyShape[] bodies =
        [
            AnyShape.Of(ConvexShape.Box(new Vector3(0.3f))), AnyShape.Of(ConvexShape.Cylinder(0.3f, 0.3f)),
            AnyShape.Solid(Solids.Box(new Vector3(-0.3f), new Vector3(0.3f))),
        ];
        for (int i = 0; i < 360; i++)
        {
            AnyShape body = bodies[i % 3];
            float deep = (i / 3 % 4) switch { 0 => -1e-4f, 1 => 1e-6f, 2 => 5e-4f, _ => 2e-3f };
            var random = new Rng((ulong)i);
            float side = floor == "boxes in each other" ? -0.5f : 0;
            float x = side - 0.3f - random.Float(-0.01, 0.0199);
            var scene = new CollisionScene();
            AddFloor(scene, floor);
            scene.Add(body, new RigidPose(new Vector3(x, 0.3f - deep, 0.13f)));
            scene.FindContacts(Reach, _contacts);
            Assert.NotEmpty(_contacts);
            Assert.All(_contacts, one => Assert.True(one.Manifold.Normal.Y > 0.999f, $"{i}: {one}"));
        }
    }

    /// <summary>A body that is wide at its foot meets a wall where that stands on the floor, which goes on
    /// there.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void AWallThatStandsOnAFloorPushes(bool isCompound)
    {
        Vector3[] corners = [.. Enumerable.Range(0, 8).Select(
            i => new Vector3((i & 1) == 0 ? -1 : 1, 0, (i & 2) == 0 ? -1 : 1) * ((i & 4) == 0 ? 0.3f : 0.1f)
                + new Vector3(0, (i & 4) == 0 ? -0.3f : 0.3f, 0))];
        ConvexShape wide = ConvexShape.Mesh(corners), ground = ConvexShape.Box(new Vector3(3, 0.5f, 3));
        ConvexShape wall = ConvexShape.Box(new Vector3(0.5f, 0.5f, 3));
        var low = new RigidPose(new Vector3(0, -0.5f, 0));
        var beside = new RigidPose(new Vector3(0.5f, 0.5f, 0));
        for (int i = 0; i < 30; i++)
        {
            var random = new Rng((ulong)i);
            var scene = new CollisionScene();
            if (isCompound)
            {
                var joined = new CompoundShape([new(ground, low), new(wall, beside)]);
                scene.Add(AnyShape.Of(joined), RigidPose.Identity, Still);
            }
            else
            {
                scene.Add(ground, low, Still);
                scene.Add(wall, beside, Still);
            }

            var at = new Vector3(-0.3f - random.Float(0.001, 0.015), 0.3f - random.Of(0, 1e-4f, 5e-4f), 0.13f);
            scene.Add(wide, new RigidPose(at));
            scene.FindContacts(Reach, _contacts);
            Assert.Contains(_contacts, one => one.Manifold.Normal.Y > 0.999f);
            Assert.True(_contacts.Exists(one => one.Manifold.Normal.X < -0.9f), $"{i}: the wall has no contact");
        }
    }

    private static void AddFloor(CollisionScene scene, string name)
    {
        ConvexShape box = ConvexShape.Box(new Vector3(1.5f, 0.5f, 3));
        AnyShape solid = AnyShape.Solid(Solids.Box(new Vector3(-1.5f, -0.5f, -3), new Vector3(1.5f, 0.5f, 3)));
        var left = new RigidPose(new Vector3(-1.5f, -0.5f, 0));
        var right = new RigidPose(new Vector3(1.5f, -0.5f, 0));
        switch (name)
        {
            case "boxes":
                scene.Add(box, left, Still);
                scene.Add(box, right, Still);
                break;
            case "compound":
                Add(AnyShape.Of(new CompoundShape([new(box, left), new(box, right)])));
                break;
            case "solids":
                scene.Add(solid, left, Still);
                scene.Add(solid, right, Still);
                break;
            case "flat and solid":
                Vector3[] flat = [new(-3, 0, -3), new(0, 0, -3), new(-3, 0, 3), new(0, 0, 3)];
                Add(AnyShape.Surface(new TriangleMesh(flat, [0, 2, 1, 1, 2, 3])));
                scene.Add(solid, right, Still);
                break;
            case "boxes in each other":
                Add(AnyShape.Solid(Solids.Joined(
                    (Solids.Box(new Vector3(-2, -0.5f, -3), new Vector3(2, 0.5f, 3)), new Vector3(-1.5f, -0.5f, 0)),
                    (Solids.Box(new Vector3(-2, -0.5f, -2.5f), new Vector3(2, 0.5f, 2.5f)),
                        new Vector3(1.5f, -0.5f, 0)))));
                break;
            default:
                Vector3[] points = [new(-3, 0, -3), new(0, 0, -3), new(3, 0, -3), new(-3, 0, 3), new(0, 0, 3),
                    new(3, 0, 3),
                    new(0, -1, -3), new(0, -1, 3)];
                Add(AnyShape.Surface(new TriangleMesh(
                    points, [0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5, 1, 4, 6, 4, 7, 6])));
                break;
        }

        void Add(in AnyShape shape) => scene.Add(shape, RigidPose.Identity, Still);
    }
}
