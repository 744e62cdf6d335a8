namespace Gjk.Core.Tests.Concave;

/// <summary>A body that begins inside a surface, a compound or a solid gets the deepest part, and of a solid the way
/// out over its outside.</summary>
public class StartInsideTests
{
    private readonly ConcaveScratch _scratch = new();

    [Theory]
    [InlineData(-0.2f, 0.45f, 0.05f)]
    [InlineData(0.2f, 0.45f, 0.05f)]
    [InlineData(-0.4f, 0.1f, 0.4f)]
    public void OnAFloorOfTrianglesTheWayOutIsUp(float x, float y, float depth)
    {
        var floor = AnyShape.Surface(new TriangleMesh(
            [new(-5, 0, -5), new(5, 0, -5), new(5, 0, 5), new(-5, 0, 5)], [0, 2, 1, 0, 3, 2]));
        CastHit start = Start(floor, ConvexShape.Sphere(0.5f), new Vector3(x, y, 0));
        AssertStart(start, Vector3.UnitY, depth);
        Assert.Equal(x < 0 ? 1 : 0, start.PartA);
    }

    /// <summary>The boxes of some thousand pairs of these meet.</summary>
    [Fact]
    public void WithoutAMotionOnlyPartsThatTouchAreAsked()
    {
        var torus = AnyShape.Solid(ConcaveShapes.Torus(16, 8, 0.4f, 0.2f));
        var at = new RigidPose(Quaternion.CreateFromYawPitchRoll(0.3f, 0.2f, 0.1f), new Vector3(0.5f, 0.1f, 0.2f));
        var pairs = new List<PairDistance>();
        Assert.True(ConcaveQuery.FindPairsWithin(torus, RigidPose.Identity, torus, at, 0, _scratch, pairs));
        CastHit start = ConcaveQuery.Cast(
            torus, RigidPose.Identity, Vector3.UnitX, torus, at, Vector3.UnitX, _scratch);
        Assert.Equal(CastStatus.OverlappingAtStart, start.Status);
        Assert.Equal(pairs.Count, _scratch.CastSearch.QueryCount);
    }

    [Fact]
    public void OfFlushBoxesAndSlabsTheDeepestCounts()
    {
        var box = ConvexShape.Box(new Vector3(0.5f));
        var flush = AnyShape.Of(new CompoundShape(
        [
            new CompoundPart(box, new RigidPose(new Vector3(-0.5f, 0, 0))),
            new CompoundPart(box, new RigidPose(new Vector3(0.5f, 0, 0))),
        ]));
        AssertStart(Start(flush, ConvexShape.Sphere(0.3f), new Vector3(0.15f, 0.6f, 0)), Vector3.UnitY, 0.2f);
        var slabs = new CompoundPart[10];
        for (int i = 0; i < slabs.Length; i++)
        {
            slabs[i] = new CompoundPart(
                ConvexShape.Box(new Vector3(0.1f * (i + 1), 0.5f, 0.1f * (i + 1))),
                new RigidPose(new Vector3(3 * (i % 2), 0, 0)));
        }

        var hits = new List<CastHit>();
        var ball = AnyShape.Of(ConvexShape.Sphere(1f));
        var at = new RigidPose(new Vector3(0, 1, 0));
        var scene = new CollisionScene();
        scene.Add(AnyShape.Of(new CompoundShape(slabs)), RigidPose.Identity);
        Assert.True(ConcaveQuery.CastAll(
            AnyShape.Of(new CompoundShape(slabs)), RigidPose.Identity, Vector3.Zero, ball, at, Vector3.Zero, _scratch,
            hits));
        Assert.True(hits.Count >= 5, $"{hits.Count}");
        for (int i = 1; i < hits.Count; i++) Assert.True(hits[i].Result.Depth <= hits[i - 1].Result.Depth);
        var found = new List<CastHit>();
        scene.FindCastHits(ball.Convex, at, Vector3.Zero, found, eachPart: true);
        Assert.Equal(hits.Select(h => h.PartA), found.Select(h => h.PartB));
        scene.FindCastHits(ball.Convex, at, Vector3.Zero, found);
        Assert.Equal(hits[0].PartA, Assert.Single(found).PartB);
    }

