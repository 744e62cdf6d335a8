namespace Gjk.Import;

/// <summary>Lists the objects of a file with those of its prefabs in their place, as Unity does when it opens a scene.
/// A prefab may hold instances of others, and a variant is an instance with changes.</summary>
/// <remarks>An object of an instance needs a number in the file that holds the instance. A stripped document gives it
/// one. Where there is none, Unity takes the exclusive or of the instance's number and the object's, without the
/// sign.</remarks>
internal sealed class PrefabExpander
{
    /// <summary>Elements. A chain of prefabs that each hold the next one twice doubles with every file.</summary>
    private const int MostElements = 2_000_000;

    private readonly UnityProject _project;
    private readonly CancellationToken _cancel;
    private readonly Dictionary<UnityFile, UnityObjects> _known = [];
    private readonly List<UnityFile> _open = [];

    public PrefabExpander(UnityProject project, CancellationToken cancel)
    {
        _project = project;
        _cancel = cancel;
    }

    /// <summary>The objects of a file and its prefabs, in the order of the file.</summary>
    /// <param name="file">A scene or a prefab.</param>
    /// <param name="guid">Of the file; empty for the imported one.</param>
    public UnityObjects Expand(UnityFile file, string guid)
    {
        if (_known.TryGetValue(file, out UnityObjects? known)) return known;
        _open.Add(file);
        var objects = new UnityObjects();
        List<StrippedObject> stripped = StrippedObjects(file, objects);
        foreach (UnityDocument document in file.Documents)
        {
            if (document.IsStripped || !UnityClass.IsRead(document.ClassId)) continue;
            _cancel.ThrowIfCancellationRequested();
            UnityNode body = UnityNode.OfText("");
            try
            {
                body = document.Body();
                if (document.ClassId != UnityClass.PrefabInstance)
                    objects.Elements.Add(UnityElement.Of(document, guid, body));
                else AddInstance(document, body, stripped, objects);
            }
            catch (UnreadableException e)
            {
                objects.CannotRead(document, e);
                if (document.ClassId != UnityClass.PrefabInstance) continue;
                objects.Lacks ??= Described(body);
                AddStandIns(document.FileId, stripped, [], Described(body), guid, objects.Elements);
            }

            if (objects.Count > MostElements)
                throw new ImportException($"{file.Name}: its prefabs have more than {MostElements} objects");
        }

        _open.RemoveAt(_open.Count - 1);
        _known.Add(file, objects);
        return objects;
    }

    /// <summary>The documents that give numbers to objects of instances.</summary>
    private static List<StrippedObject> StrippedObjects(UnityFile file, UnityObjects objects)
    {
        var stripped = new List<StrippedObject>();
        foreach (UnityDocument document in file.Documents)
        {
            if (!document.IsStripped || !UnityClass.IsRead(document.ClassId)) continue;
            try
            {
                UnityNode body = document.Body();
                UnityReference instance = Either(body, "m_PrefabInstance", "m_PrefabInternal");
                UnityReference source = Either(body, "m_CorrespondingSourceObject", "m_PrefabParentObject");
                stripped.Add(new StrippedObject(document, body, instance.FileId, source.FileId));
            }
            catch (UnreadableException e)
            {
                objects.CannotRead(document, e);
            }
        }

        return stripped;
    }

    /// <summary>Gives the numbers of objects that an unreadable prefab would have brought to stand-ins, which say
    /// so.</summary>
    private static void AddStandIns(
        long instance, List<StrippedObject> stripped, HashSet<long> known, string lacks, string guid,
        List<UnityElement> into)
    {
        foreach (StrippedObject one in stripped)
        {
            bool isOwner = one.Document.ClassId is UnityClass.GameObject or UnityClass.Transform
                or UnityClass.RectTransform;
            if (!isOwner || one.Instance != instance || known.Contains(one.Document.FileId)) continue;
            into.Add(UnityElement.Of(one.Document, guid, one.Body) with { Fault = $"it belongs to {lacks}" });
        }
    }

    /// <summary>A field under the name that it has had since Unity 2018.3, or under its older one.</summary>
    private static UnityReference Either(UnityNode body, string field, string olderField)
    {
        UnityReference reference = body.Reference(field);
        return reference.IsNone ? body.Reference(olderField) : reference;
    }

    private void AddInstance(
        UnityDocument instance, UnityNode body, List<StrippedObject> stripped, UnityObjects into)
    {
        UnityReference source = Either(body, "m_SourcePrefab", "m_ParentPrefab");

        // Until Unity 2018.2 a prefab file has such a document about itself, which names no other prefab.
        if (source.IsNone) return;
        if (source.IsLocal) throw new UnreadableException("its prefab has no GUID");
        UnityNode changes = body["m_Modification"] ?? UnityNode.OfText("");
        UnityObjects prefab = Expand(Prefab(source.Guid!), source.Guid!);
        List<UnityElement> elements = [.. prefab.Elements];
        PrefabOverrides.Apply(instance, changes, elements, prefab.Lacks is null ? into.Problems : null);
        long parent = changes.Reference("m_TransformParent").FileId;
        Dictionary<long, long> numbers = [];
        foreach (StrippedObject one in stripped)
        {
            if (one.Instance == instance.FileId) numbers[one.Source] = one.Document.FileId;
        }

        long NumberOf(long old) => old == 0 ? 0 : numbers.TryGetValue(old, out long own)
            ? own
            : (instance.FileId ^ old) & long.MaxValue;
        var known = new HashSet<long>();
        foreach (UnityElement element in elements)
        {
            long id = NumberOf(element.Id);
            known.Add(id);
            into.Elements.Add(element with
            {
                Id = id,
                Owner = NumberOf(element.Owner),
                Father = element.Father != 0 ? NumberOf(element.Father) : element.IsTransform ? parent : 0,
            });
        }

        into.Problems.AddRange(prefab.Problems);
        if (prefab.Lacks is null) return;
        into.Lacks ??= prefab.Lacks;
        AddStandIns(instance.FileId, stripped, known, prefab.Lacks, "", into.Elements);
    }

    /// <summary>What an instance is one of, in words.</summary>
    private string Described(UnityNode body)
    {
        try
        {
            UnityReference source = Either(body, "m_SourcePrefab", "m_ParentPrefab");
            if (source.IsLocal) return "a prefab that cannot be read";
            string path = _project.PathOf(source.Guid!);
            return IsPrefab(path) ? $"the prefab {path}, which cannot be read" : $"the model {path}";
        }
        catch (UnreadableException)
        {
            return "a prefab that cannot be read";
        }
    }

    private static bool IsPrefab(string path) => Path.GetExtension(path).ToLowerInvariant() is ".prefab";

    private UnityFile Prefab(string guid)
    {
        string path = _project.PathOf(guid);
        if (!IsPrefab(path))
            throw new UnreadableException(
                $"{path}: only Unity can make a prefab of a model file; unpack it, or save the scene as GLB with "
                + "File > Export Scene of the package com.unity.cloud.gltfast");
        UnityFile file = _project.Open(path);
        if (_open.Contains(file)) throw new UnreadableException($"{path}: the prefab holds itself");
        return _open.Count < ImportLimits.PrefabDepth
            ? file
            : throw new UnreadableException($"{path}: more than {ImportLimits.PrefabDepth} prefabs within each other");
    }

    /// <summary>A document that gives a number to an object of an instance.</summary>
    private sealed record StrippedObject(UnityDocument Document, UnityNode Body, long Instance, long Source);
}
