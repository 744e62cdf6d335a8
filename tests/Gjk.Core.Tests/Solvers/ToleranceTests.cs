namespace Gjk.Core.Tests.Solvers;

/// <summary>Each tolerance from both sides: what a solver does with a length, or a ratio, of half of it and of twice as
/// much. The numbers are written out here, so that a tolerance that moves is noticed.</summary>
public class ToleranceTests
{
    /// <summary>A rounding in double, 2^-53.</summary>
    private const double U = 1.0 / (1L << 53);

    private static readonly Double3 Z = new(0, 0, 1);

    /// <summary>The first vertex is the nearest, and the second lies lower by a part of the distance: the bounds have
    /// met, or the walk goes on. The shapes are a millionth of the distance, so that the noise is nothing beside
    /// it.</summary>
    [Theory]
    [InlineData(false, 128 * U, true)]
    [InlineData(false, 512 * U, false)]
    [InlineData(true, 5e-10, true)]
    [InlineData(true, 2e-9, false)]
    public void ARelativeGapIsClosed(bool isCurved, double ratio, bool isClosed)
    {
        const double distance = 1 << 20;
        Double3[] vertices = [Z * distance, new(1, 0, distance * (1 - ratio))];
        foreach (bool isExtended in new[] { false, true })
        {
            SolverState state = Solve(vertices, -Z * distance, isCurved, isExtended);
            Assert.Equal(isClosed, state is { Verdict: Verdict.Apart, Iterations: 2 });
        }
    }

    /// <summary>The same near contact, where the gap is a part of the shapes' size.</summary>
    [Theory]
    [InlineData(false, 2 * U, true)]
    [InlineData(false, 8 * U, false)]
    [InlineData(true, 5e-11, true)]
    [InlineData(true, 2e-10, false)]
    public void AGapBelowTheNoiseIsClosed(bool isCurved, double gap, bool isClosed)
    {
        const double distance = 1.0 / (1 << 10);
        Double3[] vertices = [Z * distance, new(1, 0, distance - gap)];
        foreach (bool isExtended in new[] { false, true })
        {
            SolverState state = Solve(vertices, -Z * distance, isCurved, isExtended);
            Assert.Equal(isClosed, state is { Verdict: Verdict.Apart, Iterations: 2 });
        }
    }

    [Theory]
    [InlineData(false, 8 * U, true)]
    [InlineData(false, 32 * U, false)]
    [InlineData(true, 2e-10, true)]
    [InlineData(true, 8e-10, false)]
    public void ADistanceBelowTheTouchToleranceIsContact(bool isCurved, double distance, bool isTouching)
    {
        foreach (bool isExtended in new[] { false, true })
        {
            SolverState state = Solve([Z * distance], new Double3(-1, 0, 0), isCurved, isExtended);
            Assert.Equal(isTouching ? Verdict.Enclosed : Verdict.Apart, state.Verdict);
            state.Verdict = Verdict.Apart;
            Assert.Equal(isTouching, Proofs.IsTouching(state, distance));
        }
    }

    /// <summary>The boolean solver leaves to the distance what a plane does not separate by much more.</summary>
    [Theory]
    [InlineData(false, 128 * U, false)]
    [InlineData(false, 512 * U, true)]
    [InlineData(true, 8e-10, false)]
    [InlineData(true, 3.2e-9, true)]
    public void AGapBeyondTheBandIsApart(bool isCurved, double gap, bool isApart)
    {
        PairFrame frame = Pair([Z * gap], Z * -1e-30, isCurved, out ScriptedShape a, out PointShape b);
        frame.RadiusA = 1;
        Assert.Equal(isApart ? Verdict.Apart : Verdict.Undecided, GjkOverlap.Solve(ref a, ref b, frame));
    }

