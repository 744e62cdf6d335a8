using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.HalfSpaces;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Half-spaces in <c>fuzz</c>: they are drawn beside every kind of shape, wrong answers are noticed, and what
/// is found is shrunk to a record that can be asked again.</summary>
public sealed class FuzzHalfSpaceTests
{
    private const string Low = "gjk1 halfspace 0 1 0 0 0 0 0 0 0 @ 0 0 0 1 0 0 0 box 1 2 3 @ 0 0 0 1 0 ";

    [Fact]
    public void EveryFamilyIsDrawnAndKeepsThePromises()
    {
        const int Count = 1200;
        var families = new HashSet<string>();
        int overlaps = 0;
        for (long i = 0; i < Count; i++)
        {
            HalfSpacePair pair = HalfSpaceFamilies.Draw(1, i, out string family);
            families.Add(family);
            overlaps += pair.Signed.IsOverlapping ? 1 : 0;
            foreach (Promise<HalfSpacePair> promise in HalfSpacePromises.All)
                Assert.True(promise.Broken(pair) is null, $"{i}, {family}, {promise.Name}: {promise.Broken(pair)}");
        }

        Assert.Equal(HalfSpaceFamilies.Names.Count, families.Count);
        Assert.InRange(overlaps, 0.3 * Count, 0.7 * Count);
    }

    /// <summary>Told the answer of a box elsewhere, or none.</summary>
    [Theory]
    [InlineData("5.000001 0")]
    [InlineData("1 0")]
    [InlineData("")]
    public void WrongAnswersAreNoticed(string elsewhere)
    {
        HalfSpacePair right = Read(Low + "5 0");
        Assert.Equal(3, right.Gap);
        Assert.All(HalfSpacePromises.All, p => Assert.Null(p.Broken(right)));
        HalfSpacePair told = right.Answered(elsewhere.Length > 0 ? Read(Low + elsewhere).Signed : default);
        string[] names = [.. HalfSpacePromises.All.Where(p => p.Broken(told) is not null).Select(p => p.Name)];
        Assert.Equal([.. HalfSpacePromises.All.Take(3).Select(p => p.Name)], names);
    }

    /// <summary>A triangle 5e-15 above the plane, less than rounding leaves open: the signed distance's lower bound is
    /// below the plane, the distance's is 0.</summary>
    [Fact]
    public void ADistanceIsNeverBoundedFromBelowByLessThanNothing()
    {
        HalfSpacePair pair = Read(
            "gjk1 halfspace 0 1 0 0 0 0 0 0 0 @ 0 0 0 1 0 0 0 triangle 0 0.80000000000000004 0 0 0 0 1 0"
            + " -0.90000000000000002 @ 0 0 0 1 0 4.99999991E-15 -0.100000001");
        Assert.InRange(pair.Signed.LowerBound, float.MinValue, -float.Epsilon);
        Assert.All(HalfSpacePromises.All, p => Assert.Null(p.Broken(pair)));
    }

    /// <summary>Sizes and distances that ask for a place beyond all floats.</summary>
    [Theory]
    [InlineData(318_201)]
    [InlineData(323_571)]
    [InlineData(377_898)]
    public void APlaceBeyondAllFloatsIsDrawnWithinThem(long index)
    {
        HalfSpacePair pair = HalfSpaceFamilies.Draw(4015, index, out _);
        Assert.All(HalfSpacePromises.All, p => Assert.Null(p.Broken(pair)));
    }

    [Fact]
    public void WhatIsFoundIsShrunkToARecord()
    {
        var far = new Promise<HalfSpacePair>("nothing is far", p => p.Signed.Distance > 0.125f ? "it is" : null);
        HalfSpacePair pair = HalfSpaceFamilies.Draw(3, 0, out _);
        for (long i = 1; pair.Other.Hull is null || far.Broken(pair) is null; i++)
            pair = HalfSpaceFamilies.Draw(3, i, out _);
        HalfSpacePair shrunk = HalfSpacePair.Shrink(pair, far, default);
        Assert.NotNull(far.Broken(shrunk));
        Assert.Equal((ShapeKind.HalfSpace, ShapeKind.Point), (shrunk.Plane.Kind, shrunk.Other.Kind));
        Assert.True(shrunk.Text.Length < 90, shrunk.Text);
        Assert.True(QueryRecord.TryParse(shrunk.Text, out QueryRecord record, out _));
        DistanceResult again = ConvexQuery.SignedDistance(record.A, record.PoseA, record.B, record.PoseB);
        Assert.Equal(shrunk.Signed.Distance, again.Distance);
    }

    [Fact]
    public void OtherPairsAreNoneOfTheirs()
    {
        Assert.False(FuzzPair.TryParse(Low + "5 0", out _));
        Assert.Null(HalfSpacePair.Read(Low.Replace("halfspace 0 1 0 0 0 0 0 0 0", "point 0") + "5 0"));
        var few = new MixedPairs(new Found("many"), new Found("few"), place: 3);
        Assert.Equal(
            [3L, 11, 19],
            Enumerable.Range(0, 24).Select(i => (long)i).Where(i => few.Try(1, i, default)!.Family == "few"));
    }

    private static HalfSpacePair Read(string text) =>
        HalfSpacePair.Read(text) ?? throw new ArgumentException(text, nameof(text));

    private sealed class Found(string family) : IPairSource
    {
        public BrokenPromise Try(ulong seed, long index, CancellationToken cancel) =>
            new(index, family, "", "", "");
    }
}
