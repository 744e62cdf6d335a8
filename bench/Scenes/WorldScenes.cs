using Gjk.Exact.Scenes;

namespace Gjk.Bench.Scenes;

/// <summary>The demo's room with any number of cubes of size 1, of which about half touch another. If they move, each
/// one moves by one percent of its size per frame and turns by one degree.</summary>
public sealed class WorldScenes
{
    private const double SizesPerFrame = 0.01;

    private readonly MovingObjects _objects;
    private readonly int[] _ids;

    public WorldScenes(int count)
    {
        BuiltInScene scene = BuiltInScenes.Cubes(count);
        Shape = ConvexShape.Mesh(scene.Vertices);
        _objects = new MovingObjects(scene, SizesPerFrame);
        _ids = [.. Enumerable.Range(0, count)];
    }

    /// <summary>The shape of all objects, which is the report's cube of 24 vertices.</summary>
    public ConvexShape Shape { get; }

    /// <summary>The poses of the objects in this frame.</summary>
    public RigidPose[] Poses => _objects.Poses;

    /// <summary>Moves the objects on by one frame.</summary>
    public void Advance() => _objects.Advance();

    /// <summary>Creates a scene of the objects in their current poses. The ids are indices.</summary>
    public CollisionScene CreateScene(BroadPhaseKind kind)
    {
        var scene = new CollisionScene(kind);
        foreach (RigidPose pose in Poses) scene.Add(Shape, pose);
        return scene;
    }

    /// <summary>Gives a scene the current poses of the objects.</summary>
    public void MoveAll(CollisionScene scene, Workers? workers = null) => scene.MoveAll(_ids, Poses, workers);
}
