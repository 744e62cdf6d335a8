namespace Gjk.Core.Tests.Geometry;

/// <summary>Poses after each other, undone, and read from matrices.</summary>
public class PoseOperationTests
{
    /// <summary>Length: a few roundings to float of numbers up to 300.</summary>
    private const float Close = 1e-4f;

    [Fact]
    public void OneAfterTheOtherIsTheProduct()
    {
        var rng = new Rng(11);
        for (int i = 0; i < 300; i++)
        {
            RigidPose parent = Pose(rng), child = Pose(rng);
            Vector3 local = rng.Vector(-100, 100);
            Near(parent.TransformPoint(child.TransformPoint(local)), (parent * child).TransformPoint(local));
            Near(
                parent.TransformDirection(child.TransformDirection(local)),
                (parent * child).TransformDirection(local));
            Assert.Equal(1, (parent * child).Rotation.Length(), 1e-6f);
        }
    }

    [Fact]
    public void TheInverseUndoesIt()
    {
        var rng = new Rng(12);
        for (int i = 0; i < 300; i++)
        {
            RigidPose pose = Pose(rng), inverse = pose.Inverse();
            Vector3 local = rng.Vector(-100, 100), world = pose.TransformPoint(local);
            Near(local, inverse.TransformPoint(world));
            Near(local, pose.InverseTransformPoint(world));
            Near(local, pose.InverseTransformDirection(pose.TransformDirection(local)));
            Near(pose.InverseTransformDirection(local), inverse.TransformDirection(local));
            Near(Vector3.Zero, (pose * inverse).Position);
        }
    }

    [Fact]
    public void AMatrixIsReadAsItTransforms()
    {
        var rng = new Rng(13);
        for (int i = 0; i < 300; i++)
        {
            Matrix4x4 matrix = Matrix4x4.CreateFromQuaternion(rng.Rotation())
                * Matrix4x4.CreateTranslation(rng.Vector(-100, 100));
            Vector3 local = rng.Vector(-100, 100);
            Near(Vector3.Transform(local, matrix), RigidPose.FromMatrix(matrix).TransformPoint(local));
        }
    }

    [Fact]
    public void WhatIsNoPoseIsRefused()
    {
        Matrix4x4 turned = Matrix4x4.CreateRotationX(1), projected = turned;
        projected.M44 = 2;
        Matrix4x4[] bad =
        [
            default, turned * Matrix4x4.CreateScale(1.01f), Matrix4x4.CreateScale(1, 1, -1), projected,
            Matrix4x4.CreateScale(2, 2, 0.5f), turned * float.NaN,
            new(1, 0.1f, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
        ];
        foreach (Matrix4x4 matrix in bad)
            Assert.Equal("matrix", Assert.Throws<ArgumentException>(() => RigidPose.FromMatrix(matrix)).ParamName);
        var far = new RigidPose(Vector3.One * 3e38f);
        Assert.Throws<ArgumentOutOfRangeException>(() => far * far);
        Assert.Throws<ArgumentOutOfRangeException>(() => far * default(RigidPose));
        Assert.Throws<ArgumentOutOfRangeException>(() => default(RigidPose).Inverse());
    }

    private static RigidPose Pose(Rng rng) => new(rng.Rotation() * rng.Float(0.9995, 1.0005), rng.Vector(-100, 100));

    private static void Near(Vector3 expected, Vector3 actual) =>
        Assert.True(Vector3.Distance(expected, actual) < Close, $"{actual} for {expected}");
}
