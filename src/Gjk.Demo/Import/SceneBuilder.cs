using System;
using System.Collections.Generic;
using System.Numerics;
using Gjk.Core;
using Gjk.Demo.Import.Meshes;
using Gjk.Demo.Import.Placing;

namespace Gjk.Demo.Import;

/// <summary>
/// Collects the objects and meshes of the scene that is written. Objects that show the same mesh share it. Names are
/// made unique with a number at their end.
/// </summary>
internal sealed class SceneBuilder
{
    /// <summary>Objects. An input of a few lines can name each of its parts many times over.</summary>
    public const int MostObjects = 1_000_000;

    /// <summary>Vertices of all meshes together. As text they take about 400 MB.</summary>
    public const long MostVertices = 10_000_000;

    private readonly HashSet<string> _objectNames = new(StringComparer.Ordinal);
    private readonly Dictionary<string, int> _nextNumbers = new(StringComparer.Ordinal);
    private readonly Dictionary<MeshPart, string> _meshNames = [];
    private readonly Dictionary<string, Vector3[]> _meshes = new(StringComparer.Ordinal);
    private readonly List<ImportedObject> _objects = [];
    private long _vertices;

    public IReadOnlyList<ImportedObject> Objects => _objects;

    /// <summary>The vertices of each mesh, by its name.</summary>
    public IReadOnlyDictionary<string, Vector3[]> Meshes => _meshes;

    /// <summary>Adds an object. Its name is kept if it is the first of that name.</summary>
    /// <exception cref="UnreadableException">A number is too large for a float.</exception>
    public void Add(ImportedObject added)
    {
        if (!added.IsFinite) throw TooLarge();
        if (_objects.Count >= MostObjects) throw new RefusedException($"more than {MostObjects} objects");
        _objects.Add(added with { Name = UniqueName(added.Name, _objectNames) });
    }

    /// <summary>
    /// Adds an object with a mesh. Where the map is a rotation with a scale along the axes, the object keeps both and
    /// shares the mesh. Any other map (a skew, or a scale of 0) is applied to the vertices.
    /// </summary>
    /// <param name="name">The object's name.</param>
    /// <param name="part">The mesh.</param>
    /// <param name="world">From the mesh's frame to the world.</param>
    /// <param name="rotation">The object's rotation.</param>
    /// <exception cref="UnreadableException">A coordinate is too large for a float.</exception>
    public void AddMesh(string name, MeshPart part, in Affine world, in TurnD rotation)
    {
        Affine local = world.SeenFrom(rotation);
        if (Placement.IsAlongAxes(local, out Vector3D factors) && Placement.IsUsableScale(factors))
        {
            if (!IsInRange(part.Vertices, world)) throw TooLarge();
            var placed = new ImportedObject(name, ImportedShape.OfMesh(MeshOf(part)), world, rotation);
            Add(placed with { Scale = (Vector3)factors });
            return;
        }

        // The rotation that is written has been rounded to float, so the vertices are seen from that one.
        local = world.SeenFrom(TurnD.From(rotation.ToFloat()));
        var vertices = new Vector3[part.Vertices.Length];
        for (int i = 0; i < vertices.Length; i++)
        {
            Vector3D vertex = local.Turn(part.Vertices[i]);
            vertices[i] = (Vector3)vertex;
            if (!((Vector3D)vertices[i]).IsFinite) throw TooLarge();
        }

        string mesh = AddVertices($"{part.Name} of {name}", vertices);
        Add(new ImportedObject(name, ImportedShape.OfMesh(mesh), world, rotation));
    }

    private static UnreadableException TooLarge() => new("a size or a position is too large for a float");

    private static bool IsInRange(Vector3[] vertices, in Affine world)
    {
        foreach (Vector3 vertex in vertices)
        {
            if (!((Vector3D)(Vector3)world.Apply(vertex)).IsFinite) return false;
        }

        return true;
    }

    private string MeshOf(MeshPart part)
    {
        if (_meshNames.TryGetValue(part, out string? known)) return known;
        string name = AddVertices(part.Name, part.Vertices);
        _meshNames.Add(part, name);
        return name;
    }

    private string AddVertices(string wanted, Vector3[] vertices)
    {
        _vertices += vertices.Length;
        if (_vertices > MostVertices) throw new RefusedException($"more than {MostVertices} vertices in all meshes");
        string name = wanted;
        for (int i = 2; _meshes.ContainsKey(name); i++) name = $"{wanted} #{i}";
        _meshes.Add(name, vertices);
        return name;
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
