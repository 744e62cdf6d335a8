using System;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Regression;

/// <summary>
/// A body 1e-14 to 1e-10 beside another one's axis leaves it in the plane of that offset, whose direction kept a part
/// along the axis; normals were up to 1.5e-5 off unit length.
/// </summary>
public class UnitNormalTests
{
    [Fact]
    public void NormalsBesideTheAxisAreOfUnitLength()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(1000); seed++)
        {
            var rng = new Rng(81_000 + seed);
            Vector3 offset = rng.Direction() * rng.LogFloat(1e-15, 1e-9);
            var pose = new RigidPose(new Vector3(offset.X, rng.Float(-0.4, 0.4), offset.Z));
            TestShape a = Generators.Shape(rng, seed % 2 == 0 ? "cylinder" : "cone");
            TestShape b = Generators.Shape(rng, seed % 3 == 0 ? "capsule" : seed % 3 == 1 ? "cylinder" : "point");
            var pair = new TestPair($"seed {seed}", a, RigidPose.Identity, b, pose);
            foreach (DistanceResult r in new[] { pair.SignedDistance(), pair.Swapped.SignedDistance() })
            {
                double off = Math.Abs(((Vector3D)r.Normal).Length - 1);
                Assert.True(off <= 1e-7, $"{off}: {r}, {pair}");
            }
        }
    }
}