    [Fact]
    public void ABallInASolidCubeLeavesThroughTheNearestFace()
    {
        var cube = AnyShape.Solid(ConcaveShapes.Box(Vector3.One));
        var mirrored = AnyShape.Solid(cube.Mesh!.Scaled(new Vector3(-1, 1, 1)));
        Vector3[] places = [new(0.2f, 0.5f, 0.1f), new(0.2f, 0.9f, 0.1f), new(0.2f, 1.1f, 0.1f), new(0.7f, 0.1f, 0.6f)];
        foreach (Vector3 at in places)
        {
            Vector3 outward = at.Y > at.X ? Vector3.UnitY : Vector3.UnitX;
            float depth = 0.25f + 1 - Math.Max(at.X, at.Y);
            AssertStart(Start(cube, ConvexShape.Sphere(0.25f), at), outward, depth);
            AssertStart(Start(mirrored, ConvexShape.Sphere(0.25f), at), outward, depth);
            CastHit swapped = ConcaveQuery.Cast(
                AnyShape.Of(ConvexShape.Sphere(0.25f)), new RigidPose(at), Vector3.Zero, cube, RigidPose.Identity,
                Vector3.UnitX, _scratch);
            AssertStart(swapped, -outward, depth);
            Assert.Equal(-1, swapped.PartA);
        }

        // A box that is more than half in, and one in the corner of a room.
        AssertStart(
            Start(cube, ConvexShape.Box(new Vector3(0.4f)), new Vector3(0.1f, 0.9f, 0)), Vector3.UnitY, 0.5f);
        AssertStart(
            Start(cube, ConvexShape.Capsule(0.2f, 0.3f), new Vector3(0, 1.45f, 0)), Vector3.UnitY, 0.05f);
    }

    /// <summary>A triangle of the floor that holds the tip in its middle would have a long way over the tip's
    /// faces, and the floor ends far away; the tip itself is not deep.</summary>
    [Theory]
    [InlineData(true, 2f)]
    [InlineData(true, 0.25f)]
    [InlineData(false, 2f)]
    [InlineData(false, 0.25f)]
    public void ATipInAFlatFieldLeavesByNoMoreThanItsDepth(bool isSolid, float cell)
    {
        int columns = (int)(6 / cell) + 1;
        AnyShape floor = Solids.FlatField(columns, cell, isSolid);
        var at = new RigidPose(new Vector3(-3, 0, -3));
        TriangleMesh mesh = ConcaveShapes.Box(new Vector3(0.3f, 0.2f, 0.25f));
        var body = AnyShape.Solid(mesh);
        var random = new Rng(5);
        int count = Budget.Whole(600);
        for (int i = 0; i < count; i++)
        {
            Quaternion turn = random.Rotation();
            float deep = random.Float(0.002f, 0.05f), height = -Solids.Lowest(mesh, turn) - deep;
            var from = new RigidPose(turn, new Vector3(random.Float(-0.5, 0.5), height, random.Float(-0.5, 0.5)));
            Vector3 down = new(random.Float(-0.5, 0.5), -0.2f, random.Float(-0.5, 0.5));
            CastHit start = ConcaveQuery.Cast(body, from, down, floor, at, Vector3.Zero, _scratch);
            Assert.Equal(CastStatus.OverlappingAtStart, start.Status);
            Assert.True(start.Result.Depth <= deep + 1e-5f, $"{i}, {from}: {deep} deep, {start}");
            if (isSolid) AssertStart(start, -Vector3.UnitY, deep);
            foreach (float allowed in new[] { 0, 7e-4f })
            {
                CastHit hit = ConcaveQuery.Cast(
                    body, from, down, floor, at, Vector3.Zero, _scratch, options: CastOptions.OnlyDeeper(allowed));
                Assert.True(hit.IsHit && hit.Fraction < 1e-3f, $"{i}, {from}, {deep} deep, by {down}: {hit}");
            }
        }
    }

