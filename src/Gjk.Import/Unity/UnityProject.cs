using System.Linq;
using YamlDotNet.Core;

namespace Gjk.Import;

/// <summary>A Unity project's folder. Beside every asset lies a .meta file with the GUID by which other files name
/// it.</summary>
internal sealed class UnityProject
{
    /// <summary>The folders of a project that hold assets. Anything else is made by the Editor.</summary>
    private static readonly string[] AssetFolders = ["Assets", "Packages", Path.Combine("Library", "PackageCache")];

    private const int MetaBytes = 1 << 26;

    private readonly string? _folder;
    private readonly ImportLog _log;
    private readonly CancellationToken _cancel;
    private readonly Dictionary<string, UnityFile> _files = new(StringComparer.Ordinal);
    private Dictionary<string, string>? _assets;

    /// <param name="folder">The folder, or null to look for it above the imported file.</param>
    /// <param name="file">The imported file.</param>
    /// <param name="log">Is told of GUIDs that two assets share.</param>
    /// <param name="cancel">Ends the search.</param>
    /// <exception cref="ImportException">There is no such folder.</exception>
    public UnityProject(string? folder, string file, ImportLog log, CancellationToken cancel)
    {
        if (folder is not null && !Directory.Exists(folder))
            throw new ImportException($"{folder}: --project: there is no such directory");
        _folder = folder ?? FolderAbove(file);
        _log = log;
        _cancel = cancel;
    }

    /// <summary>The asset with a GUID.</summary>
    /// <exception cref="UnreadableException">There is none.</exception>
    public string PathOf(string guid)
    {
        if (_folder is null)
            throw new UnreadableException($"the asset with the GUID {guid} is needed: name its project with --project");
        _assets ??= FindAssets(_folder);
        return _assets.GetValueOrDefault(guid)
            ?? throw new UnreadableException($"there is no asset with the GUID {guid} in {_folder}");
    }

    /// <summary>A file of Unity. It is read and cut once.</summary>
    /// <exception cref="UnreadableException">It cannot be read.</exception>
    public UnityFile Open(string path)
    {
        if (_files.TryGetValue(path, out UnityFile? known)) return known;
        try
        {
            return _files[path] = UnityFile.Load(path, _cancel);
        }
        catch (ImportException e)
        {
            throw new UnreadableException(e.Message);
        }
    }

    /// <summary>The .meta file of an asset.</summary>
    /// <exception cref="UnreadableException">It cannot be read.</exception>
    public UnityNode MetaOf(string asset)
    {
        try
        {
            byte[] bytes = WholeFile.Read(asset + ".meta", MetaBytes, _cancel);
            return UnityNode.Parse(new StreamReader(new MemoryStream(bytes)));
        }
        catch (Exception e) when (e is YamlException or UnreadableException or ImportException)
        {
            throw new UnreadableException(e is ImportException ? e.Message : $"{asset}.meta: not valid YAML");
        }
    }

    /// <summary>The folder that holds the Assets folder in which the file lies.</summary>
    private static string? FolderAbove(string file)
    {
        string? folder = Path.GetDirectoryName(Path.GetFullPath(file));
        while (folder is not null && Path.GetFileName(folder) != "Assets") folder = Path.GetDirectoryName(folder);
        return folder is null ? null : Path.GetDirectoryName(folder);
    }

    private Dictionary<string, string> FindAssets(string folder)
    {
        var found = new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase);
        var options = new EnumerationOptions
        {
            RecurseSubdirectories = true,
            IgnoreInaccessible = true,
            AttributesToSkip = FileAttributes.ReparsePoint,
        };
        string[] folders = [.. AssetFolders.Select(f => Path.Combine(folder, f)).Where(Directory.Exists)];

        // A folder without Assets may be one of a project's own folders.
        foreach (string root in folders.Length > 0 ? folders : [folder])
        {
            IEnumerable<string> metas = Directory.EnumerateFiles(root, "*.meta", options);
            foreach (string meta in metas.OrderBy(m => m, StringComparer.Ordinal))
            {
                _cancel.ThrowIfCancellationRequested();
                string asset = meta[..^".meta".Length];
                if (GuidIn(meta) is not { } guid || found.TryAdd(guid, asset)) continue;
                _log.Warn(asset, $"its GUID {guid} is also that of {found[guid]}, which is used");
            }
        }

        return found;
    }

    /// <summary>Only the line is read, since a project may have 100,000 of these files.</summary>
    private static string? GuidIn(string meta)
    {
        const string field = "guid:";
        try
        {
            string? line = File.ReadLines(meta).FirstOrDefault(l => l.StartsWith(field, StringComparison.Ordinal));
            return line?[field.Length..].Trim();
        }
        catch (Exception e) when (ImportException.IsFileTrouble(e))
        {
            return null;
        }
    }
}
