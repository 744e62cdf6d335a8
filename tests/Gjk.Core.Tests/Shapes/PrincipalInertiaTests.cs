namespace Gjk.Core.Tests.Shapes;

/// <summary>Principal moments and axes: they give back the tensor, and those that lie along the axes stay
/// there.</summary>
public class PrincipalInertiaTests
{
    [Fact]
    public void ThePrincipalMomentsGiveBackTheTensor()
    {
        for (ulong seed = 1; seed <= 400; seed++)
        {
            var random = new Rng(seed);
            Vector3 half = seed % 4 == 0
                ? new Vector3(1, 1, random.Float(1e-3, 2))
                : new Vector3(random.Float(1e-3, 2), random.Float(1e-3, 2), 1);
            MassProperties plain = ConvexShape.Box(half).GetMassProperties(3);
            MassProperties turned = plain.At(new RigidPose(random.Rotation(), random.Vector(2)));
            turned.GetPrincipalInertia(out Double3 moments, out Quaternion axes);
            double[] found = [moments.X, moments.Y, moments.Z], known =
                [plain.InertiaDiagonal.X, plain.InertiaDiagonal.Y, plain.InertiaDiagonal.Z];
            Array.Sort(found);
            Array.Sort(known);
            double size = known[2];
            for (int i = 0; i < 3; i++) Assert.True(Math.Abs(found[i] - known[i]) <= 4e-15 * size, $"{seed}: {i}");
            Assert.True(Math.Abs(axes.Length() - 1) < 1e-6f, $"{seed}: {axes}");

            // R diag(moments) Rᵀ, with the float quaternion that users get.
            var r = new RotationD(axes);
            Double3 x = r.InverseRotate(new Double3(1, 0, 0)), y = r.InverseRotate(new Double3(0, 1, 0));
            Double3 z = r.InverseRotate(new Double3(0, 0, 1));
            Double3 diagonal = new(Form(x, x), Form(y, y), Form(z, z)), rest = new(Form(x, y), Form(x, z), Form(y, z));
            Assert.True((diagonal - turned.InertiaDiagonal).Length <= 1e-6 * size, $"{seed}: {diagonal}");
            Assert.True((rest - turned.InertiaProducts).Length <= 1e-6 * size, $"{seed}: {rest}");

            double Form(in Double3 p, in Double3 q) => Double3.Dot(Double3.Multiply(p, moments), q);
        }
    }

    [Fact]
    public void MomentsAlongTheAxesStayWhereTheyAre()
    {
        foreach (ConvexShape shape in new[]
            {
                ConvexShape.Sphere(1), ConvexShape.Box(new Vector3(1, 2, 3)), ConvexShape.Cylinder(1, 2).AlongZ(),
                ConvexShape.Point(), ConvexShape.Box(new Vector3(1, 2, 3)).Placed(new RigidPose(new Vector3(1, 2, 3))),
            })
        {
            MassProperties mass = shape.GetMassProperties(2);
            mass.GetPrincipalInertia(out Double3 moments, out Quaternion axes);
            Assert.Equal((mass.InertiaDiagonal, Quaternion.Identity), (moments, axes));
        }
    }
}
