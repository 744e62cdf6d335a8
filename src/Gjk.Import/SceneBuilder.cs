namespace Gjk.Import;

/// <summary>Collects the objects and meshes of the scene that is written. Objects that show the same mesh share it.
/// Names are made unique with a number at their end.</summary>
internal sealed class SceneBuilder
{
    /// <summary>Objects. An input of a few lines can name each of its parts many times over.</summary>
    public const int MostObjects = 1_000_000;

    /// <summary>Vertices of all meshes together. As text they take about 400 MB.</summary>
    public const long MostVertices = 10_000_000;

    private readonly HashSet<string> _objectNames = new(StringComparer.Ordinal);
    private readonly Dictionary<string, int> _nextNumbers = new(StringComparer.Ordinal);
    private readonly HashSet<string> _meshNames = new(StringComparer.Ordinal);
    private readonly Dictionary<ImportedMesh, ImportedMesh> _meshOf = [];
    private readonly List<ImportedMesh> _meshes = [];
    private readonly List<ImportedObject> _objects = [];
    private long _vertices;

    public IReadOnlyList<ImportedObject> Objects => _objects;

    public IReadOnlyList<ImportedMesh> Meshes => _meshes;

    /// <summary>Adds an object. Its name is kept if it is the first of that name.</summary>
    /// <exception cref="UnreadableException">A number is too large for a float.</exception>
    public void Add(ImportedObject added)
    {
        if (!added.IsFinite) throw TooLarge();
        if (_objects.Count >= MostObjects) throw new ImportException($"more than {MostObjects} objects");
        _objects.Add(added with { Name = UniqueName(added.Name, _objectNames) });
    }

    /// <summary>Adds an object with a mesh. Where the map is a rotation with a scale along the axes, the object keeps
    /// both and shares the mesh. Any other map (a skew, or a scale of 0) is applied to the vertices.</summary>
    /// <param name="name">The object's name.</param>
    /// <param name="part">The mesh.</param>
    /// <param name="world">From the mesh's frame to the world.</param>
    /// <param name="rotation">The object's rotation.</param>
    /// <param name="isHull">True if the object is the hull, whatever the mesh is.</param>
    /// <exception cref="UnreadableException">A coordinate is too large for a float.</exception>
    public void AddMesh(
        string name, ImportedMesh part, in Affine world, in TurnD rotation, bool isHull = false)
    {
        Affine local = world.SeenFrom(rotation);
        if (Placement.IsAlongAxes(local, out Double3 factors) && Placement.IsUsableScale(factors))
        {
            if (!IsInRange(part.Vertices, world)) throw TooLarge();
            var placed = new ImportedObject(name, ImportedShape.OfMesh(MeshOf(part), isHull), world, rotation);
            Add(placed with { Scale = (Vector3)factors });
            return;
        }

        // The rotation that is written has been rounded to float, so the vertices are seen from that one.
        local = world.SeenFrom(TurnD.From(rotation.ToFloat()));
        var vertices = new Vector3[part.Vertices.Count];
        for (int i = 0; i < vertices.Length; i++)
        {
            Double3 vertex = local.Turn(part.Vertices[i]);
            vertices[i] = (Vector3)vertex;
            if (!((Double3)vertices[i]).IsFinite) throw TooLarge();
        }

        ImportedMesh mesh = AddMesh($"{part.Name} of {name}", n => part.With(n, vertices));
        Add(new ImportedObject(name, ImportedShape.OfMesh(mesh, isHull), world, rotation));
    }

    private static UnreadableException TooLarge() => new("a size or a position is too large for a float");

    private static bool IsInRange(IReadOnlyList<Vector3> vertices, in Affine world)
    {
        foreach (Vector3 vertex in vertices)
        {
            if (!((Double3)(Vector3)world.Apply(vertex)).IsFinite) return false;
        }

        return true;
    }

    private ImportedMesh MeshOf(ImportedMesh part)
    {
        if (!_meshOf.TryGetValue(part, out ImportedMesh? known))
            _meshOf.Add(part, known = AddMesh(part.Name, part.Named));
        return known;
    }

    private ImportedMesh AddMesh(string wanted, Func<string, ImportedMesh> make)
    {
        string name = wanted;
        for (int i = 2; !_meshNames.Add(name); i++) name = $"{wanted} #{i}";
        ImportedMesh mesh = make(name);
        _meshes.Add(mesh);
        _vertices += mesh.Vertices.Count;
        return _vertices <= MostVertices
            ? mesh
            : throw new ImportException($"more than {MostVertices} vertices in all meshes");
    }

    private string UniqueName(string wanted, HashSet<string> taken)
    {
        if (taken.Add(wanted)) return wanted;
        int number = _nextNumbers.GetValueOrDefault(wanted, 2);
        while (!taken.Add($"{wanted} #{number}")) number++;
        _nextNumbers[wanted] = number + 1;
        return $"{wanted} #{number}";
    }
}
