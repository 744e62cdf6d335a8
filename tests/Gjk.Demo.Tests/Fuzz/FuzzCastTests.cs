using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Tests that <c>fuzz</c> notices wrong casts: each lie breaks the promise that is about it.</summary>
public sealed class FuzzCastTests
{
    private const string First = "first touch", Begins = "begins", Limit = "largest", Mirror = "mirrors the cast";

    private const string Shared = "share", Warm = "warm start does not change a cast";

    private static readonly ConvexShape Cube = ConvexShape.Box(new Vector3(0.5f));

    /// <summary>A little turned and aside, so that a corner of B meets a face of A.</summary>
    private static readonly RigidPose Right = new(
        Quaternion.Normalize(new Quaternion(0.1f, 0.2f, 0.3f, 1)), new Vector3(3, 0.25f, 0.125f));

    /// <summary>Both move, and meet after about 0.4 of the way.</summary>
    private static readonly PairMotion Meeting = new(new Vector3(1, 0.25f, 0), new Vector3(-4, 0, 0.5f));

    /// <summary>The cast is replaced in turn by those of other pairs, motions and limits.</summary>
    [Theory]
    [InlineData("later", First + "|" + Mirror + "|" + Shared + "|" + Warm)]
    [InlineData("earlier", First + "|" + Mirror + "|" + Shared + "|" + Warm)]
    [InlineData("a part in a million later", First + "|" + Limit + "|" + Shared)]
    [InlineData("a part in a million earlier", First + "|" + Limit + "|" + Shared)]
    [InlineData("mirrored", First + "|" + Limit + "|" + Shared)]
    [InlineData("turned", First)]
    [InlineData("missed", First + "|" + Mirror + "|" + Warm)]
    [InlineData("inside", First + "|" + Begins + "|" + Mirror)]
    [InlineData("invalid", First + "|" + Mirror)]
    public void WrongCastsAreNoticed(string lie, string names)
    {
        FuzzPair pair = new FuzzPair(Cube, RigidPose.Identity, Cube, Right).Moving(Meeting, Told(lie));
        string[] broken = [.. AllPromises.Make().Where(p => p.Broken(pair) is not null).Select(p => p.Name)];
        foreach (string name in names.Split('|'))
            Assert.Contains(broken, b => b.Contains(name, StringComparison.Ordinal));
    }

    [Fact]
    public void RightCastsBreakNothing()
    {
        FuzzPair pair = new FuzzPair(Cube, RigidPose.Identity, Cube, Right).Moving(Meeting);
        Assert.Equal(CastStatus.Hit, pair.Cast.Status);
        Assert.InRange(pair.Cast.Fraction, 0.3f, 0.5f);
        foreach (Promise<FuzzPair> promise in AllPromises.Make()) Assert.Null(promise.Broken(pair));
    }

    /// <summary>A hit of a pair that passes by, a thousandth of its size apart.</summary>
    [Fact]
    public void AHitThatIsNoneIsNoticed()
    {
        var above = new RigidPose(new Vector3(3, 1.001f, 0));
        var motion = new PairMotion(Vector3.Zero, new Vector3(-6, 0, 0));
        CastResult hit = ConvexQuery.Cast(
            Cube, RigidPose.Identity, default, Cube, new RigidPose(new Vector3(3, 0.999f, 0)), motion.B);
        FuzzPair pair = new FuzzPair(Cube, RigidPose.Identity, Cube, above).Moving(motion, hit);
        Assert.Contains("a plane leaves", CastProof.Broken(pair), StringComparison.Ordinal);
        Assert.Null(CastProof.Broken(pair.Moving(motion)));
        Assert.Equal(CastStatus.Miss, pair.Moving(motion).Cast.Status);
    }

