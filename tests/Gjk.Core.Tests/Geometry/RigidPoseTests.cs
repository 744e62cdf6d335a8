namespace Gjk.Core.Tests.Geometry;

/// <summary>What a pose accepts, and where it puts a point.</summary>
public class RigidPoseTests
{
    /// <summary>Ratio: a rounding to float (2^-24), and one to double of each part.</summary>
    private const double Rounding = 1.1 / (1 << 24);

    [Theory]
    [InlineData(1, true)]
    [InlineData(1 - 0.99e-3, true)]
    [InlineData(1 + 0.99e-3, true)]
    [InlineData(1 - 1.01e-3, false)]
    [InlineData(1 + 1.01e-3, false)]
    [InlineData(0, false)]
    [InlineData(2, false)]
    public void AQuaternionMayBeAThousandthOffUnitLength(double length, bool isAccepted)
    {
        var rng = new Rng(1);
        for (int i = 0; i < 200; i++)
        {
            Quaternion rotation = rng.Rotation() * (float)length;
            if (isAccepted) Assert.Equal(rotation, new RigidPose(rotation, Vector3.One).Rotation);
            else Assert.Throws<ArgumentOutOfRangeException>(() => new RigidPose(rotation, Vector3.One));
        }
    }

    [Fact]
    public void APointIsPlacedToFloatRounding()
    {
        var rng = new Rng(2);
        for (int i = 0; i < 500; i++)
        {
            var pose = new RigidPose(rng.Rotation() * rng.Float(0.9995, 1.0005), rng.Vector(-100, 100));
            Vector3 local = rng.Vector(-100, 100), world = pose.TransformPoint(local);
            Fraction[] exact = new ExactPose(pose).Place(local);
            float[] found = [world.X, world.Y, world.Z];
            for (int k = 0; k < 3; k++)
            {
                double allowed = Rounding * Math.Abs(found[k]) + 1e-13;
                Assert.True((exact[k] - found[k]).Absolute <= allowed, $"{pose} puts {local} at {world}");
            }
        }
    }

    /// <summary>Nine numbers near the exact ones, and the inverse undoes the rotation.</summary>
    [Fact]
    public void ARotationMatrixIsExactToDoubleRoundingWhateverTheLengthOfTheQuaternion()
    {
        var rng = new Rng(3);
        for (int i = 0; i < 500; i++)
        {
            var pose = new RigidPose(rng.Rotation() * rng.Float(0.9995, 1.0005), Vector3.Zero);
            var exact = new ExactPose(pose);
            var matrix = new RotationD(pose.Rotation);
            double[] numbers =
            [
                matrix.M00, matrix.M01, matrix.M02, matrix.M10, matrix.M11, matrix.M12, matrix.M20, matrix.M21,
                matrix.M22,
            ];
            Assert.All(
                Enumerable.Range(0, 9), k => Assert.True((exact[k / 3, k % 3] - numbers[k]).Absolute <= 1e-15));
            Double3 v = rng.Vector(-1, 1);
            Assert.Equal(0, (matrix.InverseRotate(matrix.Rotate(v)) - v).Length, 1e-15);
        }
    }

    [Fact]
    public void ThePoseThatWasNeverMadeIsNotTheIdentity()
    {
        Assert.NotEqual(RigidPose.Identity, default);
        Assert.Equal(RigidPose.Identity, new RigidPose(Vector3.Zero));
        Assert.Equal(RigidPose.Identity.GetHashCode(), new RigidPose(Vector3.Zero).GetHashCode());
    }
}
