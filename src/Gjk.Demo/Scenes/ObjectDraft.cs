namespace Gjk.Demo.Scenes;

/// <summary>An object as it was read. Its mesh is still a name, because "meshes" may come after "objects".</summary>
internal sealed class ObjectDraft
{
    private Vector3 _position;
    private Quaternion _rotation = Quaternion.Identity;

    public string? Name { get; private set; }

    /// <summary>Set before the object is used. A file without a shape is refused.</summary>
    public ShapeReader Shape { get; private set; } = null!;

    public Vector3 Scale { get; private set; } = Vector3.One;

    public Vector3 Velocity { get; private set; }

    public Vector3 AngularVelocity { get; private set; }

    public RigidPose Pose => new(_rotation, _position);

    /// <summary>The fields of an object.</summary>
    public static string[] Fields { get; } =
        ["name", "shape", "position", "rotation", "scale", "velocity", "angularVelocity"];

    public void Read(ref StrictJsonReader json, string field)
    {
        switch (field)
        {
            case "name":
                Name = json.String("a string");
                break;
            case "shape":
                Shape = ShapeReader.Read(ref json);
                break;
            case "position":
                _position = json.Vector();
                break;
            case "rotation":
                _rotation = Rotation(ref json);
                break;
            case "scale":
                Scale = json.IsArray ? json.Vector(NumberRule.NotZero) : new Vector3(json.NotZero());
                break;
            case "velocity":
                Velocity = json.Vector();
                break;
            case "angularVelocity":
                AngularVelocity = json.Vector();
                break;
        }
    }

    /// <summary>Reads a rotation. A quaternion that does not describe one is refused.</summary>
    public static Quaternion Rotation(ref StrictJsonReader json)
    {
        Quaternion q = json.Quaternion();
        try
        {
            return new RigidPose(q, Vector3.Zero).Rotation;
        }
        catch (ArgumentOutOfRangeException)
        {
            double length = Math.Sqrt((double)q.X * q.X + (double)q.Y * q.Y + (double)q.Z * q.Z + (double)q.W * q.W);
            throw json.Refuse(
                FormattableString.Invariant($"the quaternion's length must be within 1e-3 of 1, but is {length:G6}"));
        }
    }
}
