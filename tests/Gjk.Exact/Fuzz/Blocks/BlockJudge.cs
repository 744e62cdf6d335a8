using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.Blocks;

/// <summary>Asks one query about each pair of a block, in rotation, and holds the answer to its certificate and to what
/// the distance says. Not thread-safe: it keeps a warm start.</summary>
internal sealed class BlockJudge
{
    /// <summary>Hulls with no more vertices always get a depth.</summary>
    private const int MostVertices = 512;

    private static readonly string[] Verbs =
    [
        "distance", "overlaps", "cast", "warm distance", "ray", "signed distance", "point", "warm signed distance",
    ];

    /// <summary>The verbs from here on ask for a depth.</summary>
    private const int FirstDepth = 5;

    /// <summary>Count: of so many depths of curved shapes one is asked. Deep in each other they use all the room of the
    /// search, which takes as long as a thousand other pairs.</summary>
    private const int CurvedDepths = 32;

    private readonly BlockPairs _pairs;
    private WarmStart _warm;
    private Vector3 _velocityA, _velocityB, _point;
    private int _verb;

    public BlockJudge(BlockPairs pairs) => _pairs = pairs;

    /// <summary>What was asked last.</summary>
    public string Verb => Verbs[_verb];

    /// <summary>Asks about the pair at hand, and tells it what a distance says.</summary>
    /// <param name="index">The pair's number: which query it is asked.</param>
    /// <param name="problem">What is wrong, or null.</param>
    public CheckStatus Ask(long index, out string? problem)
    {
        BlockPairs p = _pairs;
        _verb = (int)(index % Verbs.Length);
        bool isCurved = IsCurved(p.A) || IsCurved(p.B);
        if (_verb >= FirstDepth && isCurved && index / Verbs.Length % CurvedDepths != 0) _verb -= FirstDepth;
        (_velocityA, _velocityB) = (default, default);
        problem = null;
        return _verb switch
        {
            0 => Judge(ConvexQuery.Distance(p.A, p.PoseA, p.B, p.PoseB), ref problem),
            1 => Overlaps(ref problem),
            2 => Cast(ref problem),
            3 => Judge(ConvexQuery.Distance(p.A, p.PoseA, p.B, p.PoseB, ref _warm), ref problem),
            4 => Ray(ref problem),
            5 => Signed(ref problem),
            6 => Point(ref problem),
            _ => JudgeSigned(ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB, ref _warm), ref problem),
        };
    }

    /// <summary>The last question as a line that <c>query --record</c> and <c>cast --record</c> read.</summary>
    public string Record() => Verb is "ray" or "point"
        ? new QueryRecord(
            _pairs.A, new RigidMotion(_pairs.PoseA, default), ConvexShape.Point(),
            new RigidMotion(new RigidPose(_point), _velocityB)).ToString()
        : new QueryRecord(
            _pairs.A, new RigidMotion(_pairs.PoseA, _velocityA), _pairs.B,
            new RigidMotion(_pairs.PoseB, _velocityB)).ToString();

    private CheckStatus Overlaps(ref string? problem)
    {
        BlockPairs p = _pairs;
        bool flag = ConvexQuery.Overlaps(p.A, p.PoseA, p.B, p.PoseB, out GjkStatus status);
        DistanceResult distance = ConvexQuery.Distance(p.A, p.PoseA, p.B, p.PoseB);
        p.Tell(distance);
        if (flag != distance.IsOverlapping || status != distance.Status)
            problem = Say.Line($"{status}, the distance says {distance}");
        CheckedAnswer check = AnswerCheck.Overlaps(p.A, p.PoseA, p.B, p.PoseB, flag);
        return Status(check, ref problem);
    }

    private CheckStatus Signed(ref string? problem)
    {
        BlockPairs p = _pairs;
        DistanceResult r = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
        if (r.Status == GjkStatus.Separated)
        {
            DistanceResult distance = ConvexQuery.Distance(p.A, p.PoseA, p.B, p.PoseB);
            problem = Same.BitProblem(distance, r, "the signed distance");
        }

        return JudgeSigned(r, ref problem);
    }

    private CheckStatus Cast(ref string? problem)
    {
        BlockPairs p = _pairs;
        p.DrawMotion(out _velocityA, out _velocityB);
        CastResult r = ConvexQuery.Cast(p.A, p.PoseA, _velocityA, p.B, p.PoseB, _velocityB);
        return Judge(
            r, r.Status, AnswerCheck.Cast(p.A, p.PoseA, _velocityA, p.B, p.PoseB, _velocityB, r), ref problem);
    }

    private CheckStatus Ray(ref string? problem)
    {
        BlockPairs p = _pairs;
        p.DrawRay(out _point, out _velocityB);
        RayCastResult r = ConvexQuery.RayCast(p.A, p.PoseA, _point, _velocityB);
        return Judge(r, r.Status, AnswerCheck.RayCast(p.A, p.PoseA, _point, _velocityB, r), ref problem);
    }

    private CheckStatus Point(ref string? problem)
    {
        BlockPairs p = _pairs;
        _point = p.DrawPoint();
        var pose = new RigidPose(_point);
        DistanceResult r = ConvexQuery.SignedDistance(p.A, p.PoseA, _point);
        bool isIn = ConvexQuery.Contains(p.A, p.PoseA, _point);
        if (isIn != r.IsOverlapping && r.Status != GjkStatus.IterationLimit)
            problem = Say.Line($"Contains says {isIn}, the signed distance {r}");
        if (!HasDepth(r.Status, p.A)) problem = r.ToString();
        return Status(AnswerCheck.SignedDistance(p.A, p.PoseA, default(PointShape), pose, r), ref problem);
    }

    private CheckStatus Judge(in DistanceResult r, ref string? problem)
    {
        BlockPairs p = _pairs;
        p.Tell(r);
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping)) problem = r.ToString();
        return Status(AnswerCheck.Distance(p.A, p.PoseA, p.B, p.PoseB, r), ref problem);
    }

    private CheckStatus JudgeSigned(in DistanceResult r, ref string? problem)
    {
        BlockPairs p = _pairs;
        p.Tell(r);
        if (!HasDepth(r.Status, p.A) && !HasDepth(r.Status, p.B)) problem = r.ToString();
        return Status(AnswerCheck.SignedDistance(p.A, p.PoseA, p.B, p.PoseB, r), ref problem);
    }

    private static CheckStatus Status(in CheckedAnswer check, ref string? problem)
    {
        if (check.Status == CheckStatus.Refuted) problem = Say.Line($"the check says {check}");
        return check.Status;
    }

    /// <summary>Whether a depth may end so; only curved shapes and large hulls outgrow the room of its
    /// search.</summary>
    private static bool HasDepth(GjkStatus status, in ConvexShape shape) =>
        status is GjkStatus.Separated or GjkStatus.Overlapping
            || (status == GjkStatus.IterationLimit
                && (IsCurved(shape) || shape.Hull is { VertexCount: > MostVertices }));

    private CheckStatus Judge<T>(in T result, CastStatus status, in CheckedAnswer check, ref string? problem)
        where T : struct
    {
        bool hasAnswer = status is CastStatus.Hit or CastStatus.Miss or CastStatus.OverlappingAtStart
            || (status == CastStatus.IterationLimit && (IsCurved(_pairs.A) || IsCurved(_pairs.B)));
        if (!hasAnswer) problem = result.ToString();
        else if (check.Status == CheckStatus.Refuted) problem = Say.Line($"{result}: {check}");
        return check.Status;
    }

    public static bool IsCurved(in ConvexShape shape) => shape.Support(new Double3(1, 0, 0), out _) < 0;
}
