using System;
using System.Collections.Generic;
using System.IO;
using System.Numerics;
using System.Threading;
using Gjk.Demo.Import.Placing;
using Gjk.Demo.Output;

namespace Gjk.Demo.Import.Meshes;

/// <summary>Imports a mesh file: each of its parts becomes an object.</summary>
internal static class MeshFile
{
    /// <summary>The endings of the formats that consist of parts without places of their own.</summary>
    public static bool IsPartsFile(string file) => Extension(file) is ".obj" or ".stl" or ".ply";

    public static bool IsGlb(string file) => Extension(file) == ".glb";

    public static string Extension(string file) => Path.GetExtension(file).ToLowerInvariant();

    /// <summary>Reads the parts of an OBJ, STL or PLY file.</summary>
    /// <exception cref="RefusedException">The file cannot be read, or it is not such a file.</exception>
    public static List<MeshPart> Parts(string file, CancellationToken cancel)
    {
        byte[] bytes = InputFile.Read(file, ImportLimits.FileBytes, cancel);
        return Extension(file) switch
        {
            ".obj" => ObjReader.Read(file, bytes, cancel),
            ".stl" => StlReader.Read(file, bytes, cancel),
            _ => PlyReader.Read(file, bytes, cancel),
        };
    }

    /// <summary>Adds every part as an object in its file's frame.</summary>
    public static void Import(string file, SceneBuilder scene, ImportLog log, CancellationToken cancel)
    {
        foreach (MeshPart part in Parts(file, cancel))
        {
            cancel.ThrowIfCancellationRequested();
            scene.AddMesh(part.Name, part, Affine.Identity, TurnD.Identity);
            if (Convexity.Warning(part) is { } warning) log.Warn(file, $"{Named(part)} {warning}");
        }
    }

    /// <summary>As it is called in a warning.</summary>
    public static string Named(MeshPart part) => $"the part \"{part.Name}\"";

    /// <exception cref="RefusedException">A coordinate is not finite.</exception>
    public static Vector3 Checked(Vector3 vertex, Func<RefusedException> refuse) =>
        float.IsFinite(vertex.X) && float.IsFinite(vertex.Y) && float.IsFinite(vertex.Z) ? vertex : throw refuse();
}
