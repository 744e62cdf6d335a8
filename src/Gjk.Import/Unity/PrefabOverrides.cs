namespace Gjk.Import;

/// <summary>What an instance changes about its prefab: values of fields, and components or objects that it
/// removes.</summary>
internal sealed class PrefabOverrides
{
    /// <summary>Fields that only objects have which are read. An override of one that has no target is worth a word.
    /// Other fields may belong to components that do not matter here.</summary>
    private static readonly string[] ReadFields =
        ["m_LocalPosition.", "m_LocalRotation.", "m_LocalScale.", "m_IsActive", "m_Mesh"];

    private const string Values = "m_Modifications", RemovedObjects = "m_RemovedGameObjects",
        RemovedComponents = "m_RemovedComponents";

    private static readonly string[] Lists = [Values, RemovedObjects, RemovedComponents];

    private readonly UnityDocument _instance;
    private readonly UnityNode _changes;
    private readonly List<UnityProblem>? _problems;
    private readonly Dictionary<long, int> _byId = [];
    private readonly Dictionary<(string, long), int> _bySource = [];
    private readonly HashSet<int> _changed = [];

    private PrefabOverrides(UnityDocument instance, UnityNode changes, List<UnityProblem>? problems)
    {
        _instance = instance;
        _changes = changes;
        _problems = problems;
    }

    /// <summary>Changes the elements of a prefab in place. Overrides without a target are problems; of a prefab that
    /// lacks objects anyway there is no list for them.</summary>
    public static void Apply(
        UnityDocument instance, UnityNode changes, List<UnityElement> elements, List<UnityProblem>? problems)
    {
        bool isPlain = !Array.Exists(Lists, l => changes[l]?.Items.Count > 0);
        if (isPlain) return;
        var overrides = new PrefabOverrides(instance, changes, problems);
        for (int i = 0; i < elements.Count; i++)
        {
            overrides._byId.TryAdd(elements[i].Id, i);
            overrides._bySource.TryAdd((elements[i].SourceGuid, elements[i].Source.FileId), i);
        }

        foreach (UnityNode change in changes[Values]?.Items ?? []) overrides.Change(change, elements);
        overrides.Remove(elements);
    }

    private void Change(UnityNode change, List<UnityElement> elements)
    {
        string path = change["propertyPath"]?.Text ?? "";
        UnityReference target = change.Reference("target");
        if (IndexOf(target) is not { } index)
        {
            if (!Array.Exists(ReadFields, f => path.StartsWith(f, StringComparison.Ordinal))) return;
            string id = target.FileId.ToString(CultureInfo.InvariantCulture);
            string what = $"its override of {path} is ignored: the prefab has no fileID {id}";
            _problems?.Add(new UnityProblem(_instance.Where, what, "override", IsMissing: false));
            return;
        }

        UnityElement element = elements[index];
        if (_changed.Add(index)) element = element with { Body = element.Body.Copy() };
        UnityNode value = UnityNode.OfText(change["value"]?.Text ?? "");
        if (path == "m_Mesh" && change["objectReference"] is { } mesh)
        {
            value = mesh;
            if (change.Reference("objectReference").IsLocal) element = element with { MeshFile = _instance.File };
        }

        element.Body.Set(path, value);
        elements[index] = element;
    }

    /// <summary>Unity names an object by its number in the prefab. Some versions name the file that it was first
    /// written in.</summary>
    private int? IndexOf(UnityReference target)
    {
        if (_byId.TryGetValue(target.FileId, out int index)) return index;
        return _bySource.TryGetValue((target.Guid ?? "", target.FileId), out index) ? index : null;
    }

    private void Remove(List<UnityElement> elements)
    {
        // An inactive object is not in the scene either, and takes everything below it with it.
        foreach (UnityReference removed in References(RemovedObjects))
        {
            if (IndexOf(removed) is not { } index) continue;
            UnityNode body = elements[index].Body.Copy();
            body.Set("m_IsActive", UnityNode.OfText("0"));
            elements[index] = elements[index] with { Body = body };
        }

        var gone = new HashSet<int>();
        foreach (UnityReference removed in References(RemovedComponents))
        {
            if (IndexOf(removed) is { } index) gone.Add(index);
        }

        if (gone.Count == 0) return;
        var kept = new List<UnityElement>();
        for (int i = 0; i < elements.Count; i++)
        {
            if (!gone.Contains(i)) kept.Add(elements[i]);
        }

        elements.Clear();
        elements.AddRange(kept);
    }

    private IEnumerable<UnityReference> References(string field)
    {
        foreach (UnityNode item in _changes[field]?.Items ?? [])
            yield return new UnityReference(item.Whole("fileID", 0), item["guid"]?.Text ?? "");
    }
}
