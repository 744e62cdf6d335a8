using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Gjk.Core.Tests.Api;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Queries;

/// <summary>
/// Contract 7: the same bits for one target framework, SIMD on or off, debug or release, serial or parallel.
/// </summary>
public class GoldenHashTests
{
    /// <summary>The families up to this one have a golden hash of their own.</summary>
    private const string LastOldFamily = "dense";

    [Fact]
    public void TheCasesKeepTheirBits()
    {
        var all = new ResultHash();
        string byFamily = "";
        foreach (string family in CaseFamily.Names)
        {
            var own = new ResultHash();
            foreach (HardCase c in CaseFamily.Load(family).Cases)
            {
                DistanceResult r = c.Pair.Distance();
                all.Add(c.IndexA, c.IndexB, r);
                own.Add(c.IndexA, c.IndexB, r);
            }

            byFamily += $" {family} {own}";
            if (family == LastOldFamily) AssertGolden("cases", all, byFamily);
        }

        AssertGolden("allCases", all, byFamily);
    }

    [Fact]
    public void TheDepthsKeepTheirBits()
    {
        var hash = new ResultHash();
        foreach (string family in CaseFamily.Names.Concat(CaseFamily.DepthNames))
            foreach (HardCase c in CaseFamily.Load(family).Cases)
                hash.Add(c.IndexA, c.IndexB, c.Pair.SignedDistance());
        AssertGolden("depths", hash);
    }

    [Fact]
    public void TheContactsKeepTheirBits()
    {
        var hash = new ResultHash();
        var manifold = default(ContactManifold);
        foreach (string family in CaseFamily.Names.Concat(CaseFamily.DepthNames))
        {
            foreach (TestPair p in CaseFamily.Load(family).Cases.Select(c => c.Pair))
            {
                float gap = 0.01f * (float)Math.Max(p.A.Reach, p.B.Reach);
                ConvexQuery.Contacts(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, gap, ref manifold);
                hash.Add(manifold);
            }
        }

        AssertGolden("contacts", hash);
    }

    [Fact]
    public void RandomPairsKeepTheirBits()
    {
        var hash = new ResultHash();
        for (int i = 0; i < 2000; i++)
            hash.Add(i, i, Generators.Pair((ulong)i, [.. Generators.PolytopeKinds, "bigHull"]).Distance());
        AssertGolden("random", hash);
    }

    [Fact]
    public void ParallelGivesTheSameBitsAsSerial()
    {
        HardCase[] cases = [.. CaseFamily.Load("touch").Cases];
        var parallel = new DistanceResult[cases.Length];
        Parallel.For(0, cases.Length, i => parallel[i] = cases[i].Pair.Distance());
        for (int i = 0; i < cases.Length; i++)
            Assert.Equal(ResultHash.Of(0, 0, cases[i].Pair.Distance()), ResultHash.Of(0, 0, parallel[i]));
    }

    private static void AssertGolden(string name, ResultHash hash, string parts = "")
    {
        string actual = hash.ToString();
        string? golden = GoldenHashes.Of(BuildUnderTest.TargetFramework).GetValueOrDefault(name);
        Assert.True(
            golden == actual,
            $"{BuildUnderTest.TargetFramework}, {name}: the bits are {actual}, golden is {golden ?? "missing"}. "
            + $"If the change is meant, put it into GoldenHashes.cs.{parts}");
    }
}
