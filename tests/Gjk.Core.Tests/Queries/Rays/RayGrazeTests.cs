using System;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Rays along faces that a quarter turn in floats leaves a rounding off level.</summary>
public class RayGrazeTests
{
    private static readonly Quaternion Quarter = new(0.70710677f, 0, 0, 0.70710677f);

    [Fact]
    public void AFlatBoxIsMetAtItsEdge()
    {
        ConvexShape flat = ConvexShape.Box(new Vector3(1, 2, 0));
        var pose = new RigidPose(Quarter, new Vector3(5, 0, 1));
        RayCastResult ray = ConvexQuery.RayCast(flat, pose, default, new Vector3(10, 0, 2));
        if (ray.IsHit) Assert.Equal(Math.Sqrt(16 + 0.64), ray.Distance, 1e-6f);
        CastResult cast = ConvexQuery.Cast(
            ConvexShape.Point(), RigidPose.Identity, default, flat, pose, new Vector3(-10, 0, -2));
        if (cast.IsHit) Assert.Equal(0.4f, cast.Fraction, 1e-6f);
        CastResult along = ConvexQuery.Cast(
            ConvexShape.Box(new Vector3(1, 0.0007941765f, 1)), new RigidPose(Quarter, Vector3.Zero), default,
            ConvexShape.Point(), new RigidPose(new Vector3(-1, 1, -4.086669f)), new Vector3(0, 0, 8.171749f));
        if (along.IsHit) Assert.Equal(0.5f, along.Fraction, 1e-3f);
    }

    /// <summary>What the start says is what Contains and the depth say, on faces, edges and corners of turned bodies.</summary>
    [Fact]
    public void AStartOnAFaceIsWhatContainsSays()
    {
        int starts = 0;
        for (int i = 0; i < Budget.Count(4000); i++)
        {
            var rng = new Rng((ulong)i);
            var half = new Vector3(1 + rng.Below(3), 1 + rng.Below(3), rng.Below(4)) / 2;
            ConvexShape shape = i % 2 == 0 ? ConvexShape.Box(half)
                : ConvexShape.Mesh([.. TestShape.Corners(half), new Vector3(0, 0, half.Z + 1)]);
            var pose = new RigidPose(Quarter, Half(rng, 6));
            Vector3 origin = Half(rng, 6), direction = Half(rng, 4);
            if (direction == Vector3.Zero) continue;
            RayCastResult r = ConvexQuery.RayCast(shape, pose, origin, direction);
            bool isIn = ConvexQuery.Contains(shape, pose, origin);
            float depth = -ConvexQuery.SignedDistance(shape, pose, origin).Distance;
            Assert.True((depth > 0) == (r.Status == CastStatus.OverlappingAtStart), $"seed {i}: {depth:R}, {r}");
            Assert.True(!isIn || r.Status == CastStatus.Miss || r.Distance == 0, $"seed {i}: {r}");
            if (isIn) starts++;
            if (r.Status != CastStatus.Hit) continue;
            float before = r.Distance - 1e-3f;
            Vector3 outside = origin + Vector3.Normalize(direction) * before;
            bool isEarly = before > 0 && ConvexQuery.SignedDistance(shape, pose, outside).Distance < -1e-6f;
            Assert.False(isEarly, $"seed {i}: {r}");
        }

        Assert.InRange(starts, 40, 3000);
    }

    private static Vector3 Half(Rng rng, int most) =>
        new Vector3(rng.Below(2 * most + 1) - most, rng.Below(2 * most + 1) - most, rng.Below(2 * most + 1) - most) / 2;
}
