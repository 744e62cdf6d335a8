using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Tests that <c>fuzz</c> notices wrong depths: each lie breaks the promise that is about it.</summary>
public sealed class FuzzDepthTests
{
    private const string Agrees = "what is apart", Touches = "only touch", Shortest = "no way out is shorter";

    private const string Mirrors = "mirrors";

    private static readonly ConvexShape Cube = Block(new Vector3(-0.5f), new Vector3(0.5f));

    /// <summary>A quarter deep along x, 0.75 along y and 0.875 along z.</summary>
    private static readonly RigidPose Inside = new(new Vector3(0.75f, 0.25f, 0.125f));

    private static readonly RigidPose Apart = new(new Vector3(2, 0.25f, 0.125f));

    /// <summary>Curved shapes whose deepest point lay outside of A by more than is promised.</summary>
    [Theory]
    [InlineData(
        "gjk1 cone 0.089999999999999997 0.080000000000000002 0 @ 0 0 0 1 0 0 0 cylinder 0.40000000000000002 "
        + "0.059999999999999998 0 @ 0.629999995 0.583100021 -0.283300012 -0.425999999 -0.207599998 0.376100004 "
        + "-0.134299994")]
    [InlineData(
        "gjk1 cone 0.59999999999999998 0.69999999999999996 0 @ 0.893000007 0.304399997 0.314300001 "
        + "0.109999999 0 0 0 cone 0.25219999999999998 0.52370000000000005 0 @ -0.1611 -0.75819999 0.0700000003 "
        + "0.627600014 0.450100005 -0.331400007 0.30004099")]
    public void DeepestPointsOfConesLieOnThem(string record)
    {
        Assert.True(FuzzPair.TryParse(record, out FuzzPair? pair));
        Assert.Null(TheWayOutEndsTouching.Broken(pair));
    }

    /// <summary>The signed distance is replaced in turn by that of pairs a little further in and further out, by one
    /// whose distance alone is rounded the wrong way, by that of the swapped pair, by a way out that is one but not the
    /// shortest, by the plain distance, which has no normal, by that of a pair that is apart, and by nothing.</summary>
    [Theory]
    [InlineData("deeper", Touches + "|" + Shortest + "|" + Mirrors)]
    [InlineData("shallower", Touches + "|" + Shortest + "|" + Mirrors)]
    [InlineData("a part in a million deeper", Touches + "|" + Shortest + "|" + Mirrors)]
    [InlineData("a part in a million shallower", Touches + "|" + Shortest + "|" + Mirrors)]
    [InlineData("mirrored", Touches)]
    [InlineData("longer", Shortest + "|" + Mirrors)]
    [InlineData("plain", Touches + "|" + Shortest + "|" + Mirrors)]
    [InlineData("apart", Agrees + "|" + Mirrors)]
    [InlineData("invalid", Agrees + "|" + Mirrors)]
    public void WrongDepthsAreNoticed(string lie, string names)
    {
        DistanceResult right = ConvexQuery.Distance(Cube, RigidPose.Identity, Cube, Inside);
        var pair = new FuzzPair(Cube, RigidPose.Identity, Cube, Inside, right, Told(lie));
        string[] broken = [.. AllPromises.Make().Where(p => p.Broken(pair) is not null).Select(p => p.Name)];
        // Casts and the check look at depths, too, and have tests of their own.
        broken = [.. broken.Where(b => !b.Contains("cast", StringComparison.Ordinal) && !b.Contains("check"))];
        Assert.Equal(names.Split('|').Length, broken.Length);
        foreach (string name in names.Split('|'))
            Assert.Contains(broken, b => b.Contains(name, StringComparison.Ordinal));
    }

    /// <summary>Apart, other bits than those of the distance are wrong, though they are within the accuracy.</summary>
    [Fact]
    public void ApartEveryBitCounts()
    {
        DistanceResult right = ConvexQuery.Distance(Cube, RigidPose.Identity, Cube, Apart);
        DistanceResult other = ConvexQuery.SignedDistance(
            Cube, RigidPose.Identity, Cube, new RigidPose(Apart.Position + new Vector3(0, 0, 1e-7f)));
        Assert.Equal(right.Distance, other.Distance);
        var pair = new FuzzPair(Cube, RigidPose.Identity, Cube, Apart, right, other);
        Assert.NotNull(TheSignedDistanceIsTheDistance.Broken(pair));
        Assert.Null(
            TheSignedDistanceIsTheDistance.Broken(new FuzzPair(Cube, RigidPose.Identity, Cube, Apart)));
    }

