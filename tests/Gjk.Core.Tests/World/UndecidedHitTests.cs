namespace Gjk.Core.Tests.World;

/// <summary>What a search left open at its limit may be a hit from its fraction on: a scene does not miss it in
/// silence. No query of the library's own shapes is known to end so, hence the answers are made here.</summary>
public class UndecidedHitTests
{
    private static readonly CastResult LateHit =
        new(CastStatus.Hit, 0.5f, Vector3.One, Vector3.UnitX, 3);

    private static readonly CastResult Undecided = CastResult.Nothing(CastStatus.IterationLimit, 0.25f, 128);

    [Fact]
    public void ACastThatIsUndecidedBeforeTheFirstHitIsTold()
    {
        var first = new FirstCastHit(null!, default);
        Assert.Equal((-1, CastStatus.Miss), (first.Hit.Id, first.Hit.Status));
        first.KeepIfFirst(7, new CastHit(LateHit));
        first.KeepIfFirst(9, new CastHit(Undecided));
        Assert.Equal((9, CastStatus.IterationLimit, 0.25f), (first.Hit.Id, first.Hit.Status, first.Hit.Fraction));
        Assert.False(first.Hit.IsHit);

        // A hit before it, or at the same fraction with a lower number, comes first.
        first.KeepIfFirst(8, new CastHit(new CastResult(CastStatus.Hit, 0.25f, default, default, 1)));
        Assert.Equal(8, first.Hit.Id);
        first.KeepIfFirst(1, new CastHit(Undecided));
        Assert.Equal(1, first.Hit.Id);
        first.KeepIfFirst(
            2, new CastHit(new CastResult(CastStatus.OverlappingAtStart, 0, default, Vector3.UnitX, 1, 0.5f)));
        Assert.Equal(2, first.Hit.Id);
        first.KeepIfFirst(0, new CastHit(Undecided));
        first.KeepIfFirst(0, new CastHit(CastResult.Nothing(CastStatus.Miss, 1, 1)));
        first.KeepIfFirst(0, new CastHit(CastResult.Nothing(CastStatus.InvalidShape, float.NaN, 1)));
        Assert.Equal(2, first.Hit.Id);
    }

    [Fact]
    public void ARayThatIsUndecidedBeforeTheFirstHitIsTold()
    {
        var ray = new RayQuery(Vector3.Zero, Vector3.UnitX, 9);
        var first = new FirstRayHit(null!, ray, default, default, RaySides.Both);
        first.KeepIfFirst(7, new RayHit(new RayCastResult(CastStatus.Hit, 4, Vector3.One, -Vector3.UnitX, 0)));
        first.KeepIfFirst(9, new RayHit(RayCastResult.Nothing(CastStatus.IterationLimit, 2, 128)));
        Assert.Equal((9, CastStatus.IterationLimit, 2f), (first.Hit.Id, first.Hit.Status, first.Hit.Distance));
        first.KeepIfFirst(3, new RayHit(new RayCastResult(CastStatus.Hit, 1, Vector3.One, -Vector3.UnitX, 0)));
        first.KeepIfFirst(2, new RayHit(RayCastResult.Nothing(CastStatus.Miss, 9, 1)));
        Assert.Equal(3, first.Hit.Id);
    }
}
