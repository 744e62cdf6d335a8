using System.Linq;

namespace Gjk.Import;

/// <summary>Finds the meshes that a scene names: in its own file, in a mesh asset, or in an OBJ file.</summary>
internal sealed class UnityMeshes
{
    private readonly UnityProject _project;
    private readonly ImportLog _log;
    private readonly CancellationToken _cancel;
    private readonly Dictionary<(string Path, long FileId), (ImportedMesh Mesh, string Where)> _known = [];
    private readonly HashSet<(string Path, long FileId)> _warned = [];
    private readonly Dictionary<(string Path, long FileId), string> _faults = [];
    private readonly Dictionary<string, List<ImportedMesh>> _models = new(StringComparer.Ordinal);

    public UnityMeshes(UnityProject project, ImportLog log, CancellationToken cancel)
    {
        _project = project;
        _log = log;
        _cancel = cancel;
    }

    public ImportedMesh Cube { get; } = BuiltInMesh.CubeCorners();

    public ImportedMesh Plane { get; } = BuiltInMesh.PlaneCorners();

    public ImportedMesh Quad { get; } = BuiltInMesh.QuadCorners();

    /// <summary>A mesh that is not built in. It is read once, whether it can be read or not.</summary>
    /// <param name="mesh">Its name in the scene.</param>
    /// <param name="own">The file that it lies in if it has no GUID.</param>
    /// <param name="isHullMeant">True if the object is the hull, so that no warning says that the mesh is not.</param>
    /// <exception cref="UnreadableException">It cannot be read.</exception>
    public ImportedMesh Find(UnityReference mesh, UnityFile own, bool isHullMeant)
    {
        string path = mesh.IsLocal ? own.Name : _project.PathOf(mesh.Guid!);
        if (_faults.TryGetValue((path, mesh.FileId), out string? fault)) throw new UnreadableException(fault);
        try
        {
            ImportedMesh part = Find(path, mesh, own, out string where);
            if (!isHullMeant && _warned.Add((path, mesh.FileId))) _log.WarnOf(where, part, "it");
            return part;
        }
        catch (UnreadableException e)
        {
            _faults.Add((path, mesh.FileId), e.Message);
            throw;
        }
    }

    private ImportedMesh Find(string path, UnityReference mesh, UnityFile own, out string where)
    {
        where = path;
        if (_known.TryGetValue((path, mesh.FileId), out (ImportedMesh Mesh, string Where) known))
        {
            where = known.Where;
            return known.Mesh;
        }

        _cancel.ThrowIfCancellationRequested();
        ImportedMesh part;
        if (mesh.IsLocal || Path.GetExtension(path).ToLowerInvariant() is ".asset" or ".mesh" or ".prefab" or ".unity")
        {
            UnityFile file = mesh.IsLocal ? own : _project.Open(path);
            UnityDocument document = file.Find(mesh.FileId) is { ClassId: UnityClass.Mesh } found
                ? found
                : throw new UnreadableException($"{path}: there is no mesh with the fileID {mesh.FileId} in it");
            part = Read(document);
            where = document.Where;
        }
        else if (Path.GetExtension(path).ToLowerInvariant() is ".obj")
        {
            part = OfModel(path, mesh.FileId);
            where = $"{path}: the part \"{part.Name}\"";
        }
        else
        {
            throw new UnreadableException(
                $"{path}: only Unity can read this model; save its mesh as .obj or as an .asset, or export a .glb");
        }

        _known.Add((path, mesh.FileId), (part, where));
        return part;
    }

    private static ImportedMesh Read(UnityDocument document)
    {
        try
        {
            return MeshAsset.Read(document);
        }
        catch (UnreadableException e)
        {
            throw new UnreadableException($"{document.Where}: {e.Message}");
        }
    }

    /// <summary>A part of an OBJ file. The .meta file says which number a part has. If the file has a single part, it
    /// is that one.</summary>
    private ImportedMesh OfModel(string path, long fileId)
    {
        if (!_models.TryGetValue(path, out List<ImportedMesh>? parts)) _models[path] = parts = Model(path);
        if (parts.Count == 1) return parts[0];
        string? name = NameOf(_project.MetaOf(path), fileId);
        return parts.Find(p => p.Name == name)
            ?? throw new UnreadableException(
                $"{path}: it has {parts.Count} parts, and its .meta file does not say which has the fileID {fileId}");
    }

    /// <summary>Unity's axes are left-handed and those of an OBJ file are not, so its importer mirrors x. It also
    /// scales.</summary>
    private List<ImportedMesh> Model(string path)
    {
        UnityNode meta = _project.MetaOf(path);
        float scale = meta["ModelImporter"]?["meshes"] is { } meshes && meshes["globalScale"] is not null
            ? (float)meshes.Number("globalScale")
            : 1;
        try
        {
            byte[] content = WholeFile.Read(path, ImportLimits.FileBytes, _cancel);
            return [.. ObjReader.Read(path, content, _log, _cancel).Select(part => Mirrored(part, scale))];
        }
        catch (ImportException e)
        {
            throw new UnreadableException(e.Message);
        }
    }

    private static ImportedMesh Mirrored(ImportedMesh part, float scale)
    {
        Vector3[] vertices = [.. part.Vertices.Select(v => new Vector3(-v.X, v.Y, v.Z) * scale)];
        if (Array.Exists(vertices, v => !((Double3)v).IsFinite))
            throw new UnreadableException("its scale in the .meta file makes it too large for a float");
        return ImportedMesh.Weld(part.Name, vertices, part.Triangles);
    }

    private static string? NameOf(UnityNode meta, long fileId)
    {
        UnityNode? importer = meta["ModelImporter"];
        string id = fileId.ToString(CultureInfo.InvariantCulture);
        if (importer?["fileIDToRecycleName"]?[id]?.Text is { } name) return name;
        foreach (UnityNode row in importer?["internalIDToNameTable"]?.Items ?? [])
        {
            string meshClass = UnityClass.Mesh.ToString(CultureInfo.InvariantCulture);
            if (row["first"]?[meshClass]?.Text == id) return row["second"]?.Text;
        }

        return null;
    }
}
