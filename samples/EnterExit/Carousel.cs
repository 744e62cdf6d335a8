using System;
using System.Numerics;
using Gjk.Core;

namespace EnterExit;

/// <summary>Three zones that stay, and bodies of four kinds that go round on circles of their own. All are back where
/// they began after a round.</summary>
internal sealed class Carousel
{
    public const int RoundFrames = 240;
    private const int ZoneCount = 3, BodyCount = 16;

    private static readonly (string Name, ConvexShape Shape)[] Kinds =
    [
        ("ball", ConvexShape.Sphere(0.4f)),
        ("pill", ConvexShape.Capsule(0.25f, 0.4f)),
        ("crate", ConvexShape.Box(new Vector3(0.4f, 0.3f, 0.5f))),
        ("spike", ConvexShape.Mesh([new(-1, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(0, -0.5f, -0.5f)])),
    ];

    private readonly CollisionScene _scene;

    /// <summary>Adds the zones, with the ids 0 to 2, and the bodies to an empty scene.</summary>
    public Carousel(CollisionScene scene)
    {
        _scene = scene;
        for (int i = 0; i < ZoneCount; i++)
        {
            var pose = new RigidPose(new Vector3(4 * (i - 1), 0, 0));
            scene.Add(ConvexShape.Box(new Vector3(1, 2, 1)), pose, new ObjectSettings(isStatic: true));
        }

        for (int i = 0; i < BodyCount; i++) scene.Add(Kinds[i % Kinds.Length].Shape, PoseOf(i, 0));
    }

    public static string NameOf(int id) =>
        id < ZoneCount ? $"zone {id}" : $"{Kinds[(id - ZoneCount) % Kinds.Length].Name} {id}";

    /// <summary>Puts all bodies where they are in a frame.</summary>
    public void MoveTo(int frame)
    {
        for (int i = 0; i < BodyCount; i++) _scene.Move(ZoneCount + i, PoseOf(i, frame));
    }

    /// <summary>Circles differ in radius, height, beginning, direction and speed: 1 to 3 turns in a round.</summary>
    private static RigidPose PoseOf(int body, int frame)
    {
        int turns = 1 + body % 3;
        if (body % 2 == 1) turns = -turns;
        float turned = (float)((turns * frame) % RoundFrames) / RoundFrames;
        float angle = MathF.Tau * turned + 2.4f * body;
        float radius = 1.5f + 4.5f * body / BodyCount, height = 0.7f * (body % 5 - 2);
        var position = new Vector3(radius * MathF.Cos(angle), height, radius * MathF.Sin(angle));
        return new RigidPose(Quaternion.CreateFromYawPitchRoll(angle, 0.3f * body, 0), position);
    }
}
