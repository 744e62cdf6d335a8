using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;

namespace Gjk.Unity.Pack;

/// <summary>The GUID of each path of the package. Users' scenes refer to scripts by GUID, so one that was given stays,
/// even when its file is renamed: then edit the path in the list.</summary>
public sealed class GuidList
{
    private readonly SortedDictionary<string, string> _guids = new(StringComparer.Ordinal);

    /// <summary>The GUID of a path.</summary>
    public string this[string path] => _guids[path];

    public IReadOnlyCollection<string> Paths => _guids.Keys;

    /// <summary>Reads a list: a line for each path, the GUID first.</summary>
    public static GuidList Read(string file)
    {
        var list = new GuidList();
        if (!File.Exists(file)) return list;
        foreach (string line in File.ReadAllLines(file))
        {
            int space = line.IndexOf(' ', StringComparison.Ordinal);
            if (space > 0) list._guids.Add(line[(space + 1)..], line[..space]);
        }

        return list;
    }

    /// <summary>What a new path gets: the MD5 of the package's name and the path.</summary>
    public static string Derive(string path)
    {
        byte[] name = Encoding.UTF8.GetBytes(Layout.PackageName + "/" + path);
#pragma warning disable CA5351 // A name, no secret: Unity's GUIDs have the length of an MD5.
        return Convert.ToHexStringLower(MD5.HashData(name));
#pragma warning restore CA5351
    }

    /// <summary>Gives new paths a GUID and forgets those that are gone.</summary>
    public void Update(IReadOnlyCollection<string> paths)
    {
        foreach (string gone in _guids.Keys.Except(paths).ToArray()) _guids.Remove(gone);
        foreach (string path in paths) _guids.TryAdd(path, Derive(path));
    }

    public override string ToString() => string.Concat(_guids.Select(g => $"{g.Value} {g.Key}\n"));
}
