namespace Gjk.Demo.Scenes;

/// <summary>Reads a scene's JSON, version 1. It refuses everything that is not exactly right, and names the file, the
/// JSON path and the reason.</summary>
internal sealed class SceneFile
{
    private const int Version = 1;

    private readonly SceneMeshes _meshes = new();
    private readonly List<ObjectDraft> _objects = [];
    private readonly HashSet<string> _objectFields = [];
    private List<int>? _pairs;
    private string? _name;
    private int _frames = 1;

    /// <summary>The fields of a scene.</summary>
    public static string[] Fields { get; } = ["$schema", "version", "name", "meshes", "objects", "pairs", "frames"];

    private SceneFile()
    {
    }

    /// <summary>Reads and validates the whole file.</summary>
    /// <param name="file">Its name, or "-" for standard input.</param>
    /// <param name="cancel">Ends the wait for a pipe.</param>
    /// <exception cref="RefusedException">The file cannot be read, or it is not a scene.</exception>
    public static Scene Load(string file, CancellationToken cancel) =>
        Parse(InputFile.NameOf(file), InputFile.Read(file, cancel));

    private static Scene Parse(string file, ReadOnlySpan<byte> utf8)
    {
        if (utf8.StartsWith("\uFEFF"u8)) utf8 = utf8["\uFEFF"u8.Length..];
        var json = new StrictJsonReader(file, utf8);
        var scene = new SceneFile();
        json.Start();
        scene.ReadRoot(ref json);
        json.End();
        scene._meshes.BuildHulls(scene._objects.SelectMany(o => o.Shape.Hulls), Path.GetFileName(file));
        return scene.Resolve(json, Path.GetFileNameWithoutExtension(file));
    }

    private void ReadRoot(ref StrictJsonReader json)
    {
        var seen = new HashSet<string>();
        json.BeginObject("an object: a scene");
        while (json.NextField(seen, out string field))
        {
            if (Array.IndexOf(Fields, field) < 0) throw json.Refuse("unknown field");
            json.Value();
            ReadRootField(ref json, field);
            json.EndField();
        }

        foreach (string required in (ReadOnlySpan<string>)["version", "objects"])
        {
            if (seen.Contains(required)) continue;
            json.Path.Enter(required);
            throw json.Refuse("missing");
        }
    }

    private void ReadRootField(ref StrictJsonReader json, string field)
    {
        switch (field)
        {
            case "$schema":
                json.String("a string");
                break;
            case "version":
                int version = json.Whole("the number 1");
                if (version != Version) throw json.Refuse($"version {version} is not known; must be {Version}");
                break;
            case "name":
                _name = json.String("a string");
                break;
            case "meshes":
                _meshes.Read(ref json);
                break;
            case "objects":
                json.BeginArray("an array of objects");
                for (int i = 0; json.NextElement(i); i++) _objects.Add(ReadObject(ref json));
                break;
            case "pairs":
                ReadPairs(ref json);
                break;
            case "frames":
                _frames = json.Whole("a whole number, at least 1");
                if (_frames < 1) throw json.Refuse($"must be at least 1, but is {_frames}");
                break;
        }
    }

    private ObjectDraft ReadObject(ref StrictJsonReader json)
    {
        var draft = new ObjectDraft();
        _objectFields.Clear();
        json.BeginObject("an object with a \"shape\"");
        while (json.NextField(_objectFields, out string field))
        {
            if (Array.IndexOf(ObjectDraft.Fields, field) < 0) throw json.Refuse("unknown field");
            json.Value();
            draft.Read(ref json, field);
            json.EndField();
        }

        if (_objectFields.Contains("shape")) return draft;
        json.Path.Enter("shape");
        throw json.Refuse("missing");
    }

    /// <summary>Checks only the form. The objects may come later in the file, so the indices are checked when their
    /// number is known.</summary>
    private void ReadPairs(ref StrictJsonReader json)
    {
        const string what = "two object indices [a, b]";
        _pairs = [];
        json.BeginArray("an array of pairs");
        for (int i = 0; json.NextElement(i); i++)
        {
            json.BeginArray(what);
            int count = 0;
            for (; json.NextElement(count); count++)
            {
                if (count == 2)
                {
                    json.Path.Leave();
                    throw json.Refuse($"must be {what}, but has more elements");
                }

                _pairs.Add(json.Whole("an object's index, a whole number"));
            }

            if (count < 2) throw json.Refuse($"must be {what}, but has {count} element{(count == 1 ? "" : "s")}");
        }
    }

    private Scene Resolve(in StrictJsonReader json, string fileName)
    {
        var objects = new SceneObject[_objects.Count];
        for (int i = 0; i < objects.Length; i++)
        {
            json.Path.Enter("objects");
            json.Path.Enter(i);
            objects[i] = Resolve(json, _objects[i]);
            json.Path.Leave();
            json.Path.Leave();
        }

        if (_pairs is not null) CheckPairs(json, _pairs);
        ScenePairs pairs = _pairs is null ? ScenePairs.All(objects.Length) : ScenePairs.Listed(_pairs.ToArray());
        return new Scene(_name ?? fileName, objects, pairs, _frames);
    }

    private SceneObject Resolve(in StrictJsonReader json, ObjectDraft draft)
    {
        json.Path.Enter("shape");
        AnyShape shape;
        if (draft.Shape.IsConvex)
        {
            ConvexShape convex = draft.Shape.Build(json, _meshes);
            shape = AnyShape.Of(draft.Scale != Vector3.One ? convex.Scaled(draft.Scale) : convex);
        }
        else
        {
            shape = draft.Shape.BuildConcave(json, _meshes, draft.Scale);
        }

        json.Path.Leave();
        return new SceneObject(draft.Name, shape, draft.Pose, draft.Velocity, draft.AngularVelocity);
    }

    private void CheckPairs(in StrictJsonReader json, List<int> pairs)
    {
        json.Path.Enter("pairs");
        for (int i = 0; i < pairs.Count; i++)
        {
            bool inRange = (uint)pairs[i] < (uint)_objects.Count;
            bool twice = i % 2 == 1 && pairs[i] == pairs[i - 1];
            if (inRange && !twice) continue;
            json.Path.Enter(i / 2);
            if (inRange) throw json.Refuse($"pairs object {pairs[i]} with itself");
            json.Path.Enter(i % 2);
            string objects = _objects.Count == 1 ? "object" : "objects";
            throw json.Refuse(
                $"there is no object {pairs[i]}: the scene has {_objects.Count} {objects}, counted from 0");
        }

        json.Path.Leave();
    }
}
