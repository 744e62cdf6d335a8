namespace Gjk.Core.Tests.Regression;

/// <summary>A sphere made with sine and cosine has a ring 1e-16 wide at its pole. The climb of the look-up stopped
/// there, and the support was the opposite pole; a ball 1 away gave InvalidShape.</summary>
public class PoleRingSupportTests
{
    [Fact]
    public void TheSupportIsNotTheOppositePole()
    {
        var hull = new ConvexHull(Sphere(6, 20));
        var direction = new Double3(-0.17, 0.83, -0.53);
        HullSupport.Find(hull.Cells, direction, out Double3 point);
        Assert.True(Double3.Dot(point, direction) > 0.9, $"{point}");
    }

    [Fact]
    public void ABallBesideItHasADistance()
    {
        ConvexShape sphere = ConvexShape.Mesh(Sphere(6, 20)), ball = ConvexShape.Sphere(0.5f);
        var rng = new Rng(4);
        for (int i = 0; i < 1000; i++)
        {
            // The faces lie up to 0.05 below the sphere of radius 1.
            var pose = new RigidPose(Quaternion.Identity, rng.UnitVector() * 2.5f);
            DistanceResult r = ConvexQuery.Distance(sphere, RigidPose.Identity, ball, pose);
            Assert.True(r.Status == GjkStatus.Separated, $"{r.Status} at {pose.Position}");
            Assert.InRange(r.Distance, 0.999f, 1.06f);
        }
    }

    [Theory]
    [InlineData("sphere")]
    [InlineData("egg")]
    [InlineData("capsule")]
    [InlineData("copies")]
    public void TheSupportIsAsFarAsTheCloud(string kind)
    {
        for (ulong seed = 0; seed < 150; seed++)
        {
            var random = new Rng(seed);
            Vector3[] cloud = kind switch
            {
                "egg" => Lathe.Egg(random),
                "capsule" => Lathe.Capsule(random),
                "copies" => Copies.OneFloatApart(random, Lathe.Sphere(random), 2),
                _ => Lathe.Sphere(random),
            };
            var hull = new ConvexHull(cloud);
            for (int i = 0; i < Budget.Count(100); i++)
            {
                Double3 d = random.Direction();
                HullSupport.Find(hull.Cells, d, out Double3 point);
                double height = Double3.Dot(point, d);
                foreach (Vector3 p in cloud)
                {
                    bool isFurther = Double3.Dot(p, d) > height + 1e-14;
                    Assert.False(isFurther, $"{kind}, seed {seed}, towards {d}: {point}, but {p} is further");
                }
            }
        }
    }

    private static Vector3[] Sphere(int rings, int perRing) =>
        Lathe.Sphere(new Trigonometry(InFloat: false), rings, perRing, seam: true);
}
