namespace Gjk.Import;

/// <summary>Where an object is.</summary>
/// <param name="World">Unity's localToWorldMatrix.</param>
/// <param name="Rotation">The product of the rotations, without the scales: Unity's transform.rotation. A mirror above
/// an object turns its rotation round.</param>
/// <param name="Signs">The signs of all scales down to this object, along the axes: 1 or -1 each.</param>
/// <param name="IsActive">True if the object and all above it are active.</param>
/// <param name="HasLayout">True if a layout places it or an object above it.</param>
internal readonly record struct UnityPlace(Affine World, TurnD Rotation, Double3 Signs, bool IsActive, bool HasLayout)
{
    public static readonly UnityPlace Root = new(Affine.Identity, TurnD.Identity, new(1, 1, 1), true, false);

    /// <summary>Unity's lossyScale: the scale that is left along the object's own axes.</summary>
    public Double3 LossyScale
    {
        get
        {
            Affine local = World.SeenFrom(Rotation);
            return new Double3(local.X.X, local.Y.Y, local.Z.Z);
        }
    }
}

/// <summary>Works out the places of all objects from the Transforms. Each is worked out once.</summary>
internal sealed class UnityHierarchy
{
    private readonly Dictionary<long, UnityElement> _transforms = [];
    private readonly Dictionary<long, UnityElement> _transformOf = [];
    private readonly Dictionary<long, UnityElement> _objects = [];
    private readonly Dictionary<long, UnityPlace> _places = [];

    public UnityHierarchy(IReadOnlyList<UnityElement> elements)
    {
        foreach (UnityElement element in elements)
        {
            if (element.ClassId == UnityClass.GameObject) _objects.TryAdd(element.Id, element);
            if (!element.IsTransform) continue;
            _transforms.TryAdd(element.Id, element);
            if (element.Fault is null) _transformOf.TryAdd(element.Owner, element);
        }
    }

    /// <summary>A GameObject, or null.</summary>
    public UnityElement? Find(long id) => _objects.GetValueOrDefault(id);

    /// <summary>True if the object itself is not active.</summary>
    public static bool IsInactive(UnityElement gameObject) => gameObject.Body.Whole("m_IsActive", 1) == 0;

    /// <summary>The place of an object.</summary>
    /// <exception cref="UnreadableException">It cannot be worked out.</exception>
    public UnityPlace PlaceOf(UnityElement gameObject)
    {
        if (!_transformOf.TryGetValue(gameObject.Id, out UnityElement? transform))
            throw new UnreadableException("it has no Transform");
        var chain = new Stack<UnityElement>();
        UnityPlace place = UnityPlace.Root;
        while (!_places.TryGetValue(transform.Id, out place))
        {
            chain.Push(transform);
            if (chain.Count > ImportLimits.HierarchyDepth)
                throw new UnreadableException(
                    $"it lies below itself, or below more than {ImportLimits.HierarchyDepth} objects");
            place = UnityPlace.Root;
            if (transform.Father == 0) break;
            long father = transform.Father;
            if (!_transforms.TryGetValue(father, out transform))
                throw new UnreadableException(
                    $"an object above it is missing: there is no Transform {father}", "no object above");
            if (transform.Fault is not null) throw new UnreadableException(transform.Fault);
        }

        while (chain.TryPop(out transform))
        {
            place = Below(place, transform);
            _places[transform.Id] = place;
        }

        return place;
    }

    private UnityPlace Below(in UnityPlace parent, UnityElement transform)
    {
        UnityNode body = transform.Body;
        UnityNode turn = body["m_LocalRotation"] ?? throw new UnreadableException("m_LocalRotation is missing");
        var given = new TurnD(turn.Number("x"), turn.Number("y"), turn.Number("z"), turn.Number("w"));
        TurnD rotation = given.Normalized();
        if (!double.IsFinite(rotation.W)) throw new UnreadableException("m_LocalRotation has no length");
        Double3 scale = body.Vector("m_LocalScale");
        Affine local = Affine.Of(body.Vector("m_LocalPosition"), rotation, scale);
        bool isActive = parent.IsActive && (Find(transform.Owner) is not { } owner || !IsInactive(owner));
        bool hasLayout = parent.HasLayout || transform.ClassId == UnityClass.RectTransform;
        TurnD turned = (parent.Rotation * rotation.Mirrored(parent.Signs)).Normalized();
        Double3 signs = Double3.Multiply(parent.Signs, new(Sign(scale.X), Sign(scale.Y), Sign(scale.Z)));
        return new UnityPlace(parent.World * local, turned, signs, isActive, hasLayout);
    }

    private static double Sign(double factor) => factor < 0 ? -1 : 1;
}
