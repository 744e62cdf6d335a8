using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>What is deep in a flat floor slides along it.</summary>
public class LevelSlideTests
{
    private static readonly CastOptions NoDeeper = CastOptions.OnlyDeeper(1e-3f);

    /// <summary>Beside the deepest triangle of a flat field the way out of the next one leans, by less than what
    /// rounding hides of so short a way. Along the field a body gets no deeper, and down it is stopped.</summary>
    [Theory]
    [InlineData(true, 0)]
    [InlineData(false, 0)]
    [InlineData(false, 30)]
    [InlineData(true, 30)]
    public void ABodyThatIsDeepSlidesLevelOverAFlatField(bool isTilted, float away)
    {
        Quaternion turn = isTilted ? Quaternion.Normalize(new(0.2f, 0.1f, -0.15f, 1)) : Quaternion.Identity;
        Vector3 origin = new(away, away / 3, -away), up = Turned(Vector3.UnitY);
        var scratch = new ConcaveScratch();
        AnyShape floor = Solids.FlatField(53, 8f / 52, isSolid: false);
        AnyShape body = AnyShape.Of(ConvexShape.Capsule(0.4f, 0.6f));
        var at = new RigidPose(turn, origin + Turned(new Vector3(-4, 0, -4)));
        var scene = new CollisionScene();
        scene.Add(floor, at);
        var random = new Rng(11);
        int count = Budget.Whole(1000), tried = 0;
        for (int i = 0; i < count; i++)
        {
            float deep = random.Of(0.0015f, 0.005f, 0.02f, 0.1f);
            float x = random.Float(-1, 1), z = random.Float(-1, 1);
            if (IsAtEdge(x) || IsAtEdge(z) || IsAtEdge(x + z) || IsAtEdge(x - z)) continue;
            Vector3 start = origin + Turned(new Vector3(x, 1 - deep, z));
            Vector3 way = Turned(new Vector3(random.Float(-0.2, 0.2), 0, random.Float(-0.2, 0.2)));
            var from = new RigidPose(turn, start);
            tried++;
            CastHit hit = ConcaveQuery.Cast(body, from, way, floor, at, Vector3.Zero, scratch, options: NoDeeper);
            Assert.True(hit.Status == CastStatus.Miss, $"{i}, {start}, {deep}, by {way}: {hit}");
            bool isHit = scene.TryFindCastHit(body.Convex, from, way, out hit, options: NoDeeper);
            Assert.False(isHit, $"{i}, {start}, {deep}, by {way}: {hit}");
            float slope = random.Of(1e-2f, 1e-3f);
            Vector3 slant = (way - slope * way.Length() * up) * 0.1f, last = start;
            for (int frame = 0; frame < 10; frame++)
            {
                hit = ConcaveQuery.Cast(
                    body, new RigidPose(turn, last), slant, floor, at, Vector3.Zero, scratch, options: NoDeeper);
                last += slant * hit.Fraction;
            }

            float sunk = Vector3.Dot(start - last, up);
            Assert.True(sunk <= 1e-5f + 3e-7f * away, $"{i}, {start}, {deep}, by {slant}: {sunk}");
        }

        Assert.True(tried > count / 2);

        Vector3 Turned(Vector3 v) => Vector3.Transform(v, turn);

        // So near an edge the triangles on both sides are equally deep as float has it.
        static bool IsAtEdge(float along) => MathF.Abs(MathF.IEEERemainder(along, 8f / 52)) < 5e-4f;
    }
}
