namespace Gjk.Core.Tests.Diagnostics;

/// <summary>Right answers: none is refuted, nearly all are proved, and what is proved holds the truth.
/// AnswerRefusalTests has the wrong ones.</summary>
public class AnswerCheckTests
{
    public static TheoryData<string> Families => [.. CaseFamily.Names, .. CaseFamily.DepthNames];

    public static TheoryData<string> Casts => [.. CastFamily.Names];

    public static TheoryData<string> Kinds =>
        [.. Generators.AllKinds, .. Generators.LaterKinds, "bigHull", "made", "madeFarOff", "madeUneven"];

    [Theory]
    [MemberData(nameof(Families))]
    public void EveryHardDistanceIsProved(string family) => CaseFamily.Each(family, c =>
    {
        TestPair p = c.Pair;
        CheckedAnswer check = AnswerCheck.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, p.Distance());
        return check.Status == CheckStatus.Proved && Holds(check, c) ? null : check.ToString();
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void EveryHardFlagIsProved(string family) => CaseFamily.Each(family, c =>
    {
        TestPair p = c.Pair;
        CheckedAnswer check = AnswerCheck.Overlaps(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, p.Overlaps());
        return check.Status == CheckStatus.Proved && Holds(check, c) ? null : check.ToString();
    });

    /// <summary>Apart, touching or shallow in their margins, the bounds meet; else the way out is proved.</summary>
    [Theory]
    [MemberData(nameof(Families))]
    public void EveryHardDepthIsProvedAtMost(string family) => CaseFamily.Each(family, c =>
    {
        TestPair p = c.Pair;
        DistanceResult r = p.SignedDistance();
        CheckedAnswer check = AnswerCheck.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, r);
        double band = Accuracy.Band(Math.Abs(r.Distance), 10 * p.Scale);
        CheckStatus expected = r.Status == GjkStatus.IterationLimit ? CheckStatus.Open
            : check.UpperBound <= r.Distance + band ? CheckStatus.Proved : CheckStatus.ProvedAtMost;

        // Where the upper bound is within the check's own rounding of the band, either is right.
        bool isRight = check.Status == expected
            || (expected == CheckStatus.ProvedAtMost && check.Status == CheckStatus.Proved);
        return isRight && Holds(check, c) ? null : $"{check}, expected {expected}, {r}";
    });

    /// <summary>Curved shapes that overlap by 7e-11 may be said to be apart, and their least distance is 0.</summary>
    [Fact]
    public void ALowerBoundOfZeroOfADistanceIsProved()
    {
        const string Record = "gjk1 ellipsoid 1 1 1 + 0.67936742305755615 @ 0.732981205 -0.581961095 -0.0399343371 "
            + "0.349950045 3.03989331E-08 2.42104523E-08 1.2366117E-08 segment -0 -0.0049385676453951423 -0 -0 "
            + "0.0049385676453951423 -0 2.035767464359358 @ 0.732981205 -0.581961095 -0.0399343371 0.349950045 "
            + "2.225384 2.96443796 -0.289813071";
        QueryRecord p = QueryRecord.Parse(Record);
        DistanceResult s = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
        var r = new DistanceResult(
            GjkStatus.Separated, 1e-9f, 0, s.PointA, s.PointB, s.Normal, s.LocalPointA, s.LocalPointB, 1);
        CheckedAnswer check = AnswerCheck.Distance(p.A, p.PoseA, p.B, p.PoseB, r);
        Assert.True(check.Status == CheckStatus.Proved && check.UpperBound < 0, $"{check}: {r}");
    }

