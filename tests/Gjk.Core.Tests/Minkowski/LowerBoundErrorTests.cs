namespace Gjk.Core.Tests.Minkowski;

/// <summary>What rounding does to a lower bound: GjkTolerances.LowerBoundError is no sum of worst cases, so the worst
/// pose is looked for, by small changes that make the error larger.</summary>
public class LowerBoundErrorTests
{
    private const int Climbs = 5, Steps = 150_000;

    /// <summary>Long searches find 5.3 roundings at most. One that finds less than 3 would be worth nothing; above 6
    /// the constant would be too small.</summary>
    [Fact]
    public void TheWorstPoseThatIsFoundNeedsLittleMoreThanHalfOfIt()
    {
        double worst = 0;
        for (int climb = 0; climb < Climbs; climb++) worst = Math.Max(worst, Climb(new Rng((ulong)climb)));
        Assert.InRange(worst, 3 * RoundOff.Unit, 0.6 * GjkTolerances.LowerBoundError);
    }

    /// <summary>Size and distance of the centres are twice the size where shapes touch, and a size is 1.74 times the
    /// scale.</summary>
    [Fact]
    public void TheConstantFitsIntoThePromise() =>
        Assert.InRange(GjkTolerances.LowerBoundError * 2 * 1.74, 0, Accuracy.DistanceScale / 2);

    private static double Climb(Rng rng)
    {
        Setting best = Setting.Any(rng);
        double most = best.Error(), change = 0.3;
        for (int step = 0, since = 0; step < Steps; step++)
        {
            Setting next = step < Steps / 10 ? Setting.Any(rng) : best.Changed(rng, change);
            double error = next.Error();
            since = error > most ? 0 : since + 1;
            if (error > most) (best, most) = (next, error);
            if (since > Steps / 50) (change, since) = (change > 1e-7 ? change / 2 : 0.1, 0);
        }

        return most;
    }

    /// <summary>A corner of each of two shapes about their origins, and the normal of a plane between them.</summary>
    private readonly record struct Setting(
        Quaternion TurnA, Quaternion TurnB, Vector3 Between, Vector3 CornerA, Vector3 CornerB, Vector3 Normal)
    {
        public static Setting Any(Rng rng) => new(
            Turn(default, rng, 1), Turn(default, rng, 1), rng.Vector(-1, 1), rng.Vector(-1, 1), rng.Vector(-1, 1),
            rng.Vector(-1, 1));

        public Setting Changed(Rng rng, double change) => new(
            Turn(TurnA, rng, change), Turn(TurnB, rng, change), Between + rng.Vector(-change, change),
            CornerA + rng.Vector(-change, change), CornerB + rng.Vector(-change, change),
            Normal + rng.Vector(-change, change));

        /// <summary>How far the gap that the solvers compute is above the true one, as a part of what the constant is
        /// one of; 0 where the centres are further apart than shapes with these corners allow.</summary>
        public double Error()
        {
            var poseB = new RigidPose(TurnB, Between);
            var poseA = new RigidPose(TurnA, Vector3.Zero);
            PoseComposition.Compose(
                poseA, poseB, null, null, out RotationD rotationA, out RotationD rotation, out _, out _);
            Double3 normal = Normal, translation = rotationA.InverseRotate(Between);
            Double3 vertex = CornerA - (rotation.Rotate(CornerB) + translation);
            double gap = Double3.Dot(normal, vertex) * (1 / Math.Sqrt(normal.LengthSquared));

            // The same in 106 bits; A's frame is reached by the opposite rotation, of each half.
            VectorDD placed = VectorDD.ToWorld(poseB, (Double3)CornerB);
            var high = (Double3)placed;
            var low = (Double3)(placed - high);
            var back = new Quaternion(-TurnA.X, -TurnA.Y, -TurnA.Z, TurnA.W);
            VectorDD exact = (VectorDD)(Double3)CornerA - (VectorDD.Rotate(back, high) + VectorDD.Rotate(back, low));
            DoubleDouble squared = VectorDD.Dot(normal, normal), length = Math.Sqrt((double)squared);
            length = (length + squared / length) * 0.5;
            double error = (double)(gap - VectorDD.Dot(exact, normal) / length);
            double size = ((Double3)CornerA).Length + ((Double3)CornerB).Length, reach = 2 * size + Math.Abs(gap);
            return translation.Length <= size + Math.Abs(gap) ? error / reach : 0;
        }

        private static Quaternion Turn(Quaternion q, Rng rng, double change)
        {
            Vector3 v = rng.Vector(-change, change), w = rng.Vector(-change, change);
            double x = q.X + v.X, y = q.Y + v.Y, z = q.Z + v.Z, s = q.W + w.X;
            double unit = 1 / Math.Sqrt(x * x + y * y + z * z + s * s);
            return new Quaternion((float)(x * unit), (float)(y * unit), (float)(z * unit), (float)(s * unit));
        }
    }
}
