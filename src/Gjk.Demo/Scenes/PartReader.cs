namespace Gjk.Demo.Scenes;

/// <summary>A child of a compound as it was read: a shape in its place.</summary>
internal sealed class PartReader
{
    private Vector3 _position;
    private Quaternion _rotation = Quaternion.Identity;

    private PartReader()
    {
    }

    /// <summary>The part's shape.</summary>
    public ShapeReader Shape { get; private set; } = null!;

    /// <summary>Where it is in the compound.</summary>
    public RigidPose Pose => new(_rotation, _position);

    /// <summary>Reads the "parts" of a compound.</summary>
    public static List<PartReader> ReadAll(ref StrictJsonReader json)
    {
        var parts = new List<PartReader>();
        json.BeginArray("an array of parts");
        while (json.NextElement(parts.Count)) parts.Add(Read(ref json));
        if (parts.Count == 0) throw json.Refuse("a compound needs at least one part");
        return parts;
    }

    private static PartReader Read(ref StrictJsonReader json)
    {
        var part = new PartReader();
        var seen = new HashSet<string>();
        json.BeginObject("an object with a \"shape\"");
        while (json.NextField(seen, out string field))
        {
            if (field is not ("shape" or "position" or "rotation")) throw json.Refuse("unknown field");
            json.Value();
            if (field == "shape") part.ReadShape(ref json);
            else if (field == "position") part._position = json.Vector();
            else part._rotation = ObjectDraft.Rotation(ref json);
            json.EndField();
        }

        if (part.Shape is not null) return part;
        json.Path.Enter("shape");
        throw json.Refuse("missing");
    }

    private void ReadShape(ref StrictJsonReader json)
    {
        Shape = ShapeReader.Read(ref json);
        if (!Shape.IsEndless) return;
        json.Path.Enter("type");
        throw json.Refuse("a part of a compound cannot be a half-space");
    }
}
