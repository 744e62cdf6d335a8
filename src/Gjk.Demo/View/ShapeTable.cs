namespace Gjk.Demo.View;

/// <summary>The distinct shapes of a scene. Each is triangulated once.</summary>
internal sealed class ShapeTable
{
    /// <summary>In a scene of more objects than this, curved shapes get fewer triangles, so that a browser can still
    /// turn the scene smoothly.</summary>
    private const int FineObjects = 500;

    private readonly List<ShapeMesh> _meshes = [];

    public ShapeTable(Scene scene)
    {
        var known = new Dictionary<(ConvexShape Convex, object? Other), int>();
        OfObject = new int[scene.Objects.Length];
        for (int i = 0; i < OfObject.Length; i++)
        {
            AnyShape shape = scene.Objects[i].Any;
            (ConvexShape Convex, object? Other) key = (shape.Convex, (object?)shape.Mesh ?? shape.Compound);
            if (!known.TryGetValue(key, out OfObject[i]))
            {
                known.Add(key, OfObject[i] = _meshes.Count);
                _meshes.Add(ShapeMesh.Of(shape, isCoarse: OfObject.Length > FineObjects));
            }
        }
    }

    public IReadOnlyList<ShapeMesh> Meshes => _meshes;

    /// <summary>The index of each object's mesh.</summary>
    public int[] OfObject { get; }
}
