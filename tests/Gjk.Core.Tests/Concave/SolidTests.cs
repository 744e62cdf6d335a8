namespace Gjk.Core.Tests.Concave;

/// <summary>What has an inside, and what lies in it.</summary>
public class SolidTests
{
    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void AMeshSaysWhatItIsLike()
    {
        TriangleMesh torus = ConcaveShapes.Torus(8, 6), grid = ConcaveShapes.Grid(3);
        Assert.True(torus is { IsClosed: true, IsOriented: true, HasInside: true, BorderEdgeCount: 0 });
        Assert.True(grid is { IsClosed: false, IsOriented: true, HasInside: false, BorderEdgeCount: 12 });
        Assert.Equal((0, 0, 1), (torus.DegenerateCount, torus.DuplicateCount, torus.ComponentCount));
        Vector3[] points = [default, Vector3.UnitX, Vector3.UnitY, new(2, 0, 0), -default(Vector3)];
        var dirty = new TriangleMesh(points, [0, 1, 2, 2, 4, 1, 0, 1, 3, 1, 1, 2]);
        Assert.Equal((2, 1, false), (dirty.DegenerateCount, dirty.DuplicateCount, dirty.HasInside));
        Assert.False(TriangleMesh.TryCreate(points, [0, 1, 9], out _, out string? reason));
        Assert.Equal("Triangle 0 names vertex 9, but there are 5, counted from 0.", reason);
        Assert.Throws<ArgumentException>("indices", () => new TriangleMesh(points, [0, 1, 9]));
        Assert.Throws<ArgumentException>("indices", () => new TriangleMesh(points, [0, 1]));
        Assert.Throws<ArgumentException>("indices", () => new TriangleMesh(points, []));
        Assert.Throws<ArgumentException>("vertices", () => new TriangleMesh([new(float.NaN)], [0, 0, 0]));
        Assert.Equal(
            "The edge from vertex 0 to vertex 1 has 1 triangle along it and 0 triangles against it.",
            new TriangleMesh(points, [0, 1, 2]).WhyNoInside);
        Assert.Throws<ArgumentException>(() => AnyShape.Solid(grid));
    }

    [Fact]
    public void AShapeSaysWhatItIs()
    {
        TriangleMesh torus = ConcaveShapes.Torus(8, 6);
        var ball = ConvexShape.Sphere(1);
        Assert.Equal("Solid of 96 triangles", AnyShape.Solid(torus).ToString());
        Assert.Equal("Surface of 96 triangles", AnyShape.Surface(torus).ToString());
        Assert.Equal(ball.ToString(), AnyShape.Of(ball).ToString());
        Assert.Equal(default(ConvexShape).ToString(), default(AnyShape).ToString());
        var two = new CompoundShape([new(ball, RigidPose.Identity), new(ball, new RigidPose(Vector3.UnitX))]);
        Assert.Equal("Compound of 2 parts", AnyShape.Of(two).ToString());
    }

    [Fact]
    public void APointIsInATorusWhereTheFormulaSaysSo()
    {
        var random = new Rng(7);
        TriangleMesh fine = ConcaveShapes.Torus(96, 48);
        AnyShape solid = AnyShape.Solid(fine);
        int inside = 0;
        for (int i = 0; i < 300; i++)
        {
            RigidPose pose = ConcaveShapes.Pose(random, 5);
            Vector3 local = random.Vector(1) * new Vector3(1.5f, 0.5f, 1.5f), point = pose.TransformPoint(local);
            double ring = Math.Sqrt((double)local.X * local.X + (double)local.Z * local.Z) - 1;
            double depth = 0.35 - Math.Sqrt(ring * ring + (double)local.Y * local.Y);
            if (Math.Abs(depth) < 3e-3) continue;
            Assert.Equal(depth > 0, ConcaveQuery.Contains(solid, pose, point, _scratch));
            PairDistance signed = ConcaveQuery.SignedDistance(solid, pose, point, _scratch);
            Assert.InRange(signed.Distance, -depth - 3e-3, -depth + 3e-3);
            Assert.True(signed.Result.LowerBound <= signed.Distance);
            Vector3 back = signed.Result.PointA + signed.Result.Normal * signed.Distance;
            Assert.True((back - point).Length() < 1e-5f);
            if (depth > 0) inside++;
        }

        Assert.InRange(inside, 60, 240);
    }

