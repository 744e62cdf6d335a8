namespace Gjk.Demo.Study.Plan;

/// <summary>The parts of a plan that are objects of their own.</summary>
internal sealed partial class StudyPlanFile
{
    private PairPlan ReadPair(ref StrictJsonReader json)
    {
        string name = "";
        ConvexShape a = default, b = default;
        Quaternion rotationA = Quaternion.Identity, rotationB = Quaternion.Identity;
        ReadObject(
            ref json, "an object: a pair", ["name", "a", "b", "rotationA", "rotationB"], ["name", "a", "b"],
            (ref StrictJsonReader j, string field) =>
            {
                switch (field)
                {
                    case "name": name = Text(j); break;
                    case "a": a = ReadShape(ref j); break;
                    case "b": b = ReadShape(ref j); break;
                    case "rotationA": rotationA = ObjectDraft.Rotation(ref j); break;
                    default: rotationB = ObjectDraft.Rotation(ref j); break;
                }
            });
        return new PairPlan(name, a, rotationA, b, rotationB);
    }

    /// <summary>A shape as in scene files. A mesh must come before the pair that names it.</summary>
    private ConvexShape ReadShape(ref StrictJsonReader json)
    {
        ShapeReader shape = ShapeReader.Read(ref json);
        if (!shape.IsConvex) throw json.Refuse("must be convex");
        _meshes.BuildHulls(shape.Hulls, "the plan");
        try
        {
            return shape.Build(json, _meshes);
        }
        catch (ArgumentException e)
        {
            throw json.Refuse(e.Message.Split('\n')[0]);
        }
    }

    private static ViewPlan ReadView(ref StrictJsonReader json)
    {
        var view = new ViewPlan("");
        ReadObject(
            ref json, "an object: a view",
            ["name", "camera", "yaw", "pitch", "shadow", "texture", "background"], ["name"],
            (ref StrictJsonReader j, string field) =>
            {
                switch (field)
                {
                    case "name": view = view with { Name = Text(j) }; break;
                    case "camera": view = view with { Camera = OneOf(j, Cameras) }; break;
                    case "yaw": view = view with { Yaw = j.Float() }; break;
                    case "pitch": view = view with { Pitch = Pitch(j) }; break;
                    case "shadow": view = view with { HasShadow = j.Bool() }; break;
                    case "texture": view = view with { HasTexture = j.Bool() }; break;
                    default: view = view with { Background = ReadColour(j) }; break;
                }
            });
        return view;
    }

    private static AdjustmentPlan ReadAdjustment(ref StrictJsonReader json)
    {
        var task = new AdjustmentPlan();
        ReadObject(
            ref json, "an object: the task adjustment", ["repeats", "starts", "fine", "coarse"], ["repeats", "starts"],
            (ref StrictJsonReader j, string field) =>
            {
                switch (field)
                {
                    case "repeats": task = task with { Repeats = Count(j, 1, 1000) }; break;
                    case "starts": task = task with { Starts = Gaps(ref j) }; break;
                    case "fine": task = task with { Fine = Positive(j) }; break;
                    default: task = task with { Coarse = Positive(j) }; break;
                }
            });
        return task;
    }

    private static ConstantPlan ReadConstant(ref StrictJsonReader json)
    {
        var task = new ConstantPlan();
        ReadObject(
            ref json, "an object: the task constant", ["repeats", "gaps", "cross", "milliseconds", "mask"],
                ["repeats", "gaps"],
            (ref StrictJsonReader j, string field) =>
            {
                switch (field)
                {
                    case "repeats": task = task with { Repeats = Count(j, 1, 1000) }; break;
                    case "gaps": task = task with { Gaps = Gaps(ref j) }; break;
                    case "cross": task = task with { Cross = Count(j, 0, 60_000) }; break;
                    case "milliseconds": task = task with { Milliseconds = Count(j, 10, 60_000) }; break;
                    default: task = task with { Mask = Count(j, 0, 60_000) }; break;
                }
            });
        return task;
    }

    private static MismatchPlan ReadMismatch(ref StrictJsonReader json)
    {
        var task = new MismatchPlan();
        ReadObject(
            ref json, "an object: the task mismatch", ["repeats", "colliders"], ["repeats", "colliders"],
            (ref StrictJsonReader j, string field) =>
            {
                if (field == "repeats") task = task with { Repeats = Count(j, 1, 1000) };
                else task = task with { Colliders = [.. List(ref j, "collider", ReadCollider, name => name)] };
            });
        return task;
    }

    private void ReadCatch(ref StrictJsonReader json) => ReadObject(
        ref json, "an object: the catch trials", ["trials", "gap"], ["trials", "gap"],
        (ref StrictJsonReader j, string field) =>
        {
            if (field == "trials") _plan = _plan with { CatchTrials = Count(j, 0, 1000) };
            else _plan = _plan with { CatchGap = Positive(j) };
        });

    private static string ReadCollider(ref StrictJsonReader json)
    {
        string name = json.String("a collider: " + Collider.Names);
        return Collider.IsKnown(name) ? name
            : throw json.Refuse($"unknown collider \"{name}\"; must be {Collider.Names}");
    }

    private static float[] Gaps(ref StrictJsonReader json)
    {
        var gaps = new List<float>();
        json.BeginArray("an array of signed gaps");
        while (json.NextElement(gaps.Count))
        {
            float gap = json.Float();
            if (gaps.Contains(gap)) throw json.Refuse(FormattableString.Invariant($"the gap {gap:R} is there already"));
            gaps.Add(gap);
        }

        return gaps.Count >= 2 ? [.. gaps] : throw json.Refuse("must have at least two gaps");
    }

    private static float Pitch(in StrictJsonReader json)
    {
        float pitch = json.Float();
        return Math.Abs(pitch) <= 85 ? pitch : throw json.Refuse("must be -85 to 85 degrees");
    }

    private static string OneOf(in StrictJsonReader json, string[] words)
    {
        string word = json.String(string.Join(" or ", words));
        return words.Contains(word) ? word
            : throw json.Refuse($"must be {string.Join(" or ", words)}, but is \"{word}\"");
    }

    private static string ReadColour(in StrictJsonReader json)
    {
        string colour = json.String("a colour as #rrggbb");
        return Colour().IsMatch(colour) ? colour : throw json.Refuse("must be a colour as #rrggbb");
    }
}
