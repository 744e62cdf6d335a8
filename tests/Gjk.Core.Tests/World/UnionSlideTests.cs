using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>What begins inside the union of parts or objects slides along the union, over its seams, and is stopped by
/// what stands in the way.</summary>
public class UnionSlideTests
{
    private static readonly CastOptions NoDeeper = CastOptions.OnlyDeeper(1e-3f);

    public static TheoryData<string> Floors => ["one", "tiles", "mesh", "compound", "solid"];

    [Theory]
    [MemberData(nameof(Floors))]
    public void ABodyThatIsDeepSlidesOverSeams(string floor)
    {
        ConvexShape[] bodies = [ConvexShape.Capsule(0.3f, 0.5f), ConvexShape.Box(new Vector3(0.3f, 0.8f, 0.2f))];
        foreach (ConvexShape body in bodies)
        {
            foreach (float deep in new[] { 0.01f, 0.002f, 0.05f })
            {
                var scene = new CollisionScene();
                AddFloor(scene, floor);
                var from = new RigidPose(new Vector3(1.1f, 1.3f - deep, 0.05f));
                bool isHit = scene.TryFindCastHit(
                    body, from, new Vector3(5, 0, 0), out CastHit hit, options: NoDeeper);
                Assert.False(isHit, $"{floor}, {deep}: {hit}");
                int wall = scene.Add(ConvexShape.Box(new Vector3(0.5f, 3, 3)), new RigidPose(new Vector3(5, 0, 0)));
                Assert.True(scene.TryFindCastHit(
                    body, from, new Vector3(5, 0, 0), out hit, options: NoDeeper));
                Assert.Equal(wall, hit.Id);
                Assert.Equal((4.5f - 0.3f - 1.1f) / 5, hit.Fraction, 1e-5f);
                Assert.True(
                    scene.TryFindCastHit(body, from, new Vector3(0, -0.1f, 0), out hit, options: NoDeeper),
                    $"{floor}: down");
            }
        }
    }

    /// <summary>What is deeper than allowed does not sink on, however short its steps are.</summary>
    [Theory]
    [MemberData(nameof(Floors))]
    public void ABodyThatIsDeepDoesNotCreepIn(string floor)
    {
        var scene = new CollisionScene();
        AddFloor(scene, floor);
        var random = new Rng(61);
        ConvexShape[] bodies =
        [
            ConvexShape.Capsule(0.3f, 0.5f), ConvexShape.Box(new Vector3(0.3f, 0.8f, 0.2f)),
            ConvexShape.Cylinder(0.3f, 0.8f),
        ];
        for (int i = 0; i < 60; i++)
        {
            Vector3 at = new(random.Float(1, 8), 1.3f - random.Float(0.0011, 0.08), random.Float(-0.1, 0.1));
            Vector3 start = at, way = new(
                random.OneIn(2) ? 0 : random.Float(-1e-3, 1e-3), -random.Of(9e-4f, 1e-4f, 3e-5f), 0);
            for (int frame = 0; frame < 100; frame++)
            {
                scene.TryFindCastHit(bodies[i % 3], new RigidPose(at), way, out CastHit hit, options: NoDeeper);
                at += hit.Fraction * way;
            }

            Assert.True(at.Y >= start.Y - 1e-5f, $"{floor}, {i}: by {way} from {start} to {at}");
        }
    }

