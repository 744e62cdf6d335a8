namespace Gjk.Import;

/// <summary>
/// An object of a scene after its prefabs were put in: a GameObject, a Transform or something with a shape. An object
/// that came with a prefab has another number in the scene than in its own file.
/// </summary>
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

    public bool IsTransform => ClassId is UnityClass.Transform or UnityClass.RectTransform;

    public static UnityElement Of(UnityDocument document, string guid, UnityNode body) => new(
        document, guid, body, document.FileId, body.Reference("m_GameObject").FileId,
        body.Reference("m_Father").FileId, document.File);
}
