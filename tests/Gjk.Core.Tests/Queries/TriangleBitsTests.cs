namespace Gjk.Core.Tests.Queries;

/// <summary>Triangles are asked as cores of their own, where the target has them. Scaled by 1 they are no such core and
/// take the general way, which has the same bits.</summary>
public class TriangleBitsTests
{
    private const int Pairs = 3000;

    [Fact]
    public void TrianglesHaveTheBitsOfTheGeneralWay()
    {
        int overlapping = 0;
        for (int seed = 0; seed < Pairs; seed++)
        {
            var rng = new Rng((ulong)seed);
            TriangleShape a = Draw(rng, seed), b = seed % 11 == 0 ? a : Draw(rng, seed / 2);
            RigidPose poseA = Generators.Pose(rng, rng.Vector(-1, 1));
            Vector3 offset = seed % 3 == 0 ? Round(rng.Vector(-0.5, 0.5)) : rng.Vector(-0.5, 0.5);
            var poseB = new RigidPose(seed % 2 == 0 ? poseA.Rotation : rng.Rotation(), poseA.Position + offset);
            Scaled<TriangleShape> generalA = new(a, 1), generalB = new(b, 1);
            var motion = offset * -2;
            string core = Bits(a, poseA, b, poseB, motion);
            Assert.True(core == Bits(generalA, poseA, generalB, poseB, motion), $"seed {seed}");
            Assert.True(
                core == Bits(Convex(a), poseA, Convex(b), poseB, motion), $"seed {seed}, as a {nameof(ConvexShape)}");
            if (ConvexQuery.Overlaps(a, poseA, b, poseB)) overlapping++;
        }

        Assert.InRange(overlapping, Pairs / 10, Pairs * 9 / 10);
    }

    private static ConvexShape Convex(in TriangleShape t) => ConvexShape.Triangle(t.A, t.B, t.C);

    /// <summary>A triangle; some have corners on a grid, on one line or in one point.</summary>
    private static TriangleShape Draw(Rng rng, int seed)
    {
        Vector3 a = rng.Vector(-1, 1), b = rng.Vector(-1, 1), c = rng.Vector(-1, 1);
        if (seed % 3 == 0) (a, b, c) = (Round(a), Round(b), Round(c));
        if (seed % 13 == 0) c = (a + b) / 2;
        if (seed % 17 == 0) c = b;
        return new TriangleShape(a, b, c);
    }

    /// <summary>To quarters.</summary>
    private static Vector3 Round(Vector3 v) =>
        new(float.Round(v.X * 4) / 4, float.Round(v.Y * 4) / 4, float.Round(v.Z * 4) / 4);

    private static string Bits<T>(in T a, in RigidPose poseA, in T b, in RigidPose poseB, Vector3 motion)
        where T : struct, ISupportMap
    {
        var hash = new BitHash();
        hash.Add(ConvexQuery.Distance(a, poseA, b, poseB));
        hash.Add(ConvexQuery.SignedDistance(a, poseA, b, poseB));
        hash.Add(ConvexQuery.Cast(a, poseA, Vector3.Zero, b, poseB, motion));
        ConvexQuery.Overlaps(a, poseA, b, poseB, out GjkStatus status);
        return hash + status.ToString();
    }
}