    /// <summary>A motion that ends deeper than allowed is stopped by flush tiles as by one box: where it touches them
    /// first, with the normal of the floor, not with that of a seam.</summary>
    [Theory]
    [InlineData("tiles")]
    [InlineData("field")]
    [InlineData("compound")]
    public void WhatGetsDeeperIsStoppedAsByOneBox(string floor)
    {
        int hits = 0;
        for (int seed = 0; seed < 400; seed++)
        {
            var random = new Rng((ulong)seed);
            float width = random.Float(0.2, 2), allowed = random.Of(1e-4f, 1e-3f, 1e-2f);
            int count = (int)(20 / width);
            float begin = random.Float(-0.1, 0.1) - 10, length = count * width;
            float start = random.Of(0f, 0.5f, -2f) * allowed;
            Vector3 way = new(random.Float(0.2, 5), -allowed * random.Float(0.2, 4), random.Float(-0.5, 0.5));
            (ConvexShape body, float high) = random.Below(3) switch
            {
                0 => (ConvexShape.Box(new Vector3(0.5f)), 0.5f),
                1 => (ConvexShape.Capsule(0.4f, 0.6f), 1f),
                _ => (ConvexShape.Cylinder(0.4f, 0.6f), 0.6f),
            };
            CollisionScene one = new(), tiles = new();
            one.Add(
                ConvexShape.Box(new Vector3(length / 2, 0.5f, 10)),
                new RigidPose(new Vector3(begin + length / 2, -0.5f, 0)));
            CompoundPart[] parts = [.. Enumerable.Range(0, count).Select(i => new CompoundPart(
                ConvexShape.Box(new Vector3(width / 2, 0.5f, 10)),
                new RigidPose(new Vector3(begin + width * (i + 0.5f), -0.5f, 0))))];
            if (floor == "compound") tiles.Add(AnyShape.Of(new CompoundShape(parts)), RigidPose.Identity);
            else if (floor == "tiles") foreach (CompoundPart part in parts) tiles.Add(part.Shape, part.Pose);
            else
            {
                TriangleMesh field = TriangleMesh.FromHeights(
                    new float[(count + 1) * 21], count + 1, new Vector2(width, 1));
                tiles.Add(AnyShape.Surface(field), new RigidPose(new Vector3(begin, 0, -10)));
            }

            var from = new RigidPose(new Vector3(random.Float(-3, 0), high - start, random.Float(-1, 1)));
            CastOptions options = CastOptions.OnlyDeeper(allowed);
            bool isHit = one.TryFindCastHit(body, from, way, out CastHit expected, options: options);
            if (isHit) hits++;
            bool isFound = tiles.TryFindCastHit(body, from, way, out CastHit found, options: options);
            string what = $"{floor}, {seed}: {width}, {start} deep, by {way}, {allowed} allowed: {found}, {expected}";
            Assert.True(isHit == isFound, what);
            if (!isHit) continue;

            // A round body that is a rounding deep is met at the seam that far aside.
            Assert.True((found.Result.Normal - expected.Result.Normal).Length() < 0.01f, what);
            Assert.True(Math.Abs((found.Fraction - expected.Fraction) * way.Y) <= allowed, what);
        }

        Assert.InRange(hits, 100, 399);
    }

    [Theory]
    [InlineData(false, 0, 1e-3f)]
    [InlineData(true, 0, 1e-3f)]
    [InlineData(false, 1000, 0)]
    [InlineData(false, -3000, 0)]
    public void ABodyThatIsDeepInACompoundSlidesAlongIt(bool turns, float height, float allowed)
    {
        var at = new RigidPose(new Vector3(0, height, 0));
        CastOptions options = CastOptions.OnlyDeeper(allowed);
        AnyShape floor = Tiles();
        var scratch = new ConcaveScratch();
        AnyShape body = AnyShape.Of(ConvexShape.Capsule(0.3f, 0.5f));
        var from = new RigidPose(new Vector3(1.1f, height + 1.29f, 0.05f));
        CastHit found = turns
            ? ConcaveQuery.TimeOfImpact(
                floor, new RigidMotion(at, Vector3.Zero), body,
                new RigidMotion(from, new Vector3(5, 0, 0), new Vector3(0, 0.1f, 0)), scratch, options: options)
            : ConcaveQuery.Cast(
                floor, at, Vector3.Zero, body, from, new Vector3(5, 0, 0), scratch, options: options);
        Assert.Equal(CastStatus.Miss, found.Status);
    }

