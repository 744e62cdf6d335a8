using System.Text;
using Gjk.Demo.Study.Plan;
using Gjk.Demo.View;

namespace Gjk.Demo.Tests.Study;

public sealed class PlacementTests
{
    private static readonly ConvexShape[] Shapes =
    [
        ConvexShape.Box(new Vector3(0.4f, 0.3f, 0.5f)), ConvexShape.Sphere(0.4f), ConvexShape.Capsule(0.2f, 0.3f),
        ConvexShape.Cylinder(0.3f, 0.4f), ConvexShape.Cone(0.4f, 0.4f),
            ConvexShape.Ellipsoid(new Vector3(0.2f, 0.5f, 0.4f)),
        ConvexShape.Mesh(
            [new Vector3(-0.4f, -0.4f, 0), new Vector3(0.5f, -0.3f, 0.1f), new Vector3(0, 0.5f, -0.3f),
                new Vector3(0, 0, 0.6f)]),
    ];

    private static readonly float[] Gaps = [-0.1f, -0.03f, -0.001f, 1e-6f, 0.01f, 0.02f, 0.3f];

    [Fact]
    public void TheLibraryAnswersTheGapThatWasAskedFor()
    {
        var turn = Quaternion.CreateFromYawPitchRoll(0.3f, 0.7f, -0.2f);
        int met = 0, all = 0;
        foreach (ConvexShape a in Shapes)
        {
            foreach (ConvexShape b in Shapes)
            {
                var place = new Placement(new PairPlan("pair", a, Quaternion.Identity, b, turn), Vector3.UnitX);
                foreach (float gap in Gaps)
                {
                    float at = place.Position(gap), distance = place.Distance(at);
                    QueryRecord record = QueryRecord.Parse(place.Record(at));
                    float again = ConvexQuery.SignedDistance(record.A, record.PoseA, record.B, record.PoseB).Distance;
                    Assert.Equal(distance, again);
                    Assert.True(Math.Abs(distance - gap) <= 1e-7f, $"{distance:R} for {gap:R}");

                    // Answers are rounded, so that those of neighbours may be out of order by so much.
                    const float rounding = 1e-9f;
                    foreach (float beside in (float[])[MathF.BitDecrement(at), MathF.BitIncrement(at)])
                    {
                        float error = Math.Abs(distance - gap), other = Math.Abs(place.Distance(beside) - gap);
                        Assert.True(other >= error - rounding, $"{gap:R}: {error} at {at:R}, {other} at {beside:R}");
                    }

                    all++;
                    if (distance == gap) met++;
                }
            }
        }

        Assert.True(met > all / 2, $"{met} of {all} gaps are met to the last bit");
    }

    [Fact]
    public void AnOverlapThatIsTooDeepIsRefused()
    {
        var pair = new PairPlan("pair", Shapes[1], Quaternion.Identity, Shapes[1], Quaternion.Identity);
        Assert.Throws<RefusedException>(() => new Placement(pair, Vector3.UnitX).Position(-0.9f));
    }

    [Theory]
    [InlineData("box", true)]
    [InlineData("sphere", true)]
    [InlineData("capsule", true)]
    [InlineData("hull 24", false)]
    public void CollidersLieAroundTheirShapesOrInThem(string name, bool isAround)
    {
        Assert.True(Collider.IsKnown(name));
        foreach (ConvexShape shape in Shapes)
        {
            ConvexShape collider = Collider.Of(shape, name);
            for (int i = 0; i < 200; i++)
            {
                (double sin, double cos) = Math.SinCos(2.4 * i);
                double y = 1 - 2 * (i + 0.5) / 200, ring = Math.Sqrt(1 - y * y);
                var direction = new Double3(ring * cos, y, ring * sin);
                double more = Double3.Dot(direction, SupportSamples.Support(collider, direction))
                    - Double3.Dot(direction, SupportSamples.Support(shape, direction));

                // Spheres and capsules hold sampled points of round shapes, between which the shapes bulge a little.
                Assert.True(isAround ? more > -0.01 : more < 1e-6, $"{name}: {more}");
            }
        }
    }

    [Fact]
    public void ThePlanSaysHowManyTrialsThereAre()
    {
        StudyPlan plan = Gjk.Demo.Study.StudyCommand.LoadPlan(null, CancellationToken.None);
        Assert.Equal(3 * (4 + 4 * 7 + 3) + 6, StudyPlanFile.TrialsOf(plan));
        int done = Gjk.Demo.Study.Simulate.Simulation.Run(plan, new(), people: 2, seed: 1).Count();
        Assert.Equal(2 * StudyPlanFile.TrialsOf(plan), done);
        Assert.Equal(12, plan.Id.Length);
        byte[] other = Encoding.UTF8.GetBytes(PageText.Asset("default.plan.json") + " ");
        Assert.NotEqual(plan.Id, StudyPlanFile.Parse("other", other).Id);
    }
}
