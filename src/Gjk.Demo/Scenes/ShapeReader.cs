using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Demo.Scenes;

/// <summary>
/// Reads the "shape" of an object. Its fields may come in any order, and "type" may be the last one. So all fields are
/// collected first and are matched with the type at the end.
/// </summary>
internal sealed class ShapeReader
{
    private const string Kinds =
        "point, segment, triangle, sphere, capsule, box, cylinder, cone, ellipsoid, mesh, surface or compound";

    private static readonly string[] AllFields =
    [
        "type", "mesh", "radius", "halfHeight", "halfExtents", "radii", "a", "b", "c", "solid", "parts", .. Decorations,
    ];

    private readonly HashSet<string> _seen = [];
    private string _type = "";
    private string _mesh = "";
    private float _radius, _halfHeight;
    private Vector3 _halfExtents, _radii, _a, _b, _c, _position;
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

    /// <summary>The names of the meshes whose hulls the shape needs.</summary>
    public IEnumerable<string> Hulls => _type == "mesh" ? [_mesh] : _parts.SelectMany(part => part.Shape.Hulls);

    /// <summary>Creates a convex shape.</summary>
    /// <param name="json">At the shape.</param>
    /// <param name="meshes">The scene's meshes.</param>
    public ConvexShape Build(in StrictJsonReader json, SceneMeshes meshes) =>
        (_type == "mesh" ? meshes.Hull(json, _mesh) : Primitive())
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
    public static string[]? FieldsOf(string type) => type switch
    {
        "point" => [],
        "segment" => ["a", "b"],
        "triangle" => ["a", "b", "c"],
        "sphere" => ["radius"],
        "capsule" or "cylinder" or "cone" => ["radius", "halfHeight"],
        "box" => ["halfExtents"],
        "ellipsoid" => ["radii"],
        "mesh" or "surface" => ["mesh"],
        "compound" => ["parts"],
        _ => null,
    };

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
            case "halfHeight":
                _halfHeight = json.NonNegative();
                break;
            case "halfExtents":
                _halfExtents = json.Vector(NumberRule.NonNegative);
                break;
            case "radii":
                _radii = json.Vector(NumberRule.NonNegative);
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
            parts[i] = new CompoundPart(_parts[i].Shape.Build(json, meshes), _parts[i].Pose);
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

    private ConvexShape Primitive() => _type switch
    {
        "point" => ConvexShape.Point(),
        "segment" => ConvexShape.Segment(_a, _b),
        "triangle" => ConvexShape.Triangle(_a, _b, _c),
        "sphere" => ConvexShape.Sphere(_radius),
        "capsule" => ConvexShape.Capsule(_radius, _halfHeight),
        "box" => ConvexShape.Box(_halfExtents),
        "cylinder" => ConvexShape.Cylinder(_radius, _halfHeight),
        "cone" => ConvexShape.Cone(_radius, _halfHeight),
        "ellipsoid" => ConvexShape.Ellipsoid(_radii),
        _ => default,
    };
}
