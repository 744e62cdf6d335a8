namespace Gjk.Demo.Scenes;

/// <summary>Reads the "shape" of an object. Its fields may come in any order, and "type" may be the last one. So all
/// fields are collected first and are matched with the type at the end.</summary>
internal sealed class ShapeReader
{
    /// <summary>The fields that a type needs besides "type", and what makes a primitive of them.</summary>
    private static readonly Dictionary<string, (string[] Fields, Func<ShapeReader, ConvexShape> Make)> Types = new()
    {
        ["point"] = ([], _ => ConvexShape.Point()),
        ["segment"] = (["a", "b"], s => ConvexShape.Segment(s._a, s._b)),
        ["triangle"] = (["a", "b", "c"], s => ConvexShape.Triangle(s._a, s._b, s._c)),
        ["sphere"] = (["radius"], s => ConvexShape.Sphere(s._radius)),
        ["capsule"] = (["radius", "halfHeight"], s => ConvexShape.Capsule(s._radius, s._halfHeight)),
        ["box"] = (["halfExtents"], s => ConvexShape.Box(s._halfExtents)),
        ["cylinder"] = (["radius", "halfHeight"], s => ConvexShape.Cylinder(s._radius, s._halfHeight)),
        ["cone"] = (["radius", "halfHeight"], s => ConvexShape.Cone(s._radius, s._halfHeight)),
        ["ellipsoid"] = (["radii"], s => ConvexShape.Ellipsoid(s._radii)),
        ["taperedCapsule"] = (
            ["topRadius", "bottomRadius", "halfHeight"],
            s => ConvexShape.TaperedCapsule(s._topRadius, s._bottomRadius, s._halfHeight)),
        ["halfspace"] = (["normal", "offset"], s => ConvexShape.HalfSpace(s._normal, s._offset)),
        ["mesh"] = (["mesh"], _ => default),
        ["surface"] = (["mesh"], _ => default),
        ["compound"] = (["parts"], _ => default),
    };

    private static readonly string Kinds = string.Join(", ", Types.Keys.SkipLast(1)) + " or " + Types.Keys.Last();

    private static readonly string[] AllFields =
        ["type", "solid", .. Types.Values.SelectMany(type => type.Fields), .. Decorations];

    private readonly HashSet<string> _seen = [];
    private string _type = "";
    private string _mesh = "";
    private float _radius, _topRadius, _bottomRadius, _halfHeight, _offset;
    private Vector3 _halfExtents, _radii, _a, _b, _c, _normal, _position;
    private float _rounding;
    private bool _isSolid;
    private List<PartReader> _parts = [];
    private Quaternion _rotation = Quaternion.Identity;

    private ShapeReader(ref StrictJsonReader json)
    {
        json.BeginObject("an object with a \"type\"");
        while (json.NextField(_seen, out string field))
        {
            if (Array.IndexOf(AllFields, field) < 0) throw json.Refuse("unknown field");
            json.Value();
            Read(ref json, field);
            json.EndField();
        }

        CheckFields(json);
    }

    /// <summary>The optional fields that every convex type may have.</summary>
    public static string[] Decorations => ["rounding", "position", "rotation"];

    /// <summary>Reads a shape.</summary>
    /// <param name="json">The reader, positioned on the shape.</param>
    /// <returns>The fields of the shape. Its mesh is not resolved yet, because "meshes" may come later in the
    /// file.</returns>
    public static ShapeReader Read(ref StrictJsonReader json) => new(ref json);

    /// <summary>Whether the shape is neither a surface nor a compound.</summary>
    public bool IsConvex => _type is not ("surface" or "compound");

    /// <summary>Whether the inside of a surface counts, too.</summary>
    public bool IsSolid => _isSolid;

    /// <summary>Whether the shape has no end.</summary>
    public bool IsEndless => _type == "halfspace";

    /// <summary>The names of the meshes whose hulls the shape needs.</summary>
    public IEnumerable<string> Hulls => _type == "mesh" ? [_mesh] : _parts.SelectMany(part => part.Shape.Hulls);

    /// <summary>Creates a convex shape.</summary>
    /// <param name="json">At the shape.</param>
    /// <param name="meshes">The scene's meshes.</param>
    public ConvexShape Build(in StrictJsonReader json, SceneMeshes meshes) =>
        (_type == "mesh" ? meshes.Hull(json, _mesh) : Types[_type].Make(this))
            .Rounded(_rounding).Placed(new RigidPose(_rotation, _position));

