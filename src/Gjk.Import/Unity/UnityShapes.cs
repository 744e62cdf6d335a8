namespace Gjk.Import;

/// <summary>Makes shapes of colliders and meshes as Unity's physics does. Boxes, spheres and capsules follow the scale
/// along their own axes only. Meshes follow the whole matrix, skew included.</summary>
internal sealed class UnityShapes
{
    private readonly SceneBuilder _scene;
    private readonly UnityMeshes _meshes;

    public UnityShapes(SceneBuilder scene, UnityMeshes meshes)
    {
        _scene = scene;
        _meshes = meshes;
    }

    /// <summary>Adds the shape of a component.</summary>
    /// <param name="name">The object's name.</param>
    /// <param name="component">The component.</param>
    /// <param name="place">Where its GameObject is.</param>
    /// <exception cref="UnreadableException">It cannot be read.</exception>
    public void Add(string name, UnityElement component, in UnityPlace place)
    {
        UnityNode body = component.Body;
        switch (component.ClassId)
        {
            case UnityClass.BoxCollider:
                Double3 size = Placement.Absolute(Double3.Multiply(body.Vector("m_Size"), place.LossyScale));
                Add(name, ImportedShape.Box((Vector3)(size * 0.5)), place, body.Vector("m_Center"), place.Rotation);
                break;
            case UnityClass.SphereCollider:
                Double3 scale = Placement.Absolute(place.LossyScale);
                double radius = Radius(body) * Math.Max(scale.X, Math.Max(scale.Y, scale.Z));
                Add(name, ImportedShape.Sphere(radius), place, body.Vector("m_Center"), place.Rotation);
                break;
            case UnityClass.CapsuleCollider:
                AddCapsule(name, body, place);
                break;
            case UnityClass.CharacterController:
                AddUpright(name, body, place);
                break;
            default:
                AddMesh(name, component, place);
                break;
        }
    }

    private static double Radius(UnityNode body) => Math.Abs(body.Number("m_Radius"));

    /// <summary>A capsule that is lower than it is wide is a ball.</summary>
    private void AddCapsule(string name, UnityNode body, in UnityPlace place)
    {
        Double3 scale = Placement.Absolute(place.LossyScale);
        (double along, double across, TurnD turn) = body.Whole("m_Direction", 1) switch
        {
            0 => (scale.X, Math.Max(scale.Y, scale.Z), TurnD.YToX),
            1 => (scale.Y, Math.Max(scale.X, scale.Z), TurnD.Identity),
            2 => (scale.Z, Math.Max(scale.X, scale.Y), TurnD.YToZ),
            long other => throw new UnreadableException($"m_Direction {other} is not an axis; must be 0, 1 or 2"),
        };
        double radius = Radius(body) * across;
        double halfHeight = Math.Abs(body.Number("m_Height")) * along / 2 - radius;
        ImportedShape shape = halfHeight > 0 ? ImportedShape.Capsule(radius, halfHeight) : ImportedShape.Sphere(radius);
        Add(name, shape, place, body.Vector("m_Center"), place.Rotation * turn);
    }

    /// <summary>A character's capsule stands along the world's y however its object is turned. Its skin is no part of
    /// it.</summary>
    private void AddUpright(string name, UnityNode body, in UnityPlace place)
    {
        Double3 scale = Placement.Absolute(place.LossyScale);
        double radius = Radius(body) * Math.Max(scale.X, scale.Z);
        double halfHeight = Math.Abs(body.Number("m_Height")) * scale.Y / 2 - radius;
        ImportedShape shape = halfHeight > 0 ? ImportedShape.Capsule(radius, halfHeight) : ImportedShape.Sphere(radius);
        Add(name, shape, place, body.Vector("m_Center"), TurnD.Identity);
    }

    private void Add(string name, ImportedShape shape, in UnityPlace place, in Double3 center, in TurnD rotation)
    {
        Affine world = place.World with { Origin = place.World.Apply(center) };
        _scene.Add(new ImportedObject(name, shape, world, rotation));
    }

    private void AddMesh(string name, UnityElement component, in UnityPlace place)
    {
        UnityReference mesh = component.Body.Reference("m_Mesh");
        if (mesh.IsNone) throw new UnreadableException("it has no mesh; a script may make one when the scene runs");
        if (mesh.Guid == BuiltInMesh.Guid) AddBuiltIn(name, mesh.FileId, place);
        else AddMesh(name, component, mesh, place);
    }

    /// <summary>A collider with Convex ticked is the hull of its mesh.</summary>
    private void AddMesh(string name, UnityElement component, UnityReference mesh, in UnityPlace place)
    {
        bool isHull = component.ClassId == UnityClass.MeshCollider && component.Body.Whole("m_Convex", 0) != 0;
        ImportedMesh part = _meshes.Find(mesh, component.MeshFile, isHull);
        _scene.AddMesh(name, part, place.World, place.Rotation, isHull);
    }

    private void AddBuiltIn(string name, long mesh, in UnityPlace place)
    {
        switch (mesh)
        {
            case BuiltInMesh.Cube when Placement.IsAlongAxes(place.World.SeenFrom(place.Rotation), out Double3 scale):
                Vector3 half = (Vector3)(Placement.Absolute(scale) * BuiltInMesh.Half);
                _scene.Add(new ImportedObject(name, ImportedShape.Box(half), place.World, place.Rotation));
                break;
            case BuiltInMesh.Cube:
                _scene.AddMesh(name, _meshes.Cube, place.World, place.Rotation);
                break;
            case BuiltInMesh.Sphere:
                _scene.Add(Placement.Ball(name, BuiltInMesh.Half, place.World, place.Rotation));
                break;
            case BuiltInMesh.Capsule:
                _scene.Add(Placement.AlongY(
                    name, ImportedShape.Capsule, BuiltInMesh.Half, BuiltInMesh.CapsuleHalfHeight, place.World,
                    place.Rotation));
                break;
            case BuiltInMesh.Cylinder:
                _scene.Add(Placement.AlongY(
                    name, ImportedShape.Cylinder, BuiltInMesh.Half, BuiltInMesh.CylinderHalfHeight, place.World,
                    place.Rotation));
                break;
            case BuiltInMesh.Plane:
                _scene.AddMesh(name, _meshes.Plane, place.World, place.Rotation);
                break;
            case BuiltInMesh.Quad:
                _scene.AddMesh(name, _meshes.Quad, place.World, place.Rotation);
                break;
            default:
                throw new UnreadableException($"the built-in mesh {mesh} is not known");
        }
    }
}
