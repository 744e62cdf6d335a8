namespace Gjk.Core.Tests.Concave;

/// <summary>What double is certain of is what the exact query says of a triangle and a point, however thin the triangle
/// is and however far away.</summary>
public class TriangleReachTests
{
    [Fact]
    public void WhatIsCertainIsExact()
    {
        int within = 0, beyond = 0;
        for (int seed = 0; seed < Budget.Count(20_000); seed++)
        {
            var random = new Rng((ulong)seed);
            Vector3 at = random.OneIn(3) ? random.Vector((float)random.Magnitude(1, 1e4)) : Vector3.Zero;
            float size = (float)random.Magnitude(1e-3, 1e3);
            Vector3 a = at + random.Vector(size), b = at + random.Vector(size), c = at + random.Vector(size);
            float along = random.Float(-0.5, 1.5);
            if (random.OneIn(3)) c = Vector3.Lerp(a, b, along) + random.Vector(size * (float)random.Magnitude(1e-8, 1));
            float u = random.OneIn(3) ? 0 : random.Float(0, 1), v = random.OneIn(3) ? 0 : random.Float(0, 1 - u);
            double off = size * random.Magnitude(1e-16, 10);
            Double3 on = (Double3)a + ((Double3)b - a) * u + ((Double3)c - a) * v;
            var point = (Vector3)(on + random.Direction() * off);
            double room = off * random.Magnitude(0.3, 3);
            var reach = new TriangleReach(a, b, c, point);
            double exact = ConvexQuery.Distance(
                ConvexShape.Triangle(a, b, c), RigidPose.Identity, ConvexShape.Point(), new RigidPose(point)).Distance;
            string what = $"{seed}: {exact:R} and {room:R}";
            Assert.True(reach.Size >= Math.Max((point - a).Length(), (point - b).Length()) * (1 - 1e-6), what);
            if (reach.IsWithin(room))
            {
                within++;
                Assert.True(exact <= room * (1 + 1e-7), what);
            }

            if (reach.IsBeyond(room))
            {
                beyond++;
                Assert.True(exact >= room * (1 - 1e-7), what);
            }
        }

        Assert.True(within > Budget.Count(1000) && beyond > Budget.Count(1000), $"{within} within, {beyond} beyond");
    }

    /// <summary>The normal of a triangle on a line, but for rounding, is rounding alone.</summary>
    [Fact]
    public void APointOnANeedleIsNotBeyondIt()
    {
        for (int seed = 0; seed < Budget.Count(20_000); seed++)
        {
            var random = new Rng((ulong)seed);
            Double3 Any() => random.Direction() * random.Range(0.5, 1);
            Double3 a = Any(), b = Any(), c = a + (b - a) * random.Range(0, 1);
            Double3 point = a + (b - a) * random.Range(0, 1);
            Assert.False(new TriangleReach(a, b, c, point).IsBeyond(1e-9), $"{seed}");
        }
    }
}
