namespace Gjk.Core.Tests.Regression;

/// <summary>A point inside four corners nearly on a line: the flag was right, but the common point lay 1.3e-7 of the
/// size off, since the tetrahedron's volumes had lost their digits to cancellation. Found by fuzz.</summary>
public class NeedleContactTests
{
    [Fact]
    public void TheCommonPointLiesOnBoth()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(2000); seed++)
        {
            var rng = new Rng(seed);
            Vector3 axis = rng.Vector(-1, 1);
            var corners = new Vector3[4];
            for (int i = 0; i < 4; i++)
                corners[i] = axis * rng.Float(-1, 1) + rng.UnitVector() * rng.LogFloat(1e-9, 1e-3);
            ConvexShape needle = ConvexShape.Mesh(corners);
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-1, 1));
            Vector3 at = Vector3.Transform(
                (corners[0] + corners[1] + corners[2] + corners[3]) / 4, pose.Rotation) + pose.Position;
            DistanceResult r = ConvexQuery.Distance(needle, pose, ConvexShape.Point(), new RigidPose(at));
            if (r.IsOverlapping)
            {
                Assert.True(
                    r.LocalPointB.Length() <= Accuracy.WitnessScale * 2, $"seed {seed}: {r.LocalPointB.Length():R}");
            }
        }
    }
}
