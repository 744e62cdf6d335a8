namespace Gjk.Import;

/// <summary>Imports a scene or a prefab. An object's shapes are its colliders. An object without any is its
/// MeshFilter's mesh, as one with a collider that is a script. What is inactive is not in the scene.</summary>
internal sealed class UnityImport
{
    private readonly ImportLog _log;
    private readonly UnityShapes _shapes;
    private readonly UnityHierarchy _hierarchy;
    private readonly CancellationToken _cancel;

    private UnityImport(ImportLog log, UnityShapes shapes, UnityHierarchy hierarchy, CancellationToken cancel)
    {
        _log = log;
        _shapes = shapes;
        _hierarchy = hierarchy;
        _cancel = cancel;
    }

    /// <param name="file">A scene or a prefab.</param>
    /// <param name="folder">The project's folder, or null to look for it above the file.</param>
    /// <param name="scene">Is given the objects.</param>
    /// <param name="log">Is told what cannot be read.</param>
    /// <param name="cancel">Ends the work.</param>
    /// <exception cref="ImportException">The file is not one of Unity's.</exception>
    public static void Import(
        string file, string? folder, SceneBuilder scene, ImportLog log, CancellationToken cancel)
    {
        var project = new UnityProject(folder, file, log, cancel);
        UnityObjects objects = new PrefabExpander(project, cancel).Expand(UnityFile.Load(file, cancel), "");
        foreach (UnityProblem problem in objects.Problems) log.Add(problem);
        var shapes = new UnityShapes(scene, new UnityMeshes(project, log, cancel));
        var import = new UnityImport(log, shapes, new UnityHierarchy(objects.Elements), cancel);
        import.AddObjects(objects.Elements);
    }

    private void AddObjects(List<UnityElement> elements)
    {
        var components = new Dictionary<long, List<UnityElement>>();
        foreach (UnityElement element in elements)
        {
            if (!UnityClass.IsShape(element.ClassId)) continue;
            if (_hierarchy.Find(element.Owner) is not { Fault: null })
            {
                string owner = element.Owner.ToString(CultureInfo.InvariantCulture);
                string? fault = _hierarchy.Find(element.Owner)?.Fault;
                string reason = fault ?? $"its GameObject {owner} is not in the file";
                _log.CannotRead(element.Source.Where, reason, fault ?? "no owner");
                continue;
            }

            if (!components.TryGetValue(element.Owner, out List<UnityElement>? own))
                components[element.Owner] = own = [];
            own.Add(element);
        }

        foreach (UnityElement element in elements)
        {
            if (element.ClassId != UnityClass.GameObject) continue;
            _cancel.ThrowIfCancellationRequested();

            // Two objects may have one number if a file was merged by hand; the second one has nothing of its own.
            if (components.Remove(element.Id, out List<UnityElement>? own)) AddObject(element, own);
        }
    }

    private void AddObject(UnityElement gameObject, List<UnityElement> components)
    {
        UnityPlace place;
        try
        {
            if (UnityHierarchy.IsInactive(gameObject)) return;
            place = _hierarchy.PlaceOf(gameObject);
            if (!place.IsActive) return;
            if (place.HasLayout)
                throw new UnreadableException("a RectTransform places it, whose layout only Unity knows");
        }
        catch (UnreadableException e)
        {
            foreach (UnityElement component in components) CannotRead(component, NameOf(gameObject), e.Message, e.Kind);
            return;
        }

        List<UnityElement> shapes = Shapes(components, NameOf(gameObject));
        foreach (UnityElement shape in shapes)
        {
            try
            {
                string kind = shapes.Count > 1 ? $" ({UnityClass.NameOf(shape.ClassId)})" : "";
                _shapes.Add(NameOf(gameObject) + kind, shape, place);
            }
            catch (UnreadableException e)
            {
                CannotRead(shape, NameOf(gameObject), e.Message, e.Kind);
            }
        }
    }

    /// <summary>The enabled colliders, else the mesh. Lists what is a shape and is not read.</summary>
    private List<UnityElement> Shapes(List<UnityElement> components, string name)
    {
        var colliders = new List<UnityElement>();
        var meshes = new List<UnityElement>();
        bool hasUnread = false;
        foreach (UnityElement component in components)
        {
            if (component.ClassId == UnityClass.MeshFilter || component.ClassId == UnityClass.SkinnedMeshRenderer)
            {
                meshes.Add(component);
                continue;
            }

            if (component.Body["m_Enabled"]?.Text == "0") continue;
            if (UnityClass.UnreadShape(component.ClassId) is not { } reason)
            {
                colliders.Add(component);
                continue;
            }

            hasUnread = true;
            CannotRead(component, name, reason);
        }

        if (colliders.Count > 0 || hasUnread) return colliders;
        foreach (UnityElement mesh in meshes)
        {
            if (UnityClass.UnreadShape(mesh.ClassId) is { } reason) CannotRead(mesh, name, reason);
        }

        meshes.RemoveAll(m => UnityClass.UnreadShape(m.ClassId) is not null);
        return meshes;
    }

    private void CannotRead(UnityElement component, string name, string reason, string? kind = null) =>
        _log.CannotRead($"{component.Source.Where} of \"{name}\"", reason, kind);

    private static string NameOf(UnityElement gameObject) =>
        gameObject.Body["m_Name"]?.Text is { Length: > 0 } name
            ? name
            : "GameObject " + gameObject.Id.ToString(CultureInfo.InvariantCulture);
}
