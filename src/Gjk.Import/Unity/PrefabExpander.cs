using System.Collections.Generic;
using System.IO;
using System.Threading;

namespace Gjk.Import;

/// <summary>
/// Lists the objects of a file with those of its prefabs in their place, as Unity does when it opens a scene. A prefab
/// may hold instances of others, and a variant is an instance with changes.
/// </summary>
/// <remarks>
/// An object of an instance needs a number in the file that holds the instance. A stripped document gives it one. Where
/// there is none, Unity takes the exclusive or of the instance's number and the object's, without the sign.
/// </remarks>
internal sealed class PrefabExpander
{
    /// <summary>Elements. A chain of prefabs that each hold the next one twice doubles with every file.</summary>
    private const int MostElements = 2_000_000;

    private readonly UnityProject _project;
    private readonly ImportLog _log;
    private readonly CancellationToken _cancel;
    private readonly Dictionary<UnityFile, List<UnityElement>> _known = [];
    private readonly List<UnityFile> _open = [];

    public PrefabExpander(UnityProject project, ImportLog log, CancellationToken cancel)
    {
        _project = project;
        _log = log;
        _cancel = cancel;
    }

    /// <summary>The objects of a file and its prefabs, in the order of the file.</summary>
    /// <param name="file">A scene or a prefab.</param>
    /// <param name="guid">Of the file; empty for the imported one.</param>
    public List<UnityElement> Expand(UnityFile file, string guid)
    {
        if (_known.TryGetValue(file, out List<UnityElement>? known)) return known;
        _open.Add(file);
        Dictionary<(long Instance, long Source), long> numbers = StrippedNumbers(file);
        var elements = new List<UnityElement>();
        foreach (UnityDocument document in file.Documents)
        {
            if (document.IsStripped || !UnityClass.IsRead(document.ClassId)) continue;
            _cancel.ThrowIfCancellationRequested();
            try
            {
                UnityNode body = document.Body();
                if (document.ClassId != UnityClass.PrefabInstance) elements.Add(UnityElement.Of(document, guid, body));
                else AddInstance(document, body, numbers, elements);
            }
            catch (UnreadableException e)
            {
                _log.CannotRead(document.Where, e.Message);
            }

            if (elements.Count > MostElements)
                throw new ImportException($"{file.Name}: its prefabs have more than {MostElements} objects");
        }

        _open.RemoveAt(_open.Count - 1);
        _known.Add(file, elements);
        return elements;
    }

    /// <summary>The numbers that stripped documents give to objects of instances.</summary>
    private Dictionary<(long Instance, long Source), long> StrippedNumbers(UnityFile file)
    {
        var numbers = new Dictionary<(long, long), long>();
        foreach (UnityDocument document in file.Documents)
        {
            if (!document.IsStripped || !UnityClass.IsRead(document.ClassId)) continue;
            try
            {
                UnityNode body = document.Body();
                UnityReference instance = Either(body, "m_PrefabInstance", "m_PrefabInternal");
                UnityReference source = Either(body, "m_CorrespondingSourceObject", "m_PrefabParentObject");
                numbers[(instance.FileId, source.FileId)] = document.FileId;
            }
            catch (UnreadableException e)
            {
                _log.CannotRead(document.Where, e.Message);
            }
        }

        return numbers;
    }

    /// <summary>A field under the name that it has had since Unity 2018.3, or under its older one.</summary>
    private static UnityReference Either(UnityNode body, string field, string olderField)
    {
        UnityReference reference = body.Reference(field);
        return reference.IsNone ? body.Reference(olderField) : reference;
    }

    private void AddInstance(
        UnityDocument instance, UnityNode body, Dictionary<(long Instance, long Source), long> numbers,
        List<UnityElement> into)
    {
        UnityReference source = Either(body, "m_SourcePrefab", "m_ParentPrefab");

        // Until Unity 2018.2 a prefab file has such a document about itself, which names no other prefab.
        if (source.IsNone) return;
        if (source.IsLocal) throw new UnreadableException("its prefab has no GUID");
        UnityNode changes = body["m_Modification"] ?? UnityNode.OfText("");
        List<UnityElement> elements = [.. Expand(Prefab(source.Guid!), source.Guid!)];
        PrefabOverrides.Apply(instance, changes, elements, _log);
        long parent = changes.Reference("m_TransformParent").FileId;
        long NumberOf(long old) => old == 0 ? 0 : numbers.TryGetValue((instance.FileId, old), out long own)
            ? own
            : (instance.FileId ^ old) & long.MaxValue;
        foreach (UnityElement element in elements)
        {
            into.Add(element with
            {
                Id = NumberOf(element.Id),
                Owner = NumberOf(element.Owner),
                Father = element.Father != 0 ? NumberOf(element.Father) : element.IsTransform ? parent : 0,
            });
        }
    }

    private UnityFile Prefab(string guid)
    {
        string path = _project.PathOf(guid);
        if (Path.GetExtension(path).ToLowerInvariant() is not ".prefab")
            throw new UnreadableException(
                $"{path}: only Unity can make a prefab of a model file; unpack it, or import the model itself");
        UnityFile file = _project.Open(path);
        if (_open.Contains(file)) throw new UnreadableException($"{path}: the prefab holds itself");
        return _open.Count < ImportLimits.PrefabDepth
            ? file
            : throw new UnreadableException($"{path}: more than {ImportLimits.PrefabDepth} prefabs within each other");
    }
}