    /// <summary>Creates a surface or a compound, scaled.</summary>
    /// <inheritdoc cref="Build"/>
    public AnyShape BuildConcave(in StrictJsonReader json, SceneMeshes meshes, Vector3 scale)
    {
        if (_type == "compound")
        {
            var compound = new CompoundShape(BuildParts(json, meshes));
            return AnyShape.Of(scale == Vector3.One ? compound : compound.Scaled(scale));
        }

        TriangleMesh mesh = meshes.Surface(json, _mesh);
        if (_isSolid && mesh.WhyNoInside is { } reason)
        {
            json.Path.Enter("solid");
            throw json.Refuse($"the mesh \"{_mesh}\" has no inside: {reason}");
        }

        if (scale != Vector3.One) mesh = mesh.Scaled(scale);
        return _isSolid ? AnyShape.Solid(mesh) : AnyShape.Surface(mesh);
    }

    /// <summary>The fields that a type needs besides "type", or null if there is no such type.</summary>
    public static string[]? FieldsOf(string type) => Types.TryGetValue(type, out var known) ? known.Fields : null;

    /// <summary>The fields that a type may have besides.</summary>
    public static string[] OptionalOf(string type) => type switch
    {
        "surface" => ["solid"],
        "compound" => [],
        _ => Decorations,
    };

    private void Read(ref StrictJsonReader json, string field)
    {
        switch (field)
        {
            case "type":
                _type = json.String(Kinds);
                if (FieldsOf(_type) is null) throw json.Refuse($"unknown type \"{_type}\"; must be {Kinds}");
                break;
            case "mesh":
                _mesh = json.String("the name of a mesh");
                break;
            case "radius":
                _radius = json.NonNegative();
                break;
            case "topRadius":
                _topRadius = json.NonNegative();
                break;
            case "bottomRadius":
                _bottomRadius = json.NonNegative();
                break;
            case "halfHeight":
                _halfHeight = json.NonNegative();
                break;
            case "halfExtents":
                _halfExtents = json.Vector(NumberRule.NonNegative);
                break;
            case "radii":
                _radii = json.Vector(NumberRule.NonNegative);
                break;
            case "normal":
                _normal = json.Vector();
                if (_normal == Vector3.Zero) throw json.Refuse("must not be [0, 0, 0]");
                break;
            case "offset":
                _offset = json.Float();
                break;
            case "solid":
                _isSolid = json.Bool();
                break;
            case "parts":
                _parts = PartReader.ReadAll(ref json);
                break;
            case "rounding":
                _rounding = json.NonNegative();
                break;
            case "position":
                _position = json.Vector();
                break;
            case "rotation":
                _rotation = ObjectDraft.Rotation(ref json);
                break;
            case "a":
                _a = json.Vector();
                break;
            case "b":
                _b = json.Vector();
                break;
            case "c":
                _c = json.Vector();
                break;
        }
    }

    private void CheckFields(in StrictJsonReader json)
    {
        if (!_seen.Contains("type")) throw Missing(json, "type");
        string[] wanted = FieldsOf(_type)!;
        foreach (string field in wanted)
        {
            if (!_seen.Contains(field)) throw Missing(json, field);
        }

        string[] known = ["type", .. wanted, .. OptionalOf(_type)];
        foreach (string field in _seen)
        {
            if (Array.IndexOf(known, field) >= 0) continue;
            json.Path.Enter(field);
            throw json.Refuse($"unknown field for the type \"{_type}\"");
        }
    }

    private CompoundPart[] BuildParts(in StrictJsonReader json, SceneMeshes meshes)
    {
        var parts = new CompoundPart[_parts.Count];
        json.Path.Enter("parts");
        for (int i = 0; i < parts.Length; i++)
        {
            json.Path.Enter(i);
            json.Path.Enter("shape");
            ShapeReader shape = _parts[i].Shape;
            parts[i] = new CompoundPart(
                shape.IsConvex ? AnyShape.Of(shape.Build(json, meshes)) : shape.BuildConcave(json, meshes, Vector3.One),
                _parts[i].Pose);
            json.Path.Leave();
            json.Path.Leave();
        }

        json.Path.Leave();
        return parts;
    }

    private static RefusedException Missing(in StrictJsonReader json, string field)
    {
        json.Path.Enter(field);
        return json.Refuse("missing");
    }
}
