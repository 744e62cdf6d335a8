namespace Gjk.Core.Tests.Concave;

/// <summary>Distances, bounds, points and the names of the parts are the same on every target, so lanes and scalars
/// prune alike.</summary>
public class ConcaveBitsTests
{
    private const ulong Golden = 8551457801852481714;

    [Fact]
    public void AnswersAndPartsAreThoseOfEveryTarget()
    {
        var scratch = new ConcaveScratch();
        ulong hash = 14695981039346656037;
        for (int seed = 0; seed < 80; seed++)
        {
            var random = new Rng((ulong)seed);
            AnyShape a = ConcaveShapes.Any(random), b = ConcaveShapes.Any(random);
            RigidPose poseA = ConcaveShapes.Pose(random, 1.5), poseB = ConcaveShapes.Pose(random, 1.5);
            PairDistance found = ConcaveQuery.Distance(a, poseA, b, poseB, scratch);
            Add(found.PartA);
            Add(found.PartB);
            Add(BitConverter.SingleToInt32Bits(found.Distance + 0f));
            Add(BitConverter.SingleToInt32Bits(found.Result.LowerBound + 0f));
            Add(BitConverter.SingleToInt32Bits(found.Result.PointA.X + 0f));
            CastHit cast = ConcaveQuery.Cast(
                a, poseA, default, b, poseB, poseA.Position - poseB.Position, scratch);
            Add(cast.PartA);
            Add(BitConverter.SingleToInt32Bits(cast.Fraction + 0f));
        }

        Assert.Equal(Golden, hash);

        void Add(int value) => hash = (hash ^ (uint)value) * 1099511628211;
    }
}
