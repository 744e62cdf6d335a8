namespace Gjk.Core.Tests.Concave;

/// <summary>A ray that comes down exactly on a seam between flush tiles meets their top, and not the side of a tile
/// that the next one covers.</summary>
public class RayTileTests
{
    private readonly ConcaveScratch _scratch = new();

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void TheTopIsMet(bool isScene)
    {
        AnyShape tile = AnyShape.Solid(ConcaveShapes.Box(new Vector3(1, 0.5f, 1)));
        var places = new List<Vector3> { new(1, -0.5f, 1), new(1, -0.5f, -1), new(-1, -0.5f, 1), new(-1, -0.5f, -1) };
        var scene = new CollisionScene();
        foreach (Vector3 at in places) scene.Add(tile, new RigidPose(at), new ObjectSettings(isStatic: true));
        AnyShape compound = AnyShape.Of(new CompoundShape([.. places.Select(at => new CompoundPart(tile, new(at)))]));
        for (int i = 0; i < Budget.Count(400); i++)
        {
            var rng = new Rng((ulong)i);

            // Eighths and small powers of two, so that the ray is on the seam exactly.
            var target = new Vector3(0, 0, i % 4 == 0 ? 0 : (rng.Below(17) - 8) / 8f);
            if (i % 2 == 1) target = new Vector3(target.Z, 0, target.X);
            var direction = new Vector3((rng.Below(9) - 4) / 4f, -(1 + rng.Below(4)) / 4f, (rng.Below(9) - 4) / 4f);
            Vector3 origin = target - (direction * (1 << rng.Below(4)));
            RayHit hit = default;
            if (!isScene) hit = ConcaveQuery.RayCast(compound, RigidPose.Identity, origin, direction, _scratch);
            else Assert.True(scene.TryFindRayHit(new RayQuery(origin, direction), out hit));
            Assert.Equal(CastStatus.Hit, hit.Status);
            Assert.True(hit.Result.Normal.Y > 0.999f, $"{i}: {origin} {direction}: {hit}");
            Assert.Equal((target - origin).Length(), hit.Distance, 1e-5f);
        }
    }
}
