using Gjk.Core.Tests.Support;
using Gjk.Demo.Scenes;
using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Concave;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Tests the search for wrong answers about shapes that are not convex: pairs are repeatable, all answers
/// occur, wrong ones are noticed, and what is found is shrunk to a scene file.</summary>
public sealed class FuzzConcaveTests
{
    private const int Count = 250;

    [Fact]
    public void EveryFamilyIsDrawnAndAllAnswersOccur()
    {
        var families = new HashSet<string>();
        int overlaps = 0, inside = 0, exact = 0, hits = 0;
        for (long i = 0; i < Count; i++)
        {
            ConcavePair pair = ConcaveFamilies.Draw(3, i, out string family);
            families.Add(family);
            overlaps += pair.Answer.IsOverlapping ? 1 : 0;
            inside += pair.HoldsPiece ? 1 : 0;
            exact += pair.RawA.CornersOf(0) is not null && pair.RawB.CornersOf(0) is not null ? 1 : 0;
            CastHit cast = ConcaveQuery.Cast(
                pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, pair.Scratch);
            hits += cast.Status == CastStatus.Hit ? 1 : 0;
            Assert.Equal(pair.Text, ConcaveFamilies.Draw(3, i, out _).Text);
        }

        Assert.Equal(ConcaveFamilies.Names.Count, families.Count);
        Assert.InRange(overlaps, 0.25 * Count, 0.7 * Count);
        Assert.InRange(inside, 1, 0.2 * Count);
        Assert.InRange(exact, 0.5 * Count, Count);
        Assert.InRange(hits, 0.1 * Count, 0.6 * Count);
    }

    /// <summary>A mesh without the triangle that is nearest, as a tree that lost it would answer.</summary>
    [Fact]
    public void ALostTriangleIsNoticed()
    {
        int lost = 0, seen = 0, count = Budget.Whole(15);
        for (long i = 0; lost < count; i++)
        {
            ConcavePair pair = ConcaveFamilies.Draw(5, i, out _);
            bool isClear = pair.RawA is { Triangles.Count: > 1, IsSolid: false } && pair.Answer.PartA >= 0
                && pair.All.Count(one => one.Distance == pair.Least) == 1;
            if (!isClear) continue;
            lost++;
            AnyShape less = pair.RawA.Without(pair.Answer.PartA, 1).Build();
            var told = new ConcavePair(pair.RawA, pair.PoseA, pair.RawB, pair.PoseB, pair.Motion, 1, less);
            if (LeastOfParts.Distance(told) is not null) seen++;
        }

        Assert.Equal(lost, seen);
    }

    /// <summary>A shape that lies elsewhere by next to nothing breaks every promise that reads raw numbers.</summary>
    [Theory]
    [InlineData("least of all parts")]
    [InlineData("largest distance|named parts")]
    [InlineData("within a distance")]
    [InlineData("ray meets")]
    [InlineData("cast finds")]
    [InlineData("a point is")]
    [InlineData("contacts are")]
    [InlineData("moved vertices")]
    public void WrongAnswersAreNoticed(string name)
    {
        Promise<ConcavePair> promise = ConcavePromises.All.First(
            p => name.Split('|').Any(n => p.Name.Contains(n, StringComparison.Ordinal)));
        RawShape grid = RawShape.Surface(Surfaces.Grid(3));
        RawShape box = RawShape.Convex(new RawPart(ShapeKind.Box, new Vector3(0.25f)));
        RigidPose at = new(new Vector3(0.125f, 0.3f, 0.25f));
        var motion = new PairMotion(default, -Vector3.UnitY);
        AnyShape moved = grid.Moved(p => p + new Vector3(0, 1e-3f, 0)).Build();
        bool isNoticed = false;
        for (ulong seed = 0; seed < 8; seed++)
        {
            Assert.Null(promise.Broken(new ConcavePair(grid, RigidPose.Identity, box, at, motion, seed)));
            var told = new ConcavePair(grid, RigidPose.Identity, box, at, motion, seed, moved);
            isNoticed |= promise.Broken(told) is not null;
        }

        Assert.True(isNoticed);
    }

    /// <summary>Two cylinders of a compound cross a triangle: of the one's two points the deeper lies in the other,
    /// which has it.</summary>
    [Fact]
    public void APointOfAPartMayBeLeftToAnother()
    {
        ConcavePair pair = ConcaveFamilies.Draw(4016, 452_551, out _);
        Assert.All(ConcavePromises.All, promise => Assert.Null(promise.Broken(pair)));
    }

    [Fact]
    public void TheOraclesWindingIsThatOfABoxAndATorus()
    {
        var random = new Rng(4);
        RawShape box = RawShape.Surface(Surfaces.Box(Vector3.One)), torus = RawShape.Surface(Surfaces.Torus(24, 12));
        for (int i = 0; i < 200; i++)
        {
            RigidPose pose = new(Rotations.Any(random), random.Vector(3));
            Vector3 p = random.Vector(1.5);
            double ring = Math.Sqrt((double)p.X * p.X + (double)p.Z * p.Z) - 1;
            double depth = 0.35 - Math.Sqrt(ring * ring + (double)p.Y * p.Y);
            bool isInBox = Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))) < 1;
            Assert.Equal(isInBox ? 1 : 0, Math.Abs(ExactWinding.About(box.AllCorners(), pose, p, pose, random)!.Value));
            if (Math.Abs(depth) < 0.05) continue;
            Assert.Equal(
                depth > 0 ? 1 : 0, Math.Abs(ExactWinding.About(torus.AllCorners(), pose, p, pose, random)!.Value));
        }
    }

    /// <summary>The line that is printed is a scene file with the same shapes, poses and answer.</summary>
    [Fact]
    public void ThePairsLineIsAScene()
    {
        using var directory = new TempDirectory();
        for (long i = 0; i < 60; i++)
        {
            ConcavePair pair = ConcaveFamilies.Draw(8, i, out _);
            if (pair.PairCount > 2000) continue;
            Scene scene = SceneFile.Load(directory.Write("s.json", pair.Text), CancellationToken.None);
            SceneObject a = scene.Objects[0], b = scene.Objects[1];
            PairDistance found = ConcaveQuery.Distance(a.Any, a.Pose, b.Any, b.Pose, pair.Scratch);
            Assert.Equal(pair.Answer.ToString(), found.ToString());
            Assert.Equal((pair.Motion.A, pair.Motion.B), (a.Velocity, b.Velocity));
        }
    }

    [Fact]
    public void APairIsShrunkToWhatThePromiseIsAbout()
    {
        var far = new Promise<ConcavePair>("nothing is far", pair => pair.Answer.Distance > 0.125f ? "it is" : null);
        long i = 0;
        ConcavePair pair = ConcaveFamilies.Draw(2, i, out _);
        while (far.Broken(pair) is null || pair.PairCount < 500) pair = ConcaveFamilies.Draw(2, ++i, out _);
        ConcavePair shrunk = ConcaveShrinker.Shrink(pair, far, default);
        Assert.NotNull(far.Broken(shrunk));
        Assert.Equal((1, default(PairMotion)), (shrunk.PairCount, shrunk.Motion));
    }

    [Fact]
    public void TheCommandTriesThemAlone()
    {
        DemoRun run = DemoRun.Of("fuzz", "--concave", "--count", "40", "--seed", "5");
        run.AssertDone();
        Assert.Matches(@"^40 pairs tried in \d+\.\d s, \d+ pairs per second, seed 5: no promise broken\n$", run.Out);
        DemoRun.Of("fuzz", "--certificate", "--pairs", "10", "--concave").AssertRefused("exclude each other");
    }
}