    /// <summary>A solid's walls look aside where it stands in a floor, but it leaves the floor upwards.</summary>
    [Theory]
    [InlineData("plate")]
    [InlineData("two-sided")]
    [InlineData("slivers of 1e-6")]
    [InlineData("filled T-junctions")]
    [InlineData("tiles")]
    [InlineData("joined boxes")]
    [InlineData("slab")]
    public void ASolidThatIsDeepSlidesOverSeams(string name)
    {
        AnyShape floor = name == "slab" ? AnyShape.Solid(Slab) : Concave.Floors.Named(name);
        var scratch = new ConcaveScratch();
        TriangleMesh[] bodies =
        [
            Support.ConcaveShapes.Box(new Vector3(0.5f)), Support.ConcaveShapes.Torus(16, 8, 0.4f, 0.2f),
            Solids.Named("ball", 0), Solids.Named("gear", 0),
        ];
        foreach (TriangleMesh mesh in bodies)
        {
            var body = AnyShape.Solid(mesh);
            float lowest = -Solids.Lowest(mesh, Quaternion.Identity);
            const int Turns = 24;
            int count = Budget.Whole(Turns);
            for (int k = 0; k < count; k++)
            {
                // Steps of 7 spread a third of the turns over the whole range, with each depth.
                int i = 7 * k % Turns;
                float deep = i % 3 == 0 ? 0.002f : i % 3 == 1 ? 0.01f : 0.05f;
                var from = new RigidPose(
                    Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.3f * i),
                    new Vector3(0.7f + 0.02f * i, lowest - deep, 1.2f + 0.013f * i));
                Vector3 way = new(0.9f, 0, 0.1f);
                CastHit hit = ConcaveQuery.Cast(
                    body, from, way, floor, RigidPose.Identity, Vector3.Zero, scratch, options: NoDeeper);
                Assert.True(hit.Status == CastStatus.Miss, $"{mesh.TriangleCount} triangles, {i}, {deep}: {hit}");
                hit = ConcaveQuery.Cast(
                    floor, RigidPose.Identity, Vector3.Zero, body, from, way, scratch, options: NoDeeper);
                Assert.True(hit.Status == CastStatus.Miss, $"{mesh.TriangleCount} triangles, {i}, {deep}: {hit}");
                hit = ConcaveQuery.Cast(
                    body, from, new Vector3(0.3f, 0.5f, 0.1f), floor, RigidPose.Identity, Vector3.Zero, scratch,
                    options: NoDeeper);
                Assert.True(hit.Status == CastStatus.Miss, $"{mesh.TriangleCount} triangles, {i}, {deep}: out, {hit}");
                hit = ConcaveQuery.Cast(
                    floor, RigidPose.Identity, Vector3.Zero, body, from, new Vector3(0.3f, 0.5f, 0.1f), scratch,
                    options: NoDeeper);
                Assert.True(hit.Status == CastStatus.Miss, $"{mesh.TriangleCount} triangles, {i}, {deep}: out, {hit}");
                hit = ConcaveQuery.Cast(
                    body, from, new Vector3(0.9f, -0.1f, 0), floor, RigidPose.Identity, Vector3.Zero, scratch,
                    options: NoDeeper);
                Assert.True(hit.IsHit, $"{mesh.TriangleCount} triangles, {i}, {deep}: down");
            }
        }
    }

    /// <summary>Whole rows of the body's triangles are behind the surface, which it leaves freely and does not get
    /// deeper into, not even by short ways.</summary>
    [Theory]
    [InlineData("two triangles", "torus")]
    [InlineData("two triangles", "ball")]
    [InlineData("plate", "torus")]
    [InlineData("plate", "ball")]
    [InlineData("plate", "gear")]
    [InlineData("plate", "ring")]
    public void ASolidThatIsDeepInAnOpenSurfaceLeavesItUpwardsOnly(string floor, string name)
    {
        AnyShape sheet = floor == "plate" ? Concave.Floors.Named(floor) : AnyShape.Surface(new TriangleMesh(
            [new(-5, 0, -5), new(5, 0, -5), new(5, 0, 5), new(-5, 0, 5)], [0, 2, 1, 0, 3, 2]));
        TriangleMesh mesh = name == "torus"
            ? Support.ConcaveShapes.Torus(16, 8, 0.4f, 0.2f)
            : Solids.Named(name, 0);
        var body = AnyShape.Solid(mesh);
        var scratch = new ConcaveScratch();
        var random = new Rng(77);
        (Vector3 Way, bool IsHit)[] motions =
        [
            (new(0.3f, 0.5f, 0.1f), false), (new(0.9f, 0, 0.1f), false), (new(0.9f, -0.1f, 0), true),
            (new(0, -0.02f, 0), true), (new(0.05f, -0.02f, 0), true),
        ];
        for (int i = 0; i < 24; i++)
        {
            Quaternion turn = random.Rotation();
            float deep = random.Float(0.002f, 0.12f), height = -Solids.Lowest(mesh, turn) - deep;
            var from = new RigidPose(
                turn, new Vector3(1.2f + random.Float(-0.2f, 0.2f), height, 1.4f + random.Float(-0.2f, 0.2f)));
            foreach ((Vector3 way, bool isHit) in motions)
            {
                CastHit hit = ConcaveQuery.Cast(
                    body, from, way, sheet, RigidPose.Identity, Vector3.Zero, scratch, options: NoDeeper);
                Assert.True(hit.IsHit == isHit, $"{i}, {deep}, {way}: {hit}");
                hit = ConcaveQuery.Cast(
                    sheet, RigidPose.Identity, Vector3.Zero, body, from, way, scratch, options: NoDeeper);
                Assert.True(hit.IsHit == isHit, $"{i}, {deep}, {way}, swapped: {hit}");
            }
        }
    }

    /// <summary>What is lifted out of the floor is not lifted over a kerb that is lower than it is deep.</summary>
    [Theory]
    [InlineData("ball")]
    [InlineData("gear")]
    [InlineData("ring")]
    public void ASolidThatIsDeepIsStoppedByAKerb(string name)
    {
        TriangleMesh mesh = Solids.Named(name, 0), kerb = Solids.Box(new(2.5f, -0.5f, -1), new(2.6f, 0.03f, 4));
        var body = AnyShape.Solid(mesh);
        var floor = AnyShape.Solid(Solids.Joined((Slab, Vector3.Zero), (kerb, Vector3.Zero)));
        float lowest = -Solids.Lowest(mesh, Quaternion.Identity);
        foreach (float deep in new[] { 0.01f, 0.05f })
        {
            CastHit hit = ConcaveQuery.Cast(
                floor, RigidPose.Identity, Vector3.Zero, body, new RigidPose(new Vector3(1, lowest - deep, 1)),
                new Vector3(2, 0, 0), new ConcaveScratch(), options: NoDeeper);
            Assert.True(hit.IsHit && hit.Result.Fraction > 0.1f && hit.PartA >= Slab.TriangleCount, $"{deep}: {hit}");
        }
    }

    private static TriangleMesh Slab { get; } = Solids.Box(new(-1, -1, -1), new(4, 0, 4));

    internal static void AddFloor(CollisionScene scene, string floor)
    {
        var half = ConvexShape.Box(new Vector3(0.5f));
        switch (floor)
        {
            case "one":
                scene.Add(ConvexShape.Box(new Vector3(5, 0.5f, 0.5f)), new RigidPose(new Vector3(4.5f, 0, 0)));
                break;
            case "tiles":
                for (int i = 0; i < 10; i++) scene.Add(half, new RigidPose(new Vector3(i, 0, 0)));
                break;
            case "mesh":
                scene.Add(
                    AnyShape.Surface(TriangleMesh.FromHeights(new float[22], 11, Vector2.One)),
                    new RigidPose(new Vector3(-0.5f, 0.5f, -0.5f)));
                break;
            case "compound":
                scene.Add(Tiles(), RigidPose.Identity);
                break;
            default:
                scene.Add(
                    AnyShape.Solid(Support.ConcaveShapes.Box(new Vector3(5, 0.5f, 0.5f))),
                    new RigidPose(new Vector3(4.5f, 0, 0)));
                break;
        }
    }

    private static AnyShape Tiles()
    {
        var parts = new CompoundPart[10];
        for (int i = 0; i < 10; i++)
            parts[i] = new CompoundPart(ConvexShape.Box(new Vector3(0.5f)), new RigidPose(new Vector3(i, 0, 0)));
        return AnyShape.Of(new CompoundShape(parts));
    }
}
