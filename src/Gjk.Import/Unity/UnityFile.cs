using System.Linq;
using System.Text;
using YamlDotNet.Core;

namespace Gjk.Import;

/// <summary>A document of a Unity file: one object.</summary>
/// <param name="File">The file.</param>
/// <param name="ClassId">See <see cref="UnityClass"/>.</param>
/// <param name="FileId">The object's number in the file.</param>
/// <param name="IsStripped">True for a stand-in of an object that lies in a prefab.</param>
/// <param name="Line">Of its header, counted from 1.</param>
/// <param name="Start">Where its body begins in the file's text.</param>
/// <param name="Length">Of its body.</param>
internal sealed record UnityDocument(
    UnityFile File, int ClassId, long FileId, bool IsStripped, int Line, int Start, int Length)
{
    /// <summary>The place for a message.</summary>
    public string Where => FormattableString.Invariant(
        $"{File.Name}:{Line}: fileID {FileId} ({UnityClass.NameOf(ClassId)})");

    /// <summary>Reads the body.</summary>
    /// <exception cref="UnreadableException">It is not the YAML of one object.</exception>
    public UnityNode Body()
    {
        UnityNode root;
        try
        {
            root = UnityNode.Parse(new StringReader(File.Text.Substring(Start, Length)));
        }
        catch (YamlException e)
        {
            // The message of the library begins with the place within this document.
            throw new UnreadableException($"not valid YAML at line {Line + e.Start.Line}: {Reason(e)}");
        }

        if (root.Fields.Count != 1) throw new UnreadableException("must be one object with its fields");
        return root.Fields.First().Value;
    }

    private static string Reason(YamlException e)
    {
        int place = e.Message.IndexOf("): ", StringComparison.Ordinal);
        return place < 0 ? e.Message : e.Message[(place + 3)..];
    }
}

/// <summary>A scene, a prefab or an asset as text, cut into its documents. Unity writes "stripped" behind the number of
/// some documents, which is no YAML, so the file is cut before it is parsed.</summary>
internal sealed class UnityFile
{
    private const string Header = "--- ";

    private readonly List<UnityDocument> _documents = [];
    private readonly Dictionary<long, UnityDocument> _byId = [];

    private UnityFile(string name, string text)
    {
        Name = name;
        Text = text;
    }

    /// <summary>For messages.</summary>
    public string Name { get; }

    public string Text { get; }

    /// <summary>In the order of the file.</summary>
    public IReadOnlyList<UnityDocument> Documents => _documents;

    public UnityDocument? Find(long fileId) => _byId.GetValueOrDefault(fileId);

    /// <summary>Reads a file and cuts it.</summary>
    /// <exception cref="ImportException">It cannot be read, or it is not text of Unity.</exception>
    public static UnityFile Load(string name, CancellationToken cancel)
    {
        byte[] bytes = WholeFile.Read(name, ImportLimits.FileBytes, cancel);
        MeshText.CheckEncoding(name, bytes);
        ReadOnlySpan<byte> content = bytes;
        if (content.StartsWith("\uFEFF"u8)) content = content["\uFEFF"u8.Length..];
        if (!content.StartsWith("%YAML"u8))
            throw new ImportException(
                $"{name}: not a file of Unity as text: it must begin with %YAML. In the Editor, set Project Settings > "
                + "Editor > Asset Serialization to Force Text");
        string text = Encoding.UTF8.GetString(content);
        if (text.Contains('\r')) text = text.Replace("\r\n", "\n").Replace('\r', '\n');
        var file = new UnityFile(name, text);
        file.Cut(cancel);
        return file;
    }

    private void Cut(CancellationToken cancel)
    {
        int line = 0, next = 0, headerLine = 0, bodyStart = 0;
        (int ClassId, long FileId, bool IsStripped)? open = null;
        while (next < Text.Length)
        {
            line++;
            int end = Text.IndexOf('\n', next);
            if (end < 0) end = Text.Length;
            ReadOnlySpan<char> content = Text.AsSpan(next, end - next);
            if (content.StartsWith(Header, StringComparison.Ordinal))
            {
                cancel.ThrowIfCancellationRequested();
                Close(open, headerLine, bodyStart, next);
                open = HeaderOf(content, line);
                headerLine = line;
                bodyStart = Math.Min(end + 1, Text.Length);
            }

            next = end + 1;
        }

        Close(open, headerLine, bodyStart, Text.Length);
    }

    private void Close((int ClassId, long FileId, bool IsStripped)? header, int line, int start, int end)
    {
        if (header is not var (classId, fileId, isStripped)) return;
        var document = new UnityDocument(this, classId, fileId, isStripped, line, start, end - start);
        _documents.Add(document);
        if (!_byId.TryAdd(fileId, document))
            throw new ImportException($"{Name}:{line}: fileID {fileId} appears twice, first in line "
                + $"{_byId[fileId].Line}");
    }

    private (int ClassId, long FileId, bool IsStripped) HeaderOf(ReadOnlySpan<char> line, int number)
    {
        string[] words = line.ToString().Split(' ', StringSplitOptions.RemoveEmptyEntries);
        bool isStripped = words.Length == 4 && words[3] == "stripped";
        if ((words.Length == 3 || isStripped)
            && words[1].StartsWith("!u!", StringComparison.Ordinal)
            && int.TryParse(words[1].AsSpan(3), NumberStyles.None, CultureInfo.InvariantCulture, out int classId)
            && words[2].StartsWith('&')
            && long.TryParse(
                words[2].AsSpan(1), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long fileId))
            return (classId, fileId, isStripped);
        throw new ImportException($"{Name}:{number}: not a header of Unity: must be --- !u!CLASS &ID");
    }
}
