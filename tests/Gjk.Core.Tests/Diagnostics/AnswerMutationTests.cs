namespace Gjk.Core.Tests.Diagnostics;

/// <summary>Every field of right answers of every verb is changed to wrong values: none of them is proved. What the
/// check says that it does not judge is left as it is.</summary>
public class AnswerMutationTests
{
    private static readonly GjkStatus[] Statuses = Enum.GetValues<GjkStatus>();

    private static readonly CastStatus[] CastStatuses = Enum.GetValues<CastStatus>();

    private static readonly float[] WrongNumbers =
        [float.NaN, float.PositiveInfinity, float.NegativeInfinity, float.MaxValue, -1e30f];

    public static TheoryData<string> Kinds =>
        ["box", "sphere", "capsule", "hull", "triangle", "cylinder", "cone", "ellipsoid", "made"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void AWrongDistanceIsNeverProved(string kind) => Each(kind, (p, size) =>
    {
        foreach (bool isSigned in new[] { false, true })
        {
            foreach (float most in new[] { float.PositiveInfinity, 0.01f * size })
            {
                DistanceResult right = isSigned ? p.SignedDistance() : p.Distance(most);
                Assert.True(Check(right) is CheckStatus.Proved or CheckStatus.ProvedAtMost, $"{right}, {p}");
                foreach ((string what, DistanceResult wrong) in Wrong(right, size))
                {
                    bool isRight = Check(wrong) != CheckStatus.Proved || IsTrue(p, right, wrong);
                    Assert.True(isRight, $"{what}, {isSigned}: {right}\n{wrong}\n{p}");
                }
            }

            CheckStatus Check(in DistanceResult r) => isSigned
                ? AnswerCheck.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, r).Status
                : AnswerCheck.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, r).Status;
        }
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void AWrongFlagIsNeverProved(string kind) => Each(kind, (p, _) =>
    {
        Assert.Equal(CheckStatus.Proved, Check(p.Overlaps()));
        Assert.NotEqual(CheckStatus.Proved, Check(!p.Overlaps()));

        CheckStatus Check(bool flag) => AnswerCheck.Overlaps(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, flag).Status;
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void AWrongCastIsNeverProved(string kind)
    {
        var asked = new HashSet<CastStatus>();
        Each(kind, (p, size) =>
        {
            Vector3 between = p.PoseB.Position - p.PoseA.Position;
            foreach (Vector3 motion in new[] { -2 * between, between })
            {
                CastResult right = ConvexQuery.Cast(p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion);
                Judge(right, motion.Length(), r => AnswerCheck.Cast(
                    p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion, r).Status);
                RayCastResult ray = ConvexQuery.RayCast(p.A.Shape, p.PoseA, p.PoseB.Position, motion, 4 * size);
                var asCast = new CastResult(ray.Status, ray.Distance, ray.Point, ray.Normal, 0, ray.Depth);
                Judge(asCast, 1, r => AnswerCheck.RayCast(
                    p.A.Shape, p.PoseA, p.PoseB.Position, motion,
                    new RayCastResult(r.Status, r.Fraction, r.Point, r.Normal, 0, r.Depth)).Status);
            }

            void Judge(in CastResult right, float speed, Func<CastResult, CheckStatus> check)
            {
                if (check(right) is not (CheckStatus.Proved or CheckStatus.ProvedAtMost)) return;
                asked.Add(right.Status);
                foreach ((string what, CastResult wrong) in Wrong(right, size, speed))
                    Assert.True(check(wrong) != CheckStatus.Proved, $"{what}: {right}\n{wrong} {wrong.Depth}\n{p}");
            }
        });
        Assert.True(asked.Count == 3 || kind is "triangle", string.Join(", ", asked));
    }

    /// <summary>Within what counts as touching, a flag may be open, but not both of them proved.</summary>
    [Fact]
    public void OfTwoFlagsOneIsProvedAtMost()
    {
        ConvexShape spheroid = ConvexShape.Ellipsoid(new Vector3(0.5f, 1, 0.5f));
        for (int i = 0; i < 200; i++)
        {
            var rng = new Rng((ulong)i);
            Quaternion turn = Quaternion.Normalize(new(rng.LogFloat(1e-8, 1e-3), 0, rng.LogFloat(1e-8, 1e-3), 1));
            var pose = new RigidPose(turn, new Vector3(0, -2 - (i % 4 * 2.4e-7f), 0));
            CheckStatus yes = AnswerCheck.Overlaps(spheroid, RigidPose.Identity, spheroid, pose, true).Status;
            CheckStatus no = AnswerCheck.Overlaps(spheroid, RigidPose.Identity, spheroid, pose, false).Status;
            Assert.False(yes == CheckStatus.Proved && no == CheckStatus.Proved, $"seed {i}");
        }
    }

    /// <summary>What is true is not refuted, though the library would not say so.</summary>
    [Fact]
    public void TrueBoundsAreNotRefuted()
    {
        var box = new BoxShape(Vector3.One);
        var pose = new RigidPose(new Vector3(1.5f, 0, 0));
        DistanceResult r = ConvexQuery.Distance(box, RigidPose.Identity, box, pose);
        foreach (DistanceResult told in new[]
        {
            r.With(bound: -1e-9f),
            r.With(status: GjkStatus.IterationLimit, distance: 0.1f, normal: Vector3.UnitX),
        })
        {
            CheckedAnswer check = AnswerCheck.Distance(box, RigidPose.Identity, box, pose, told);
            Assert.True(check.Status != CheckStatus.Refuted, $"{told}: {check}");
        }
    }

    /// <summary>Whether only the normal is another, and the planes across it stand further apart than the bound: any
    /// such normal is right where no distance is told.</summary>
    private static bool IsTrue(TestPair p, in DistanceResult right, in DistanceResult told)
    {
        if (right.Status != GjkStatus.BeyondMaxDistance || told.Normal == right.Normal) return false;
        if (!(Math.Abs(told.Normal.Length() - 1) <= 1e-6f)) return false;
        var a = new Body<ConvexShape>(p.A.Shape, p.PoseA);
        var b = new Body<ConvexShape>(p.B.Shape, p.PoseB);
        Double3 normal = (Double3)told.Normal * (1 / told.Normal.Length());
        double gap = Double3.Dot(normal, b.Position - a.Position) - a.Height(normal) - b.Height(-normal);
        return gap >= right.LowerBound;
    }

    private static IEnumerable<(string What, DistanceResult Wrong)> Wrong(DistanceResult r, float size)
    {
        // That a limit was reached is not judged.
        foreach (GjkStatus status in Statuses.Where(s => s != r.Status && s != GjkStatus.IterationLimit))
            yield return ($"status {status}", r.With(status: status));
        foreach (float d in Numbers(r.Distance, size).Where(d => d != r.Distance))
            yield return ($"distance {d}", r.With(distance: d));

        // A smaller bound is true, too.
        float least = r.Status == GjkStatus.BeyondMaxDistance ? size * 8 : r.Distance + 1e-3f * size;
        foreach (float bound in new[] { float.NaN, float.PositiveInfinity, float.MaxValue, least })
            yield return ($"bound {bound}", r.With(bound: bound));
        foreach (Vector3 n in Normals(r.Normal, 1e-3f))
            yield return ($"normal {n}", r.With(normal: n));
        if (r.Status == GjkStatus.BeyondMaxDistance) yield break;
        foreach (Vector3 p in Points(r.PointA, size)) yield return ($"point A {p}", r.With(pointA: p));
        foreach (Vector3 p in Points(r.PointB, size)) yield return ($"point B {p}", r.With(pointB: p));
        foreach (Vector3 p in Points(r.LocalPointA, size)) yield return ($"local A {p}", r.With(localA: p));
        foreach (Vector3 p in Points(r.LocalPointB, size)) yield return ($"local B {p}", r.With(localB: p));
    }

    private static IEnumerable<(string What, CastResult Wrong)> Wrong(CastResult r, float size, float speed)
    {
        // That a limit was reached is not judged.
        foreach (CastStatus status in CastStatuses.Where(s => s != r.Status && s != CastStatus.IterationLimit))
            yield return ($"status {status}", r.With(status: status));
        foreach (float d in Numbers(r.Depth, size).Where(d => d != r.Depth))
            yield return ($"depth {d}", r.With(depth: d));
        if (r.Status == CastStatus.Miss)
        {
            // A miss up to another fraction may be one, too.
            yield return ("fraction", r.With(fraction: float.NaN));
            yield return ("fraction", r.With(fraction: -1));
            yield return ("point", r.With(point: Vector3.One));
            yield return ("normal", r.With(normal: Vector3.UnitX));
            yield break;
        }

        foreach (float f in Numbers(r.Fraction, size / speed).Where(f => f != r.Fraction))
            yield return ($"fraction {f}", r.With(fraction: f));
        foreach (Vector3 p in Points(r.Point, size)) yield return ($"point {p}", r.With(point: p));

        // Round bodies touch to 1e-9, and their normals are held to the root of that.
        foreach (Vector3 n in Normals(r.Normal, 0.05f)) yield return ($"normal {n}", r.With(normal: n));
    }

    private static float[] Numbers(float right, float unit) =>
        [.. WrongNumbers, -right, right + 1e-3f * unit, right - 1e-3f * unit, right + unit];

    private static Vector3[] Points(Vector3 right, float size) =>
    [
        .. WrongNumbers.Select(w => right with { Y = w }), new(float.NegativeInfinity), new(float.NaN),
        right + new Vector3(size, 2 * size, -size), right - new Vector3(2 * size),
    ];

    private static IEnumerable<Vector3> Normals(Vector3 right, float off) => new[]
    {
        right * 1.001f, right + new Vector3(off, -off, 2 * off), -right, default, new Vector3(0.6f, 0, 0.8f),
    }.Concat(WrongNumbers.Select(w => right with { Z = w })).Where(n => n != right);

    /// <summary>Pairs that are clearly apart or clearly overlap.</summary>
    private static void Each(string kind, Action<TestPair, float> judge)
    {
        int asked = 0;
        for (ulong i = 0; i < (ulong)Budget.Count(60); i++)
        {
            TestPair p = Generators.Pair(70_000 + i, [kind, "box", "cylinder"], i % 2 == 0 ? 1.5 : 0.6);
            float size = (float)(p.A.Shape.BoundingRadius + p.B.Shape.BoundingRadius);
            DistanceResult r = p.SignedDistance();
            if (r.Status == GjkStatus.IterationLimit || Math.Abs(r.Distance) < 0.05f * size) continue;
            asked++;
            judge(p, size);
        }

        Assert.True(asked > 20, $"{asked} pairs");
    }
}
