namespace Gjk.Core.Tests.Queries;

/// <summary>A user's support is asked in directions that are finite and not zero, as <see cref="ISupportMap"/>
/// promises: by every query, for pairs at random and for those that make a direction vanish.</summary>
public class SupportDirectionTests
{
    private const int Rounds = 4;

    private static readonly PlainKind[] Kinds = Enum.GetValues<PlainKind>();

    /// <summary>Exponents of ten: from the least to the largest size inside the promise.</summary>
    public static TheoryData<int> Scales => [-30, -20, -8, 0, 8, 20, 30];

    [Theory]
    [MemberData(nameof(Scales))]
    public void ShapesAtRandomPlaces(int exponent) =>
        ForAllPairs(exponent, (rng, scale) => rng.UnitVector() * (rng.Float(0, 3) * scale), turned: true);

    [Theory]
    [MemberData(nameof(Scales))]
    public void ShapesWithOneCentre(int exponent) => ForAllPairs(exponent, (_, _) => default, turned: false);

    /// <summary>On an axis, at a corner, on a face: where a feature passes through the origin.</summary>
    [Theory]
    [MemberData(nameof(Scales))]
    public void ShapesThatAreLevel(int exponent) => ForAllPairs(
        exponent,
        (rng, scale) => new Vector3(rng.Below(5) - 2, rng.Below(5) - 2, rng.Below(5) - 2) * (0.5f * scale),
        turned: false);

    [Theory]
    [MemberData(nameof(Scales))]
    public void Points(int exponent)
    {
        float scale = MathF.Pow(10, exponent);
        for (int seed = 0; seed < Budget.Few(20 * Rounds); seed++)
        {
            var rng = new Rng((ulong)seed);
            foreach (PlainKind kind in Kinds)
            {
                var shape = new CheckedShape<PlainShape>(new PlainShape(kind, scale, seed % 3 == 0));
                RigidPose pose = seed % 2 == 0 ? RigidPose.Identity : Generators.Pose(rng, rng.Vector(-1, 1) * scale);
                Vector3 away = (seed % 4) switch
                {
                    0 => rng.Vector(-1, 1) * scale,
                    1 => new Vector3(rng.Below(5) - 2, rng.Below(5) - 2, rng.Below(5) - 2) * (0.5f * scale),
                    2 => default,
                    _ => rng.UnitVector() * (scale * rng.LogFloat(1e-20, 1)),
                };
                Asked($"{kind} of {scale}, seed {seed}", says =>
                {
                    EveryQuery.AskPoint(shape, pose, pose.Position + away, scale, rng, says);
                    EveryQuery.AskPoint(
                        new Scaled<CheckedShape<PlainShape>>(shape, new Vector3(1, -0.5f, 2)), pose,
                        pose.Position + away, scale, rng, says);
                });
            }
        }
    }

    /// <summary>Along a plane that neither comes nor goes, at a rate of -0, the step is all that is left, not
    /// -infinity.</summary>
    [Fact]
    public void APlaneThatRests()
    {
        var turn = new Vector3(-0.41994745f, 0.4815196f, -0.76927435f);
        var a = new CheckedShape<PlainShape>(new PlainShape(PlainKind.Segment, 1, hasIds: false));
        var b = new CheckedShape<PlainShape>(new PlainShape(PlainKind.Point, 1, hasIds: false));
        var beside = new RigidPose(new Vector3(1.4657332e-6f, 0, 0));
        CastResult result = ConvexQuery.TimeOfImpact(
            a, new RigidMotion(RigidPose.Identity, default, turn), b, new RigidMotion(beside, default));
        Assert.True(result.Status is CastStatus.Hit or CastStatus.Miss, result.ToString());
    }

    private static void ForAllPairs(int exponent, Func<Rng, float, Vector3> place, bool turned)
    {
        float scale = MathF.Pow(10, exponent);
        for (int seed = 0; seed < Budget.Few(Rounds); seed++)
        {
            var rng = new Rng((ulong)seed);
            foreach (PlainKind kind in Kinds)
            {
                PlainKind other = Kinds[rng.Below(Kinds.Length)];
                RigidPose at = new(turned ? rng.Rotation() : Quaternion.Identity, rng.Vector(-1, 1) * scale);
                RigidPose to = new(turned ? rng.Rotation() : Quaternion.Identity, at.Position + place(rng, scale));
                Asked(
                    $"{kind} and {other} of {scale}, seed {seed}",
                    says => AskDecorated(kind, at, other, to, scale, rng, says));
            }
        }
    }

    private static void AskDecorated(
        PlainKind kind, RigidPose at, PlainKind other, RigidPose to, float scale, Rng rng, Action<string> says)
    {
        // Half of them of the same size, the others of sizes that differ by up to twelve orders of magnitude.
        double size = rng.Below(2) == 0 ? scale : scale * rng.LogFloat(1e-12, 1);
        var a = new CheckedShape<PlainShape>(new PlainShape(kind, scale, rng.Below(2) == 0));
        var b = new CheckedShape<PlainShape>(new PlainShape(other, size, rng.Below(2) == 0));
        var box = new BoxShape(new Vector3(scale));
        WarmStart stale = default;
        EveryQuery.Ask(a, at, b, to, ref stale, scale, rng, says);
        EveryQuery.Ask(a, at, box, to, ref stale, scale, rng, says);
        EveryQuery.Ask(box, at, b, to, ref stale, scale, rng, says);
        var rounded = new Rounded<CheckedShape<PlainShape>>(a, 0.5f * scale);
        EveryQuery.Ask(rounded, at, b, to, ref stale, scale, rng, says);
        EveryQuery.Ask(b, at, rounded, to, ref stale, scale, rng, says);
        var scaled = new Scaled<CheckedShape<PlainShape>>(b, new Vector3(0.5f, -1, 2));
        EveryQuery.Ask(scaled, at, a, to, ref stale, scale, rng, says);
        var placed = new Placed<CheckedShape<PlainShape>>(a, new RigidPose(new Vector3(scale, 0, 0)));
        EveryQuery.Ask(box, at, placed, to, ref stale, scale, rng, says);
    }

    private static void Asked(string label, Action<Action<string>> ask)
    {
        string query = "";
        try
        {
            ask(name => query = name);
        }
        catch (BrokenPromiseException e)
        {
            Assert.Fail($"{label}: {query}: {e.Message}");
        }
    }
}