    /// <summary>A gap that is the distance at the start, nothing at the touch, and convex between.</summary>
    [Fact]
    public void TheLeastDistanceIsFound()
    {
        var motion = new PairMotion(Vector3.Zero, new Vector3(-6, 0, 0));
        var above = new RigidPose(new Vector3(3, 1.25f, 0));
        FuzzSweep sweep = new FuzzPair(Cube, RigidPose.Identity, Cube, above).Moving(motion).Sweep;
        Moment least = sweep.Least(0, 1);
        Assert.Equal((0.25, 0.25), (Math.Round(least.AtLeast, 12), Math.Round(least.AtMost, 12)));
        Assert.Equal(1, least.Normal.Y, 1e-9);
        Assert.Equal(Math.Sqrt(2 * 2 + 0.25 * 0.25), sweep.At(0).AtLeast, 1e-12);

        var level = new RigidPose(new Vector3(3, 0.5f, 0));
        Moment through = new FuzzPair(Cube, RigidPose.Identity, Cube, level).Moving(motion).Sweep.Least(0, 1);
        Assert.True(through.AtLeast < -0.4 && through.AtMost < 1e-12, $"{through}");
    }

    /// <summary>The line that is reported holds the motion, and shrinking keeps what it needs.</summary>
    [Fact]
    public void ThePairsLineKeepsTheMotion()
    {
        FuzzPair pair = new FuzzPair(Cube, RigidPose.Identity, Cube, Right).Moving(Meeting);
        Assert.True(FuzzPair.TryParse(pair.Text, out FuzzPair? again), pair.Text);
        Assert.Equal((pair.Text, Meeting), (again.Text, again.Motion));
        Assert.True(QueryRecord.TryParse(pair.Text, out QueryRecord record, out string? reason), reason);
        Assert.Equal(pair.Cast.Fraction, record.Cast().Fraction);

        FuzzPair shrunk = Shrinker.Shrink(pair, NothingMeets, default);
        Assert.Equal(CastStatus.Hit, shrunk.Cast.Status);
        Assert.Equal(ShapeKind.Point, shrunk.A.Kind);
        Assert.True(shrunk.Text.Length < 80, shrunk.Text);
        string turning = new QueryRecord(
            Cube, new RigidMotion(Right, default, Vector3.UnitX), Cube, new RigidMotion(Right, default)).ToString();
        Assert.False(FuzzPair.TryParse(turning, out _));
    }

    /// <summary>The search meets casts of every kind, or its promises would hold for want of pairs.</summary>
    [Fact]
    public void EveryKindOfCastIsMet()
    {
        const int Count = 2000;
        int hits = 0, misses = 0, late = 0;
        for (long i = 0; i < Count; i++)
        {
            FuzzPair pair = PairFamilies.Draw(1, i, out _);
            hits += pair.Cast.Status == CastStatus.Hit ? 1 : 0;
            misses += pair.Cast.Status == CastStatus.Miss ? 1 : 0;
            late += pair.Cast.Status == CastStatus.Hit && pair.Cast.Fraction > 0.2f ? 1 : 0;
        }

        Assert.True(
            hits > 0.1 * Count && misses > 0.1 * Count && late > 0.05 * Count,
            $"{hits} hit, {late} late, {misses} miss");
    }

    private static CastResult Told(string lie) => lie switch
    {
        "later" => From(3.01f, Meeting),
        "earlier" => From(2.99f, Meeting),
        "a part in a million later" => From(3.000006f, Meeting),
        "a part in a million earlier" => From(2.999994f, Meeting),
        "mirrored" => From(3, Meeting).Swapped,
        "turned" => ConvexQuery.Cast(
            ConvexShape.Sphere(0.5f), RigidPose.Identity, Meeting.A, Cube, Right, Meeting.B),
        "missed" => ConvexQuery.Cast(Cube, RigidPose.Identity, Meeting.A, Cube, Right, Meeting.A),
        "inside" => ConvexQuery.Cast(Cube, RigidPose.Identity, default, Cube, RigidPose.Identity, default),
        _ => ConvexQuery.Cast(Cube, RigidPose.Identity, default, default(ConvexShape), Right, default),
    };

    private static CastResult From(float x, PairMotion motion) =>
        ConvexQuery.Cast(
            Cube, RigidPose.Identity, motion.A, Cube, new RigidPose(Right.Rotation, Right.Position with { X = x }),
            motion.B);

    private static readonly Promise<FuzzPair> NothingMeets = new(
        "nothing meets", pair => pair.Cast.Status == CastStatus.Hit ? "it does" : null);
}
