using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Gjk.Core;
using Gjk.Import;

namespace PartClearance;

/// <summary>Reads the parts of an assembly: every object of every file that Gjk.Import knows.</summary>
internal static class PartReader
{
    /// <summary>All parts of a folder, in the order of the files' names.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="isConcave">Whether meshes are what their triangles say, and not their hulls.</param>
    /// <param name="progress">Told how many parts were read.</param>
    /// <param name="cancel">Ends it.</param>
    /// <exception cref="ImportException">A file is not as its format says; the message says where.</exception>
    /// <exception cref="InvalidDataException">There is nothing to read, or not all of it can be.</exception>
    public static List<Part> ReadFolder(
        string folder, bool isConcave, Action<int> progress, CancellationToken cancel)
    {
        if (!Directory.Exists(folder)) throw new InvalidDataException($"{folder}: there is no such folder");
        var parts = new List<Part>();
        foreach (string file in Directory.EnumerateFiles(folder).Where(Importer.CanRead).Order(StringComparer.Ordinal))
        {
            ImportResult read = Importer.Read(file, null, cancel);
            if (read.Problems.FirstOrDefault(p => p.IsMissing) is { } missing)
                throw new InvalidDataException(missing.ToString());
            string name = Path.GetFileName(file);
            foreach (ImportedObject o in read.Objects)
            {
                AnyShape shape = isConcave ? o.ToAnyShape() : AnyShape.Of(o.ToConvexShape());
                parts.Add(new Part(read.Objects.Count == 1 ? name : $"{name}/{o.Name}", shape, o.Pose));
            }

            progress(parts.Count);
        }

        return parts.Count > 0
            ? parts
            : throw new InvalidDataException($"{folder}: it has no {Importer.Endings} file");
    }
}
