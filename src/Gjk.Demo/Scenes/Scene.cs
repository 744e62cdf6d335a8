namespace Gjk.Demo.Scenes;

/// <summary>The input of the commands: objects in their places, and the pairs to query. Everything in it has been
/// validated.</summary>
internal sealed class Scene
{
    public Scene(string name, SceneObject[] objects, ScenePairs pairs, int frames)
    {
        Name = name;
        Objects = objects;
        Pairs = pairs;
        Frames = frames;
    }

    public string Name { get; }

    public SceneObject[] Objects { get; }

    public ScenePairs Pairs { get; }

    /// <summary>How many frames the motion lasts. The first frame has the poses as given.</summary>
    public int Frames { get; }

    /// <summary>True if an object has a velocity.</summary>
    public bool HasVelocities => Array.Exists(Objects, o => o.Velocity != Vector3.Zero);

    /// <summary>True if an object turns.</summary>
    public bool HasTurns => Array.Exists(Objects, o => o.AngularVelocity != Vector3.Zero);

    /// <summary>True if no object is a surface or a compound.</summary>
    public bool IsConvex => Array.TrueForAll(Objects, o => o.IsConvex);

    /// <summary>This, if all objects are convex, which most commands ask for.</summary>
    /// <param name="name">The user's name for the scene.</param>
    /// <param name="asker">What takes convex shapes only.</param>
    /// <exception cref="RefusedException">An object is a surface or a compound.</exception>
    public Scene Convex(string name, string asker = "this command")
    {
        int other = Array.FindIndex(Objects, o => !o.IsConvex || o.Shape.Kind == ShapeKind.HalfSpace);
        return other < 0
            ? this
            : throw new RefusedException(
                $"{name}: $.objects[{other}].shape: {asker} takes convex shapes that end, not a "
                + (Objects[other].IsConvex ? "half-space, which has no end"
                    : Objects[other].Any.Mesh is null ? "compound" : "surface"));
    }

    public static Scene From(BuiltInScene scene)
    {
        ConvexShape shape = ConvexShape.Mesh(scene.Vertices);
        var objects = new SceneObject[scene.Poses.Count];
        for (int i = 0; i < objects.Length; i++)
            objects[i] = new SceneObject(scene.ObjectNames[i], shape, scene.Poses[i], Vector3.Zero, Vector3.Zero);
        return new Scene(scene.Name, objects, ScenePairs.All(objects.Length), 1);
    }
}

/// <summary>A shape with its scale, its pose and its motion.</summary>
internal sealed class SceneObject
{
    public SceneObject(string? name, in ConvexShape shape, in RigidPose pose, Vector3 velocity, Vector3 angularVelocity)
        : this(name, AnyShape.Of(shape), pose, velocity, angularVelocity)
    {
    }

    public SceneObject(string? name, in AnyShape shape, in RigidPose pose, Vector3 velocity, Vector3 angularVelocity)
    {
        Name = name;
        Any = shape;
        Shape = shape.Convex;
        Pose = pose;
        Velocity = velocity;
        AngularVelocity = angularVelocity;
    }

    public string? Name { get; }

    /// <summary>The shape.</summary>
    public readonly AnyShape Any;

    /// <summary>The shape of a convex object.</summary>
    public readonly ConvexShape Shape;

    public bool IsConvex => Any.Kind == AnyShapeKind.Convex;

    public readonly RigidPose Pose;

    /// <summary>World units per frame.</summary>
    public Vector3 Velocity { get; }

    /// <summary>Radians per frame about the world's axes.</summary>
    public Vector3 AngularVelocity { get; }
}