    /// <summary>No triangle crosses the floor's top: a ring of the body's vertices lies in it. Which triangle is the
    /// mesh's first, and where the body goes, does not matter.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.3f)]
    public void WhatHasARingInTheFaceOfASolidBeginsInIt(float turn)
    {
        var floor = AnyShape.Solid(ConcaveShapes.Box(new Vector3(2, 0.5f, 2)));
        var at = new RigidPose(new Vector3(0, -0.5f, 0));
        var from = new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitY, turn), new Vector3(0.3f, 0, 0.2f));
        Vector3[] ways = [Vector3.Zero, new(0.5f, 0, 0), new(0.1f, 0.7f, 0), new(0.1f, -0.7f, 0)];
        for (int first = 0; first < 20; first++)
        {
            var body = AnyShape.Solid(BoxWithARing(first));
            foreach (Vector3 way in ways)
            {
                AssertStart(
                    ConcaveQuery.Cast(floor, at, Vector3.Zero, body, from, way, _scratch), Vector3.UnitY, 0.5f);
                AssertStart(
                    ConcaveQuery.Cast(body, from, way, floor, at, Vector3.Zero, _scratch), -Vector3.UnitY, 0.5f);
                var above = new RigidPose(from.Rotation, from.Position + new Vector3(0, 0.5f, 0));
                CastHit rests = ConcaveQuery.Cast(floor, at, Vector3.Zero, body, above, way, _scratch);
                Assert.NotEqual(CastStatus.OverlappingAtStart, rests.Status);
            }
        }
    }

    [Fact]
    public void EveryStartInASolidIsOutAfterAFewWays()
    {
        var random = new Rng(4701);
        var torus = AnyShape.Solid(ConcaveShapes.Torus(24, 16));
        var cube = AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.7f)));
        int inside = 0;
        for (int round = 0; round < 200; round++)
        {
            AnyShape solid = round % 2 == 0 ? torus : cube;
            ConvexShape body = random.Below(3) switch
            {
                0 => ConvexShape.Sphere(random.Float(0.02f, 0.3f)),
                1 => ConvexShape.Capsule(random.Float(0.02f, 0.2f), random.Float(0.02f, 0.2f)),
                _ => ConvexShape.Box(new Vector3(random.Float(0.05f, 0.3f), 0.1f, 0.2f)),
            };
            var pose = new RigidPose(random.Rotation(), random.Vector(1.2));
            for (int way = 0; ; way++)
            {
                CastHit start = ConcaveQuery.Cast(
                    solid, RigidPose.Identity, Vector3.Zero, AnyShape.Of(body), pose, Vector3.Zero, _scratch);
                if (start.Status != CastStatus.OverlappingAtStart || start.Result.Depth < 1e-5f) break;
                if (way == 0) inside++;
                Assert.True(way < 12, $"round {round}: {start}");
                pose = new RigidPose(pose.Rotation, pose.Position + start.Result.Depth * start.Result.Normal);
            }

            Assert.False(ConcaveQuery.Contains(solid, RigidPose.Identity, pose.Position, _scratch), $"round {round}");
        }

        Assert.InRange(inside, 60, 180);
    }

    [Fact]
    public void CastAllRefusesWhatCastRefuses()
    {
        var ball = AnyShape.Of(ConvexShape.Sphere(1));
        var cube = AnyShape.Solid(ConcaveShapes.Box(Vector3.One));
        var (at, up) = (RigidPose.Identity, Vector3.UnitY);
        var hits = new List<CastHit>();
        Assert.False(ConcaveQuery.CastAll(ball, at, up, cube, at, up, _scratch, null!));
        Assert.False(ConcaveQuery.CastAll(ball, at, up, cube, at, up, null!, hits));
        Assert.False(ConcaveQuery.CastAll(ball, at, up, default, at, up, _scratch, hits));
        Assert.False(ConcaveQuery.CastAll(ball, default, up, cube, at, up, _scratch, hits));
        Assert.False(ConcaveQuery.CastAll(ball, at, new Vector3(float.NaN, 0, 0), cube, at, up, _scratch, hits));
        Assert.False(ConcaveQuery.CastAll(ball, at, up, cube, at, up, _scratch, hits, float.NaN));
        Assert.Empty(hits);
        Assert.True(ConcaveQuery.CastAll(ball, at, up, ball, new RigidPose(3 * up), Vector3.Zero, _scratch, hits, 9));
        Assert.Equal(CastStatus.Hit, Assert.Single(hits).Status);
        Assert.True(ConcaveQuery.CastAll(ball, at, up, cube, new RigidPose(9 * up), up, _scratch, hits));
        Assert.Empty(hits);
        Assert.True(ConcaveQuery.CastAll(ball, at, up, cube, new RigidPose(up), up, _scratch, hits));
        Assert.Equal(CastStatus.OverlappingAtStart, hits[0].Status);
    }

    /// <summary>A box with a ring of vertices at half its height, which begins with one of its 20 triangles.</summary>
    private static TriangleMesh BoxWithARing(int first)
    {
        Vector3[] points = [.. Enumerable.Range(0, 12).Select(
            i => new Vector3(i % 4 is 0 or 3 ? -0.3f : 0.3f, 0.5f * (i / 4 - 1), i % 4 < 2 ? -0.3f : 0.3f))];
        var indices = new List<int> { 0, 1, 2, 0, 2, 3, 8, 10, 9, 8, 11, 10 };
        for (int a = 0; a < 8; a++)
        {
            int b = a % 4 == 3 ? a - 3 : a + 1;
            indices.AddRange([a, a + 4, b, b, a + 4, b + 4]);
        }

        return new TriangleMesh(points, [.. indices.Skip(3 * first), .. indices.Take(3 * first)]);
    }

    private CastHit Start(in AnyShape ground, in ConvexShape body, Vector3 at) => ConcaveQuery.Cast(
        ground, RigidPose.Identity, Vector3.Zero, AnyShape.Of(body), new RigidPose(at), new Vector3(0, -1, 0),
        _scratch);

    private static void AssertStart(in CastHit start, Vector3 normal, float depth)
    {
        Assert.Equal(CastStatus.OverlappingAtStart, start.Status);
        Assert.True((start.Result.Normal - normal).Length() < 1e-5f, $"{start}");
        Assert.Equal(depth, start.Result.Depth, 1e-5f);
    }
}
