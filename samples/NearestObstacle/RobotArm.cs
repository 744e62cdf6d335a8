using System;
using System.Collections.Generic;
using System.Numerics;
using Gjk.Core;

namespace NearestObstacle;

/// <summary>Five links in a row, each turning about the end of the one before. Lengths are in metres.</summary>
internal sealed class RobotArm
{
    /// <summary>A link reaches from its joint up its own y axis to the next joint.</summary>
    /// <param name="Name">What it is called.</param>
    /// <param name="Shape">Its shape, around its middle.</param>
    /// <param name="Length">From joint to joint.</param>
    /// <param name="Axis">What it turns about.</param>
    /// <param name="Swing">How far it turns to either side, in radians.</param>
    private readonly record struct Link(string Name, ConvexShape Shape, float Length, Vector3 Axis, float Swing);

    private static readonly Link[] Parts =
    [
        new("base", ConvexShape.Box(new Vector3(0.2f, 0.15f, 0.2f)), 0.3f, Vector3.UnitY, 3),
        new("upper arm", ConvexShape.Capsule(0.09f, 0.25f), 0.5f, Vector3.UnitZ, 1),
        new("forearm", ConvexShape.Capsule(0.07f, 0.22f), 0.44f, Vector3.UnitZ, 1.5f),
        new("wrist", ConvexShape.Capsule(0.05f, 0.15f), 0.3f, Vector3.UnitX, 1),
        new("hand", ConvexShape.Box(new Vector3(0.08f, 0.06f, 0.03f)), 0.12f, Vector3.UnitX, 0.5f),
    ];

    private readonly CollisionScene _scene;
    private readonly int[] _ids = new int[Parts.Length];

    /// <summary>Adds the links to a scene. Each is in a group of its own, and its mask leaves out the groups of its
    /// neighbours, which it always touches at the joints.</summary>
    public RobotArm(CollisionScene scene)
    {
        _scene = scene;
        for (int i = 0; i < Parts.Length; i++)
        {
            uint neighbours = (i > 0 ? Group(i - 1) : 0) | (i + 1 < Parts.Length ? Group(i + 1) : 0);
            var settings = new ObjectSettings(groups: Group(i), mask: ~neighbours);
            _ids[i] = scene.Add(Parts[i].Shape, RigidPose.Identity, settings);
        }

        MoveTo(0);
    }

    /// <summary>The ids of the links in the scene, from the base to the hand.</summary>
    public IReadOnlyList<int> Links => _ids;

    /// <summary>The name of a link, or the number of an obstacle.</summary>
    public string NameOf(int id)
    {
        int link = Array.IndexOf(_ids, id);
        return link >= 0 ? Parts[link].Name : $"obstacle {id - Parts.Length}";
    }

    /// <summary>Puts all links where they are at a time; the motion repeats after a time of 1.</summary>
    public void MoveTo(float time)
    {
        Vector3 joint = Vector3.Zero;
        Quaternion rotation = Quaternion.Identity;
        for (int i = 0; i < Parts.Length; i++)
        {
            float angle = Parts[i].Swing * MathF.Sin(MathF.Tau * time + i);
            rotation = Quaternion.Normalize(rotation * Quaternion.CreateFromAxisAngle(Parts[i].Axis, angle));
            Vector3 along = Vector3.Transform(Vector3.UnitY * Parts[i].Length, rotation);
            _scene.Move(_ids[i], new RigidPose(rotation, joint + along / 2));
            joint += along;
        }
    }

    /// <summary>Group 0 is the one of objects that were given none, here the obstacles.</summary>
    private static uint Group(int link) => 1u << (link + 1);
}