    [Theory]
    [MemberData(nameof(Casts))]
    public void HardCastsAreProved(string family)
    {
        IReadOnlyList<CastCase> cases = CastFamily.Load(family);
        var open = new List<string>();
        foreach (CastCase c in cases)
        {
            CheckedAnswer check = AnswerCheck.Cast(
                c.Pair.A.Shape, c.Pair.PoseA, default, c.Pair.B.Shape, c.Pair.PoseB, c.Velocity, c.Cast());
            double truth = c.Outcome == CastStatus.Miss ? double.PositiveInfinity : c.Fraction;
            string said = $"{c.Pair}: {check}, truly {truth:R}";
            bool isAtStart = c.Outcome == CastStatus.OverlappingAtStart;
            Assert.True(
                check.Status is CheckStatus.Proved or CheckStatus.Open
                    || (isAtStart && check.Status == CheckStatus.ProvedAtMost), said);
            Assert.True(check.LowerBound <= truth && check.UpperBound >= truth, said);

            // That a touch at the start slides on or leaves is no matter of planes that are apart.
            bool leaves = c.Outcome == CastStatus.Miss && c.Pair.Overlaps();
            if (check.Status == CheckStatus.Open && !leaves) open.Add(said);
        }

        // Two that slide onto a face in its own plane touch it all along as far as doubles can tell.
        Assert.True(open.Count <= (family == "cast_slide" ? 2 : 0), string.Join("\n", open));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void RandomPairsAreProved(string kind)
    {
        string[] kinds = [kind, "hull", "sphere", "cone"];
        var counts = new int[4];
        int count = Budget.Count(300);
        for (ulong i = 0; i < (ulong)count; i++)
        {
            TestPair p = i % 3 == 0
                ? Generators.NearPair(90_000 + i, kinds, new Rng(i).LogFloat(1e-9, 1e-1) * (i % 2 == 0 ? 1 : -1))
                : Generators.Pair(90_000 + i, kinds);
            (ConvexShape a, ConvexShape b) = (p.A.Shape, p.B.Shape);
            Vector3 way = new Rng(i).UnitVector() * 3;
            var warm = default(WarmStart);
            ConvexQuery.SignedDistance(b, p.PoseB, a, p.PoseA, ref warm);
            CheckedAnswer[] checks =
            [
                AnswerCheck.Distance(a, p.PoseA, b, p.PoseB, p.Distance()),
                AnswerCheck.Distance(
                    a, p.PoseA, b, p.PoseB, ConvexQuery.Distance(a, p.PoseA, b, p.PoseB, ref warm)),
                AnswerCheck.Distance(a, p.PoseA, b, p.PoseB, p.Distance(0.1f)),
                AnswerCheck.SignedDistance(a, p.PoseA, b, p.PoseB, p.SignedDistance()),
                AnswerCheck.Overlaps(a, p.PoseA, b, p.PoseB, p.Overlaps()),
                AnswerCheck.Cast(a, p.PoseA, default, b, p.PoseB, way, ConvexQuery.Cast(
                    a, p.PoseA, default, b, p.PoseB, way)),
                AnswerCheck.RayCast(
                    a, p.PoseA, p.PoseB.Position, way, ConvexQuery.RayCast(a, p.PoseA, p.PoseB.Position, way)),
            ];
            for (int k = 0; k < checks.Length; k++)
            {
                Assert.True(checks[k].Status != CheckStatus.Refuted, $"check {k}: {checks[k]}\n{p}");
                counts[(int)checks[k].Status]++;
            }
        }

        // Two points in one place part by any motion; no plane says so at the start.
        double mostOpen = kind == "point" ? 0.02 : 0.005;
        Assert.True(counts[(int)CheckStatus.Open] <= mostOpen * counts.Sum(), string.Join(", ", counts));
    }

    /// <summary>A support function of one's own is all that a check needs; it may be generous.</summary>
    [Fact]
    public void UsersShapesAreProved()
    {
        for (ulong i = 0; i < 200; i++)
        {
            TestPair p = Generators.Pair(i, ["hull", "cone", "capsule"]);
            var a = new Own(p.A.Shape);
            DistanceResult r = ConvexQuery.SignedDistance(a, p.PoseA, p.B.Shape, p.PoseB);
            CheckedAnswer check = AnswerCheck.SignedDistance(a, p.PoseA, p.B.Shape, p.PoseB, r);
            Assert.True(check.Status is CheckStatus.Proved or CheckStatus.ProvedAtMost, $"{check}\n{r}\n{p}");
        }
    }

    [Fact]
    public void WhatIsNoInputIsOpen()
    {
        var box = new BoxShape(Vector3.One);
        RigidPose pose = RigidPose.Identity;
        var nowhere = default(RigidPose);
        var noShape = default(ConvexMesh);
        DistanceResult right = ConvexQuery.Distance(box, pose, box, pose);
        DistanceResult none = ConvexQuery.Distance(noShape, pose, box, pose);
        CastResult cast = ConvexQuery.Cast(box, pose, default, box, pose, default);
        CheckedAnswer[] checks =
        [
            AnswerCheck.Distance(noShape, pose, box, pose, none), AnswerCheck.Distance(noShape, pose, box, pose, right),
            AnswerCheck.Distance(box, pose, box, nowhere, right), AnswerCheck.Distance(box, pose, box, pose, none),
            AnswerCheck.Distance(box, pose, box, pose, default),
            AnswerCheck.SignedDistance(box, nowhere, noShape, pose, right),
            AnswerCheck.Overlaps(noShape, pose, box, pose, true), AnswerCheck.Overlaps(box, nowhere, box, pose, false),
            AnswerCheck.Cast(noShape, pose, default, box, pose, default, cast),
            AnswerCheck.Cast(box, pose, new Vector3(float.NaN), box, pose, default, cast),
            AnswerCheck.RayCast(box, nowhere, default, Vector3.UnitX, default),
            AnswerCheck.RayCast(
                box, pose, default, default, ConvexQuery.RayCast(box, pose, default, Vector3.UnitX)),
        ];
        for (int i = 0; i < checks.Length; i++)
            Assert.True(checks[i].Status == CheckStatus.Open, $"check {i}: {checks[i]}");
    }

    [Fact]
    public void NothingIsAllocated()
    {
        TestPair[] pairs = [.. Enumerable.Range(0, 50).Select(i => Generators.Pair((ulong)i, Generators.AllKinds))];
        long bytes = Allocation.Least(() =>
        {
            foreach (TestPair p in pairs)
            {
                (ConvexShape a, ConvexShape b) = (p.A.Shape, p.B.Shape);
                AnswerCheck.Distance(a, p.PoseA, b, p.PoseB, p.Distance());
                AnswerCheck.SignedDistance(a, p.PoseA, b, p.PoseB, p.SignedDistance());
                AnswerCheck.Overlaps(a, p.PoseA, b, p.PoseB, false);
                AnswerCheck.Cast(
                    a, p.PoseA, default, b, p.PoseB, Vector3.One,
                    ConvexQuery.Cast(a, p.PoseA, default, b, p.PoseB, Vector3.One));
            }
        });
        Assert.Equal(0, bytes);
    }

    [Fact]
    public void AnAnswerReadsWell() => Assert.Equal(
        "Proved, from 1 to 1.5", new CheckedAnswer(CheckStatus.Proved, 1, 1.5).ToString());

    /// <summary>The file's answers have 20 digits, a double 16; of an overlap the bounds hold the signed
    /// distance.</summary>
    private static bool Holds(in CheckedAnswer check, HardCase c)
    {
        double truth = c.Overlap ? -c.Depth : c.Distance, rounding = 2.3e-16 * Math.Abs(truth);
        return check.LowerBound <= truth + rounding && check.UpperBound >= truth - rounding;
    }

    /// <summary>A shape as a user might write it.</summary>
    private readonly struct Own(ConvexShape inner) : ISupportMap
    {
        public Double3 Center => inner.Center;

        public double Margin => inner.Margin;

        public double BoundingRadius => 1e6 * inner.BoundingRadius;

        public int Support(in Double3 direction, out Double3 point) => inner.Support(direction, out point);

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point) => inner.TryGetVertex(id, out point);
    }
}
