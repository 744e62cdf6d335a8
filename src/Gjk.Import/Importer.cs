namespace Gjk.Import;

/// <summary>Reads files of other programs into objects with names, poses and convex shapes. Units and axes stay as they
/// are. Thread-safe. Nothing in a file is trusted: sizes are bounded, and what cannot be read is said.</summary>
public static class Importer
{
    /// <summary>The endings of the files that <see cref="Read"/> takes, in any case.</summary>
    public const string Endings = ".unity, .prefab, .obj, .stl, .ply, .glb or .gltf";

    /// <summary>True if the name of a file ends as those do that <see cref="Read"/> takes.</summary>
    /// <param name="file">A name or a path. The file is not opened.</param>
    public static bool CanRead(string file) =>
        IsUnityFile(file) || Extension(file) is ".obj" or ".stl" or ".ply" or ".glb" or ".gltf";

    /// <summary>Why a file whose name ends otherwise is not taken. Of an FBX the sentence says how to save a GLB
    /// instead.</summary>
    /// <param name="file">A name or a path. The file is not opened.</param>
    public static string Refusal(string file) => Extension(file) == ".fbx"
        ? $"{file}: FBX is not read; save it as GLB: in Blender with File > Export > glTF 2.0, in Unity with "
            + "File > Export Scene > glTF-Binary of the package com.unity.cloud.gltfast"
        : $"{file}: its name must end in {Endings}";

    /// <summary>Reads a file of any of the formats; its ending says which.</summary>
    /// <param name="file">A path. At most 256 MiB.</param>
    /// <param name="project">The Unity project whose prefabs and meshes the file names. Null: the folder above its
    /// Assets folder. Only for files of Unity.</param>
    /// <param name="cancel">Ends the work.</param>
    /// <exception cref="ImportException">The file cannot be used at all.</exception>
    /// <exception cref="System.OperationCanceledException">Cancelled.</exception>
    public static ImportResult Read(string file, string? project = null, CancellationToken cancel = default)
    {
        if (IsUnityFile(file)) return ReadUnity(file, project, cancel);
        if (!CanRead(file)) throw new ImportException(Refusal(file));
        byte[] content = WholeFile.Read(file, ImportLimits.FileBytes, cancel);
        return Extension(file) switch
        {
            ".obj" => ReadObj(file, content, cancel),
            ".stl" => ReadStl(file, content, cancel),
            ".ply" => ReadPly(file, content, cancel),
            string ending => ReadGltf(
                file, content, ending == ".glb", Path.GetDirectoryName(Path.GetFullPath(file)), cancel),
        };
    }

    /// <summary>Reads Wavefront OBJ: an object for each part (o and g), in the file's frame.</summary>
    /// <param name="name">For messages, and for parts without a name.</param>
    /// <param name="content">The bytes of the file.</param>
    /// <param name="cancel">Ends the work.</param>
    /// <exception cref="ImportException">It is not such a file.</exception>
    /// <exception cref="System.OperationCanceledException">Cancelled.</exception>
    public static ImportResult ReadObj(string name, byte[] content, CancellationToken cancel = default) =>
        OfParts(name, content, ObjReader.Read, cancel);

    /// <summary>Reads STL, text or binary: an object for each solid, in the file's frame.</summary>
    /// <inheritdoc cref="ReadObj"/>
    public static ImportResult ReadStl(string name, byte[] content, CancellationToken cancel = default) =>
        OfParts(name, content, StlReader.Read, cancel);

    /// <summary>Reads PLY, text or binary, as one object in the file's frame.</summary>
    /// <inheritdoc cref="ReadObj"/>
    public static ImportResult ReadPly(string name, byte[] content, CancellationToken cancel = default) =>
        OfParts(name, content, PlyReader.Read, cancel);

    /// <summary>Reads binary glTF: an object for each primitive of the default scene's nodes, in its place. A skinned
    /// mesh is taken in its bind pose.</summary>
    /// <inheritdoc cref="ReadObj"/>
    public static ImportResult ReadGlb(string name, byte[] content, CancellationToken cancel = default) =>
        ReadGltf(name, content, isFramed: true, folder: null, cancel);

    /// <summary>Reads a Unity scene or prefab that was saved as text: an object for each enabled collider of an active
    /// GameObject, or for its mesh if it has none. Unity's axes are left-handed, which changes no distance.</summary>
    /// <param name="file">A path.</param>
    /// <param name="project">The project's folder. Null: the folder above the file's Assets folder.</param>
    /// <param name="cancel">Ends the work.</param>
    /// <exception cref="ImportException">It is not such a file.</exception>
    /// <exception cref="System.OperationCanceledException">Cancelled.</exception>
    public static ImportResult ReadUnity(string file, string? project = null, CancellationToken cancel = default)
    {
        var scene = new SceneBuilder();
        var log = new ImportLog();
        UnityImport.Import(file, project, scene, log, cancel);
        return new ImportResult(scene, log);
    }

    /// <summary>True if the name of a file ends as a Unity scene or prefab does.</summary>
    /// <param name="file">A name or a path. The file is not opened.</param>
    public static bool IsUnityFile(string file) => Extension(file) is ".unity" or ".prefab";

    private static string Extension(string file) => Path.GetExtension(file).ToLowerInvariant();

    private static ImportResult ReadGltf(
        string name, byte[] content, bool isFramed, string? folder, CancellationToken cancel)
    {
        using GlbFile file = GlbFile.Open(name, content, isFramed, folder, cancel);
        var scene = new SceneBuilder();
        var log = new ImportLog();
        GlbImport.Import(name, file, scene, log, cancel);
        return new ImportResult(scene, log);
    }

    /// <summary>Adds every part as an object in its file's frame.</summary>
    private static ImportResult OfParts(
        string name, byte[] content,
        Func<string, byte[], ImportLog, CancellationToken, List<ImportedMesh>> read, CancellationToken cancel)
    {
        var scene = new SceneBuilder();
        var log = new ImportLog();
        foreach (ImportedMesh part in read(name, content, log, cancel))
        {
            cancel.ThrowIfCancellationRequested();
            scene.AddMesh(part.Name, part, Affine.Identity, TurnD.Identity);
            log.WarnOf(name, part);
        }

        return new ImportResult(scene, log);
    }
}
