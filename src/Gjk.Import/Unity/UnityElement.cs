namespace Gjk.Import;

/// <summary>An object of a scene after its prefabs were put in: a GameObject, a Transform or something with a shape. An
/// object that came with a prefab has another number in the scene than in its own file.</summary>
/// <param name="Source">Where it is written.</param>
/// <param name="SourceGuid">Of that file; empty for the imported one.</param>
/// <param name="Body">Its fields, with the overrides of the prefabs. Shared until an override changes it.</param>
/// <param name="Id">In the scene.</param>
/// <param name="Owner">The GameObject that has this component.</param>
/// <param name="Father">The Transform above a Transform, or 0.</param>
/// <param name="MeshFile">The file that a mesh without a GUID lies in.</param>
internal sealed record UnityElement(
    UnityDocument Source, string SourceGuid, UnityNode Body, long Id, long Owner, long Father, UnityFile MeshFile)
{
    public int ClassId => Source.ClassId;

    /// <summary>Null, or why this stands for an object of a prefab that cannot be read: a number that others name, and
    /// no more.</summary>
    public string? Fault { get; init; }

    public bool IsTransform => ClassId is UnityClass.Transform or UnityClass.RectTransform;

    public static UnityElement Of(UnityDocument document, string guid, UnityNode body) => new(
        document, guid, body, document.FileId, body.Reference("m_GameObject").FileId,
        body.Reference("m_Father").FileId, document.File);
}

/// <summary>Something in a file that cannot be read, or may surprise.</summary>
/// <param name="Where">File, line and fileID.</param>
/// <param name="What">Why.</param>
/// <param name="Kind">What else counts as the same; null for the same reason.</param>
/// <param name="IsMissing">True if it cannot be read.</param>
internal sealed record UnityProblem(string Where, string What, string? Kind, bool IsMissing);

/// <summary>The objects of a file with those of its prefabs. Shared by all instances of it.</summary>
internal sealed class UnityObjects
{
    public List<UnityElement> Elements { get; } = [];

    /// <summary>What is wrong with them, once for each instance.</summary>
    public List<UnityProblem> Problems { get; } = [];

    /// <summary>Null, or the prefab without which objects are missing that others may name.</summary>
    public string? Lacks { get; set; }

    public void CannotRead(UnityDocument document, UnreadableException e) =>
        Problems.Add(new UnityProblem(document.Where, e.Message, e.Kind, IsMissing: true));

    public int Count => Elements.Count + Problems.Count;
}
