namespace Gjk.Demo.Study.Plan;

/// <summary>Two shapes that are shown together. B moves along the x axis, away from A for positive gaps.</summary>
internal sealed record PairPlan(
    string Name, ConvexShape A, Quaternion RotationA, ConvexShape B, Quaternion RotationB);

/// <summary>How a trial looks. Angles are in degrees.</summary>
internal sealed record ViewPlan(string Name)
{
    /// <summary>One of <see cref="StudyPlanFile.Cameras"/>.</summary>
    public string Camera { get; init; } = "fixed";

    public float Yaw { get; init; }

    public float Pitch { get; init; } = 12;

    public bool HasShadow { get; init; } = true;

    public bool HasTexture { get; init; }

    /// <summary>As #rrggbb.</summary>
    public string Background { get; init; } = "#20262f";
}

/// <summary>Lengths are in units of the scene.</summary>
internal sealed record AdjustmentPlan
{
    public int Repeats { get; init; } = 1;

    /// <summary>Signed gaps from which the person begins; negative ones overlap.</summary>
    public float[] Starts { get; init; } = [];

    public float Fine { get; init; } = 0.002f;

    public float Coarse { get; init; } = 0.02f;
}

internal sealed record ConstantPlan
{
    public int Repeats { get; init; } = 1;

    public float[] Gaps { get; init; } = [];

    /// <summary>How long a cross says where to look, before the view.</summary>
    public int Cross { get; init; } = 300;

    public int Milliseconds { get; init; } = 500;

    public int Mask { get; init; } = 300;
}

/// <summary>B falls on A until its collider touches, and is drawn with its own shape.</summary>
internal sealed record MismatchPlan
{
    public int Repeats { get; init; } = 1;

    /// <summary>Names that <see cref="Collider.Of"/> understands.</summary>
    public string[] Colliders { get; init; } = [];
}

/// <summary>A study as its plan describes it.</summary>
internal sealed record StudyPlan
{
    public string Name { get; init; } = "";

    /// <summary>The first 12 digits of the SHA-256 of the plan's bytes. Data carry it.</summary>
    public string Id { get; init; } = "";

    public int Seed { get; init; } = 1;

    public string Consent { get; init; } = "";

    public string Instructions { get; init; } = "";

    /// <summary>Whether age and vision are asked for.</summary>
    public bool HasQuestions { get; init; } = true;

    /// <summary>From the eye to the screen, in millimetres, as it is proposed to the person.</summary>
    public float ViewingDistance { get; init; } = 570;

    public IReadOnlyList<PairPlan> Pairs { get; init; } = [];

    public IReadOnlyList<ViewPlan> Views { get; init; } = [];

    public AdjustmentPlan? Adjustment { get; init; }

    public ConstantPlan? Constant { get; init; }

    public MismatchPlan? Mismatch { get; init; }

    public int PracticeTrials { get; init; } = 2;

    public int CatchTrials { get; init; }

    /// <summary>A gap, and an overlap, that everybody sees.</summary>
    public float CatchGap { get; init; } = 0.5f;

    /// <summary>Trials between breaks; 0 for none.</summary>
    public int BreakEvery { get; init; }
}