    /// <summary>Rays along x from these points pass through edges and corners of the triangles.</summary>
    [Fact]
    public void TheWindingNumberIsExactOnALattice()
    {
        TriangleMesh box = ConcaveShapes.Box(Vector3.One);
        var winding = new WindingNumber();
        for (int x = -3; x <= 3; x++)
            for (int y = -3; y <= 3; y++)
                for (int z = -3; z <= 3; z++)
                {
                    var point = new Double3(x * 0.5, y * 0.5, z * 0.5);
                    if (Math.Max(Math.Abs(x), Math.Max(Math.Abs(y), Math.Abs(z))) == 2) continue;
                    bool isInside = Math.Abs(x) < 2 && Math.Abs(y) < 2 && Math.Abs(z) < 2;
                    Assert.Equal(isInside ? 1 : 0, winding.About(box, (VectorDD)point));
                }

        // As near a corner's edge as double tells, and much nearer by the point's low half.
        var low = DoubleDouble.Sum(1, -1e-30);
        var near = new VectorDD((DoubleDouble)0.0, low, (DoubleDouble)0.0);
        Assert.Equal(1, winding.About(box, near));
        near = new VectorDD((DoubleDouble)0.0, DoubleDouble.Sum(1, 1e-30), (DoubleDouble)0.0);
        Assert.Equal(0, winding.About(box, near));
    }

    [Fact]
    public void APieceInsideOverlapsASolidAndNotASurface()
    {
        TriangleMesh box = ConcaveShapes.Box(Vector3.One);
        AnyShape solid = AnyShape.Solid(box), shell = AnyShape.Surface(box);
        AnyShape small = AnyShape.Surface(ConcaveShapes.Torus(6, 5, 0.3f, 0.1f));
        RigidPose here = RigidPose.Identity, there = new(new Vector3(0.1f, 0.2f, 0.3f));
        PairDistance found = ConcaveQuery.Distance(solid, here, small, there, _scratch);
        Assert.True(found.IsOverlapping && found.PartA == -1 && found.PartB == 0);
        found = ConcaveQuery.Distance(small, there, solid, here, _scratch);
        Assert.True(found.IsOverlapping && found.PartA == 0 && found.PartB == -1);
        Assert.False(ConcaveQuery.Overlaps(shell, here, small, there, _scratch));
        Assert.True(
            ConcaveQuery.Cast(solid, here, Vector3.Zero, small, there, Vector3.UnitX, _scratch).Status
                == CastStatus.OverlappingAtStart);
        RayHit ray = ConcaveQuery.RayCast(solid, here, new Vector3(0, 0, 0.75f), Vector3.UnitX, _scratch);
        Assert.Equal((CastStatus.OverlappingAtStart, 0.25f), (ray.Status, ray.Result.Depth));
        Assert.Equal(Vector3.UnitZ, ray.Result.Normal);
        Assert.Equal(1, ConcaveQuery.RayCast(shell, here, Vector3.Zero, Vector3.UnitX, _scratch).Distance);
    }

    [Fact]
    public void WhatTouchesASolidHitsItIfItMovesIn()
    {
        AnyShape solid = AnyShape.Solid(ConcaveShapes.Box(Vector3.One));
        AnyShape cube = AnyShape.Of(ConvexShape.Box(new Vector3(0.25f)));
        RigidPose on = new(new Vector3(0.1f, 1.25f, 0));
        Assert.Equal(CastStatus.Hit, Cast(-Vector3.UnitY * 0.5f).Status);
        Assert.Equal(0, Cast(-Vector3.UnitY * 0.5f).Fraction);
        Assert.Equal(CastStatus.Miss, Cast(Vector3.UnitX * 0.5f).Status);
        Assert.Equal(CastStatus.Miss, Cast(Vector3.UnitY).Status);

        CastHit Cast(Vector3 way) =>
            ConcaveQuery.Cast(solid, RigidPose.Identity, Vector3.Zero, cube, on, way, _scratch);
    }

    [Fact]
    public void InvalidInputIsNoAnswer()
    {
        AnyShape torus = AnyShape.Surface(ConcaveShapes.Torus(5, 4));
        RigidPose pose = RigidPose.Identity;
        Assert.Equal(GjkStatus.InvalidInput, ConcaveQuery.Distance(default, pose, torus, pose, _scratch).Status);
        Assert.Equal(GjkStatus.InvalidInput, ConcaveQuery.Distance(torus, default, torus, pose, _scratch).Status);
        Assert.Equal(GjkStatus.InvalidInput, ConcaveQuery.Distance(torus, pose, torus, pose, null!).Status);
        Assert.Equal(
            GjkStatus.InvalidInput, ConcaveQuery.Distance(torus, pose, torus, pose, _scratch, float.NaN).Status);
        Assert.Equal(
            CastStatus.InvalidInput, ConcaveQuery.RayCast(torus, pose, default, default, _scratch).Status);
        Assert.Equal(
            CastStatus.InvalidInput,
            ConcaveQuery.Cast(torus, pose, new Vector3(float.NaN), torus, pose, default, _scratch).Status);
        Assert.False(ConcaveQuery.Overlaps(default, pose, torus, pose, _scratch));
        Assert.Throws<ArgumentException>(() => new CompoundShape(new List<CompoundPart>()));
        Assert.Throws<ArgumentException>(() => new CompoundShape(new CompoundPart[1].ToList()));
    }
}