    /// <summary>The search for the depth of two ellipsoids about one centre outgrows its room. That is allowed, and
    /// wrong for cubes.</summary>
    [Fact]
    public void OnlyCurvedShapesAndLargeHullsMayHaveBoundsAlone()
    {
        ConvexShape round = ConvexShape.Ellipsoid(new Vector3(1, 0.999f, 0.998f));
        var pair = new FuzzPair(round, RigidPose.Identity, round, RigidPose.Identity);
        Assert.Equal(GjkStatus.IterationLimit, pair.Signed.Status);
        foreach (Promise<FuzzPair> promise in AllPromises.Make()) Assert.Null(promise.Broken(pair));

        Func<FuzzPair, string?> broken = TheSignedDistanceIsTheDistance.Broken;
        Assert.Contains("IterationLimit", broken(Told(Cube, pair.Signed)), StringComparison.Ordinal);
        ConvexShape small = ConvexShape.Sphere(0.25f).Scaled(new Vector3(1, 1, 0.5f));
        Assert.Contains("a plane leaves", broken(Told(small, pair.Signed)), StringComparison.Ordinal);
    }

    /// <summary>Two capsules whose segments are apart: the margins alone overlap, and the depth is known.</summary>
    [Fact]
    public void ADepthOfMarginsIsHeldToTheExactOne()
    {
        ConvexShape capsule = ConvexShape.Capsule(0.5f, 1);
        RigidPose near = new(new Vector3(0.75f, 0, 0)), nearer = new(new Vector3(0.7499999f, 0, 0));
        var right = new FuzzPair(capsule, RigidPose.Identity, capsule, near);
        Assert.Equal(-0.25, right.Truth.SignedByMargins());
        Assert.Null(NoWayOutIsShorter.Broken(right));
        DistanceResult wrong = ConvexQuery.SignedDistance(capsule, RigidPose.Identity, capsule, nearer);
        var told = new FuzzPair(capsule, RigidPose.Identity, capsule, near, right.Answer, wrong);
        Assert.Contains("truly -0.25", NoWayOutIsShorter.Broken(told), StringComparison.Ordinal);
    }

    /// <summary>The search meets depths of every kind, or its promises would hold for want of pairs.</summary>
    [Fact]
    public void ManyPairsHaveADepth()
    {
        int deep = 0, margins = 0;
        for (long i = 0; i < 2000; i++)
        {
            FuzzPair pair = PairFamilies.Draw(1, i, out _);
            if (!pair.Signed.IsOverlapping || pair.Signed.Distance == 0) continue;
            deep++;
            margins += pair.Truth.SignedByMargins() is null ? 0 : 1;
        }

        Assert.InRange(deep, 400, 1200);
        Assert.InRange(margins, 10, deep / 2);
    }

    private static FuzzPair Told(in ConvexShape shape, in DistanceResult signed) =>
        new(
            shape, RigidPose.Identity, shape, RigidPose.Identity,
            ConvexQuery.Distance(shape, RigidPose.Identity, shape, RigidPose.Identity), signed);

    private static DistanceResult Told(string lie) => lie switch
    {
        "deeper" => Moved(-1e-3f),
        "shallower" => Moved(1e-3f),
        "a part in a million deeper" => Moved(-1e-6f),
        "a part in a million shallower" => Moved(1e-6f),
        "mirrored" => ConvexQuery.SignedDistance(Cube, RigidPose.Identity, Cube, Inside).Swapped,
        "longer" => AlongY(),
        "plain" => ConvexQuery.Distance(Cube, RigidPose.Identity, Cube, Inside),
        "apart" => ConvexQuery.SignedDistance(Cube, RigidPose.Identity, Cube, Apart),
        _ => ConvexQuery.SignedDistance(Cube, RigidPose.Identity, default(ConvexShape), Inside),
    };

    private static DistanceResult Moved(float x) =>
        ConvexQuery.SignedDistance(
            Cube, RigidPose.Identity, Cube, new RigidPose(Inside.Position + new Vector3(x, 0, 0)));

    /// <summary>The way out along y, of bars about the overlap that are as high as the cubes and too long to leave
    /// along x.</summary>
    private static DistanceResult AlongY()
    {
        ConvexShape barA = Block(new Vector3(-4, -0.5f, -0.5f), new Vector3(4.75f, 0.5f, 0.5f));
        ConvexShape barB = Block(new Vector3(-4.75f, -0.5f, -0.5f), new Vector3(4, 0.5f, 0.5f));
        return ConvexQuery.SignedDistance(barA, RigidPose.Identity, barB, Inside);
    }

    private static ConvexShape Block(Vector3 low, Vector3 high) => ConvexShape.Mesh(
        [
            .. Enumerable.Range(0, 8).Select(i => new Vector3(
                (i & 1) == 0 ? low.X : high.X, (i & 2) == 0 ? low.Y : high.Y, (i & 4) == 0 ? low.Z : high.Z)),
        ]);
}