    /// <summary>A bound is lowered by 10 roundings of twice the size and the gap: by 20 of the size at a gap of
    /// 100.</summary>
    [Fact]
    public void ALowerBoundLosesTwentyRoundingsOfTheSize()
    {
        var shape = new ScriptedShape([new(1, 0, 100 * U)]);
        DistanceResult r = ConvexQuery.Distance(
            shape, RigidPose.Identity, new PointShape(), new RigidPose(Vector3.UnitX));
        Assert.Equal(GjkStatus.Separated, r.Status);
        Assert.Equal(100 * U, r.Distance, 1e-6 * U);
        Assert.InRange(r.LowerBound, 75 * U, 85 * U);
    }

    /// <summary>The second support lies behind the first: its own rounding, or no convex shape.</summary>
    [Theory]
    [InlineData(5e-6, Verdict.Apart)]
    [InlineData(2e-5, Verdict.Contradiction)]
    public void ASupportThatIsFurtherBehindContradictsItself(double behind, object verdict)
    {
        Double3[] vertices = [Z, Z * (1 + behind)];
        Assert.Equal(verdict, Solve(vertices, new Double3(-1, 0, 0), false, false).Verdict);
        Assert.Equal(verdict, Solve(vertices, new Double3(-1, 0, 0), false, true).Verdict);
    }

    /// <summary>The second plane is further than asked, and the first feature is not the nearest.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void APlaneBeyondTheLargestDistanceEnds(bool isExtended)
    {
        Double3[] vertices = [Z, Z * 0.75];
        SolverState state = Solve(vertices, new Double3(-1, 0, 0), false, isExtended, 0.5);
        Assert.Equal(Verdict.Beyond, state.Verdict);
        Assert.True(state.Plane.Distance > 0.5);
        state = Solve(vertices, new Double3(-1, 0, 0), false, isExtended, 0.8);
        Assert.Equal((Verdict.Apart, 0.75), (state.Verdict, state.Plane.Distance));
    }

    /// <summary>A support that goes on falling, a little each time: the walk ends at 256 rounds in either precision,
    /// and the plane that is kept is the best of all, which is the first.</summary>
    [Fact]
    public void AWalkThatDoesNotEndIsEnded()
    {
        Double3[] falling = [.. Enumerable.Range(0, 3000).Select(i => Z * (1 - 1e-4 * i))];
        foreach (bool isExtended in new[] { false, true })
        {
            SolverState state = Solve(falling, new Double3(-1, 0, 0), false, isExtended);
            Assert.Equal((Verdict.Undecided, 256), (state.Verdict, state.Iterations));
            if (isExtended) Assert.Equal(1 - 1e-4, state.Plane.Distance, 1e-12);
        }

        DistanceResult r = ConvexQuery.Distance(
            new ScriptedShape([.. falling.Select(p => p + new Double3(1, 0, 0))]), RigidPose.Identity,
            new PointShape(), new RigidPose(Vector3.UnitX));
        Assert.Equal((GjkStatus.IterationLimit, 512), (r.Status, r.Iterations));
        Assert.True(r.LowerBound <= r.Distance);
    }

    /// <summary>A distance further than this rounds to a larger float: half a float's spacing, and room.</summary>
    [Fact]
    public void ALargestDistanceIsWidenedByFourRoundingsToFloat() =>
        Assert.InRange((GjkDistance.ShapeReach(1) - 1) * (1 << 24), 2, 8);

    /// <summary>Three vertices beyond a plane, and a fourth on the other side of the origin: no convex shape has both,
    /// so the tetrahedron proves nothing, however clearly it holds the origin.</summary>
    [Fact]
    public void AnOriginThatAPlaneHadSeparatedIsNotEnclosed()
    {
        Double3[] vertices = [new(2, 0, 1), new(-1, 2, 1), new(-1, -2, 1), new(0, 0, -3)];
        Assert.True(ClosestPointWeights.IsInside(vertices[0], vertices[1], vertices[2], vertices[3]));
        SolverState state = Solve(vertices, new Double3(-1, 0, 0), false, false);
        Assert.Equal((Verdict.Undecided, 4), (state.Verdict, state.Simplex.Count));
    }

