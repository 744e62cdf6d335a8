namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Rays parallel to a side of a cone, where the quadratic loses its square.</summary>
public class RayConeTests
{
    /// <summary>Every point of the ray is looked at in small steps: the first that is inside follows the hit within one
    /// step, and where there is none, the ray misses or only grazes.</summary>
    [Theory]
    [InlineData(2, 1)]
    [InlineData(1, 1)]
    [InlineData(3, 2)]
    [InlineData(0.5f, 1)]
    public void AParabolaIsEnteredOnce(float radius, float halfHeight)
    {
        const double step = 1.0 / 256;
        int hits = 0, count = Budget.Count(400);
        double k = radius / (2.0 * halfHeight);
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            Vector3 origin = new Vector3(rng.Below(15) - 7, rng.Below(15) - 7, rng.Below(15) - 7) / 2;
            float down = 2 * halfHeight * (rng.Below(2) * 2 - 1), out0 = radius * (rng.Below(2) * 2 - 1);
            Vector3 direction = rng.Below(2) == 0 ? new Vector3(out0, down, 0) : new Vector3(0, down, out0);
            RayCastResult r = ConvexQuery.RayCast(
                ConvexShape.Cone(radius, halfHeight), RigidPose.Identity, origin, direction);
            Double3 unit = (Double3)direction * (1.0 / direction.Length());
            double first = double.PositiveInfinity, closest = double.PositiveInfinity;
            for (double t = 0; t < 24 && first > t; t += step)
            {
                Double3 p = origin + unit * t;
                double side = Math.Sqrt(p.X * p.X + p.Z * p.Z) - k * (halfHeight - p.Y);
                double outside = Math.Max(side, Math.Abs(p.Y) - halfHeight);
                closest = Math.Min(closest, outside);
                if (outside <= 1e-12) first = t;
            }

            string what = $"seed {i}: {origin} {direction}: {r}, truly {first} (nearest {closest})";
            if (r.IsHit) hits++;
            if (first == 0 && r.Status != CastStatus.OverlappingAtStart)
            {
                // From the surface it goes in or misses.
                Double3 ahead = origin + unit * (step / 64);
                double round = Math.Sqrt(ahead.X * ahead.X + ahead.Z * ahead.Z) - k * (halfHeight - ahead.Y);
                double inside = -Math.Max(round, Math.Abs(ahead.Y) - halfHeight);
                Assert.True(closest > -1e-12 && r.IsHit == inside > 1e-9, what);
                continue;
            }

            if (first < 24) Assert.True(r.IsHit && Math.Abs(r.Distance - first + step / 2) <= step / 2 + 1e-6, what);
            else Assert.True(!r.IsHit || closest < step, what);
        }

        Assert.InRange(hits, 0.01 * count, 0.7 * count);
    }
}
