namespace Gjk.Core.Tests.World;

/// <summary>What gets deeper into flush parts is stopped by the surface of their union, not by a seam of
/// it.</summary>
public class SeamStopTests
{
    /// <summary>A cone's rim, slant line and tip, which the side of the next tile would turn aside.</summary>
    [Fact]
    public void ATipThatGetsDeeperAtASeamIsStoppedByTheFloor()
    {
        var scene = new CollisionScene();
        foreach (int side in new[] { -1, 1 })
        {
            var half = ConvexShape.Box(new Vector3(4, 0.5f, 8));
            scene.Add(half, new RigidPose(new Vector3(4 * side, -0.5f, 0)));
        }

        var floor = ConvexShape.HalfSpace(Vector3.UnitY, 0);
        var cone = ConvexShape.Cone(0.3f, 0.4f);
        int hits = 0;
        for (int seed = 0; seed < 1000; seed++)
        {
            var random = new Rng((ulong)seed);
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Of(0, 0.5f, 1, 2, 3))
                * Quaternion.CreateFromAxisAngle(Vector3.UnitX, random.Of(1.2f, 1.8f, 2.4f, MathF.PI));
            float lowest = ConvexQuery.SignedDistance(
                floor, RigidPose.Identity, cone, new RigidPose(turn, Vector3.UnitY)).Distance - 1;
            float deep = random.Of(0, 1e-5f, 1e-4f, 5e-4f), side = random.Of(0, 0.4f, -0.8f);
            Vector3 way = new(MathF.Cos(side), -random.Of(1e-5f, 1e-4f, 1e-3f, 1e-2f), MathF.Sin(side));
            way *= random.Of(0.2f, 0.5f, 1, 3);
            bool isHit = scene.TryFindCastHit(
                cone, new RigidPose(turn, new Vector3(-0.1f, -lowest - deep, 0.03f)), way, out CastHit hit,
                options: CastOptions.OnlyDeeper(random.Of(1e-5f, 1e-4f, 1e-3f)));
            if (isHit) hits++;
            Assert.True(!isHit || hit.Result.Normal.Y < -0.99f, $"{seed}: {deep} deep, by {way}: {hit}");
        }

        Assert.InRange(hits, 100, 900);
    }

    /// <summary>What a cast is stopped by stops a time of impact too, and a turn on the spot changes nothing.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.5f)]
    public void WhatGetsDeeperInTimeIsStoppedAsByOneBox(float turn)
    {
        CompoundPart[] parts = [.. Enumerable.Range(-16, 32).Select(i => new CompoundPart(
            ConvexShape.Box(new Vector3(0.25f, 1, 8)), new RigidPose(new Vector3(0.5f * i + 0.25f, -1, 0))))];
        var floor = AnyShape.Of(new CompoundShape(parts));
        var body = AnyShape.Of(ConvexShape.Box(new Vector3(0.5f)));
        var scratch = new ConcaveScratch();
        var still = new RigidMotion(RigidPose.Identity, Vector3.Zero);
        int hits = 0;
        for (int seed = 0; seed < 500; seed++)
        {
            var random = new Rng((ulong)seed);
            float allowed = random.Of(1e-4f, 1e-3f), length = random.Of(0.1f, 0.3f, 1, 2, 4), side = random.Float(0, 2);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Of(0, 0.3f, 0.8f));
            var from = new RigidPose(yaw, new Vector3(0.03f, 0.5f - random.Of(0, 1e-6f, 1e-5f, 5e-5f), 0.1f));
            Vector3 way = new(
                length * MathF.Cos(side), -random.Of(1.5f, 2, 5, 20) * allowed, length * MathF.Sin(side));
            var motion = new RigidMotion(from, way, new Vector3(0, turn, 0));
            CastOptions options = CastOptions.OnlyDeeper(allowed);
            CastHit hit = ConcaveQuery.TimeOfImpact(body, motion, floor, still, scratch, options: options);
            if (hit.IsHit) hits++;
            Assert.True(!hit.IsHit || hit.Result.Normal.Y < -0.99f, $"{seed}: {from} by {way}: {hit}");
            hit = ConcaveQuery.TimeOfImpact(floor, still, body, motion, scratch, options: options);
            Assert.True(!hit.IsHit || hit.Result.Normal.Y > 0.99f, $"{seed}, swapped: {from} by {way}: {hit}");
        }

        Assert.InRange(hits, turn == 0 ? 500 : 300, 500);
    }
}