    /// <summary>A tetrahedron whose one face passes the origin at a few roundings. It is so long that its volumes say
    /// nothing, and each face in turn is the near one; on its other side, the origin is not inside at all.</summary>
    [Theory]
    [InlineData(8 * U, false)]
    [InlineData(32 * U, true)]
    [InlineData(-8 * U, false)]
    [InlineData(-32 * U, false)]
    [InlineData(-0.5, false)]
    public void AFaceIsCertainlyPassedBySixteenRoundings(double height, bool isInside)
    {
        // The determinant is |e × f| h = 2.6 h, the product of the lengths 1 · √3 · √3.
        double h = height / (1.5 * Math.Sqrt(3) / 3), side = Math.Sqrt(0.75);
        Double3[] v = [new(1, 0, -h), new(-0.5, side, -h), new(-0.5, -side, -h), new(0, 0, 1e6)];
        int[][] orders = [[0, 1, 2, 3], [3, 0, 1, 2], [0, 3, 1, 2], [1, 2, 3, 0], [1, 0, 2, 3], [3, 1, 0, 2]];
        foreach (int[] o in orders)
            Assert.Equal(isInside, Proofs.IsCertainlyInside(v[o[0]], v[o[1]], v[o[2]], v[o[3]]));
    }

    /// <summary>Needles of triangles, whose normals rounding tilts: the double walk ends where their corners are level
    /// to 16 roundings of the size, beside what the distance allows, and hands over where they are not.</summary>
    [Fact]
    public void ATriangleIsLevelToSixteenRoundings()
    {
        var rng = new Rng(11);
        int level = 0, tilted = 0;
        for (int i = 0; i < 20000; i++)
        {
            // A frame that is turned at random, so that no product is exact.
            Double3 along = rng.UnitVector(), across = Double3.Cross(along, rng.UnitVector());
            Double3 away = Double3.Cross(along, across) * (1.0 / (1 << 20));
            across *= rng.LogFloat(1e-4, 1);
            Double3[] v = [.. new[] { -0.4, 0.5, rng.Range(-1, 1) }.Select(
                x => along * x + across * rng.Range(-1, 1) + away)];
            SolverState state = Solve([.. v, v[2]], default, false, false);
            if (state.Simplex.Count != 3 || state.Iterations != 4) continue;
            Double3 normal = state.Feature.Normal;
            double plane = Double3.Dot(normal, v[2]), unit = U * state.Size.Value * normal.Length;
            double off = v.Max(p => Math.Abs(Double3.Dot(normal, p) - plane)) / unit;
            bool isApart = state.Verdict == Verdict.Apart;
            if (isApart && off > 5) level++;
            if (!isApart && off < 60) tilted++;
            Assert.True(isApart ? off < 17 : off > 15, $"{i}: {state.Verdict}, {off} roundings");
        }

        Assert.True(level > 20 && tilted > 20, $"{level} level, {tilted} tilted");
    }

    private static SolverState Solve(
        Double3[] vertices, in Double3 translation, bool isCurved, bool isExtended,
        double most = double.PositiveInfinity)
    {
        PairFrame frame = Pair(vertices, translation, isCurved, out ScriptedShape a, out PointShape b);
        SolverState.Make<ScriptedShape, PointShape>(frame, out SolverState state);
        state.Feature.Normal = frame.FirstNormal;
        NoTrace trace = default;
        if (isExtended)
            GjkExtendedPrecision.Solve(ref a, ref b, frame, most, ref state, ref trace);
        else
            GjkDistance.Solve(ref a, ref b, frame, most, ref state, ref trace);
        return state;
    }

    /// <summary>A pair whose Minkowski difference has these vertices, with B's centre at the translation.</summary>
    private static PairFrame Pair(
        Double3[] vertices, Double3 translation, bool isCurved, out ScriptedShape a, out PointShape b)
    {
        a = new ScriptedShape([.. vertices.Select(w => w + translation)], isCurved);
        b = new PointShape();
        PairFrame.Compose(ref a, RigidPose.Identity, ref b, new RigidPose((Vector3)translation), out PairFrame frame);
        return frame;
    }
}
