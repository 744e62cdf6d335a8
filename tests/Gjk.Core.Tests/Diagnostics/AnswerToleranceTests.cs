namespace Gjk.Core.Tests.Diagnostics;

/// <summary>Lies beside the tolerance that is to notice them, on cubes face to face and cylinders side by side, where
/// they show in full: what is a little too much is refuted, and a little less is not.</summary>
public class AnswerToleranceTests
{
    private static readonly ConvexShape Cube = ConvexShape.Box(Vector3.One), Roll = ConvexShape.Cylinder(1, 1);

    [Theory]
    [InlineData("ratio", 3e-7, CheckStatus.Refuted)]
    [InlineData("ratio", 1e-7, CheckStatus.Proved)]
    [InlineData("length", 1e-12, CheckStatus.Refuted)]
    [InlineData("length", 2e-13, CheckStatus.Proved)]
    [InlineData("tilt", 2e-6, CheckStatus.Refuted)]
    [InlineData("tilt", 4e-7, CheckStatus.Proved)]
    [InlineData("unit", 3e-6, CheckStatus.Refuted)]
    [InlineData("unit", 5e-7, CheckStatus.Proved)]
    [InlineData("point", 2e-6, CheckStatus.Refuted)]
    [InlineData("point", 5e-7, CheckStatus.Proved)]
    [InlineData("curved", 1.5e-5, CheckStatus.Refuted)]
    [InlineData("curved", 4e-6, CheckStatus.Proved)]
    public void ADistance(string lie, double size, CheckStatus status)
    {
        // The gap is a power of two, so that every coordinate is a float.
        float gap = lie is "length" ? 1f / (1 << 22) : 0.5f, little = (float)size;
        ConvexShape shape = lie is "curved" ? Roll : Cube;
        Vector3 onA = Vector3.UnitX, onB = new(1 + gap, 0, 0), n = Vector3.UnitX;
        float d = lie is "ratio" ? gap * (1 + little) : lie is "length" or "curved" ? gap + little : gap;
        if (lie is "tilt") n.Y = little;
        if (lie is "unit") n.X += little;
        if (lie is "point") onA.X += little;
        var told = new DistanceResult(GjkStatus.Separated, d, 0, onA, onB, n, onA, -Vector3.UnitX, 1);
        CheckedAnswer check = AnswerCheck.Distance(
            shape, RigidPose.Identity, shape, new RigidPose(new Vector3(2 + gap, 0, 0)), told, double.NaN);
        if (lie is "ratio" or "length" or "curved" or "point") told = default;
        Assert.True(Loosely(check.Status) == status, $"{check}, {told}");
    }

    /// <summary>A bound of 0 is far from the distance, so what holds is open.</summary>
    private static CheckStatus Loosely(CheckStatus status) =>
        status == CheckStatus.Open ? CheckStatus.Proved : status;

    /// <summary>Cubes and cylinders a gap apart, of either sign, said to overlap or not.</summary>
    [Theory]
    [InlineData(false, true, 1e-12, CheckStatus.Refuted)]
    [InlineData(false, true, 2e-13, CheckStatus.Open)]
    [InlineData(true, true, 1.5e-8, CheckStatus.Refuted)]
    [InlineData(true, true, 4e-9, CheckStatus.Open)]
    [InlineData(false, true, 0, CheckStatus.Proved)]
    [InlineData(true, true, 0, CheckStatus.Proved)]
    [InlineData(false, false, -6e-8, CheckStatus.Refuted)]
    [InlineData(false, false, -2e-8, CheckStatus.Open)]
    [InlineData(true, false, -6e-5, CheckStatus.Refuted)]
    [InlineData(true, false, -2e-5, CheckStatus.Open)]
    public void AFlag(bool isCurved, bool overlaps, double gap, CheckStatus status)
    {
        ConvexShape shape = isCurved ? Roll : Cube;
        var left = new RigidPose(new Vector3((float)-gap, 0, 0));
        CheckedAnswer check = AnswerCheck.Overlaps(shape, left, shape, new RigidPose(new(2, 0, 0)), overlaps);
        Assert.True(check.Status == status, check.ToString());
    }

    /// <summary>B goes three units towards A, and meets it after half a unit.</summary>
    [Theory]
    [InlineData("fraction", 2e-6, CheckStatus.Refuted)]
    [InlineData("fraction", -2e-6, CheckStatus.Refuted)]
    [InlineData("fraction", 5e-7, CheckStatus.Proved)]
    [InlineData("fraction", -5e-7, CheckStatus.Proved)]
    [InlineData("point", 7e-4, CheckStatus.Refuted)]
    [InlineData("point", 2e-4, CheckStatus.Proved)]
    public void AHit(string lie, double size, CheckStatus status)
    {
        ConvexShape shape = lie is "point" ? Roll : Cube;
        float f = lie is "fraction" ? (float)((0.5 + size) / 3) : 0.5f / 3, off = lie is "point" ? (float)size : 0;
        var told = new CastResult(CastStatus.Hit, f, new Vector3(1 + off, 0, 0), Vector3.UnitX, 1);
        CheckedAnswer check = AnswerCheck.Cast(
            shape, RigidPose.Identity, default, shape, new RigidPose(new Vector3(2.5f, 0, 0)), new Vector3(-3, 0, 0),
            told);
        Assert.True(check.Status == status, check.ToString());
    }

    /// <summary>B passes A by a gap, and is said to have touched it.</summary>
    [Theory]
    [InlineData(2e-8, CheckStatus.Refuted)]
    [InlineData(4e-9, CheckStatus.Open)]
    public void AGraze(double gap, CheckStatus status)
    {
        var left = new RigidPose(new Vector3((float)-gap, 0, 0));
        var told = new CastResult(CastStatus.Hit, 0.5f, new Vector3(1, 1, 0), Vector3.UnitX, 1);
        CheckedAnswer check = AnswerCheck.Cast(
            Cube, left, default, Cube, new RigidPose(new Vector3(2, 4, 0)), new Vector3(0, -4, 0), told);
        Assert.True(check.Status == status, check.ToString());
    }

    /// <summary>Balls of some 1e-40 whose depth is less than half the least float: they touch, and a rest
    /// misses.</summary>
    [Fact]
    public void ADepthThatNoFloatHolds()
    {
        QueryRecord q = QueryRecord.Parse(
            "gjk1 point 2.2666100000000001E-40 @ 0 0 0 1 0 0 0 point 2.8166099999999999E-41 @ 0 0 0 1 -2.1413382E-40 "
            + "-1.37536043E-40 1.29297809E-41");
        CastResult rest = ConvexQuery.Cast(q.A, q.PoseA, default, q.B, q.PoseB, default);
        Assert.Equal(CastStatus.Miss, rest.Status);
        CheckedAnswer check = AnswerCheck.Cast(q.A, q.PoseA, default, q.B, q.PoseB, default, rest);
        Assert.True(check.Status != CheckStatus.Refuted, check.ToString());
    }
}
