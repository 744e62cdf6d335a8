namespace Gjk.Core.Tests.Concave;

/// <summary>Solids whose faces lie in each other, edge on edge, as crates that are stacked: no triangle of one crosses
/// one of the other, whichever way they move.</summary>
public class FlushSolidTests
{
    private static readonly Vector3[] Ways =
        [Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitZ];

    private static readonly ConvexShape Box = ConvexShape.Box(Vector3.One);

    public static TheoryData<string> Kinds => ["crate", "compound"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void WhatStandsFaceToFaceIsHitByAMotionIntoItAlone(string kind)
    {
        AnyShape crate = Crate(kind);
        var scratch = new ConcaveScratch();
        foreach (Vector3 side in Ways)
        {
            var pose = new RigidPose(2 * side);
            foreach (Vector3 way in Ways)
            {
                foreach (float length in new[] { 0.01f, 1, 1.75f })
                {
                    CastHit hit = ConcaveQuery.Cast(
                        crate, RigidPose.Identity, default, crate, pose, way * length, scratch);
                    CastStatus right = way == -side ? CastStatus.Hit : CastStatus.Miss;
                    Assert.Equal((right, right == CastStatus.Hit ? 0 : 1f), (hit.Status, hit.Result.Fraction));
                    if (right == CastStatus.Hit) Assert.InRange(Vector3.Distance(side, hit.Result.Normal), 0, 1e-6f);
                }
            }
        }
    }

    /// <summary>What passes shallow contacts meets a face that is flush with its own, too: no triangle gets deeper in
    /// another, but the solids do.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void WhatComesFromAfarDoesNotPass(string kind)
    {
        AnyShape crate = Crate(kind);
        var scratch = new ConcaveScratch();
        foreach (Vector3 side in Ways)
        {
            foreach ((float from, float length, float allowed, float met) in new[]
                {
                    (2.5f, 1f, 0f, 0.5f), (3, 2, 0, 0.5f), (2.5f, 8, 0.25f, 0.0625f), (2, 1, 0, 0),
                    (2.5f, 0.25f, 0, -1), (2.5f, 1, 0.75f, -1), (2, -1, 0, -1),
                })
            {
                CastHit hit = ConcaveQuery.Cast(
                    crate, RigidPose.Identity, default, crate, new RigidPose(from * side), -length * side, scratch, 1,
                    CastOptions.OnlyDeeper(allowed));
                Assert.Equal(met < 0 ? (CastStatus.Miss, 1) : (CastStatus.Hit, met), (hit.Status, hit.Result.Fraction));
                if (met >= 0) Assert.InRange(Vector3.Distance(side, hit.Result.Normal), 0, 1e-6f);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void WhatLiesInItselfOverlaps(string kind)
    {
        AnyShape crate = Crate(kind);
        var scratch = new ConcaveScratch();
        foreach (Vector3 way in Ways)
        {
            CastHit hit = ConcaveQuery.Cast(
                crate, RigidPose.Identity, default, crate, RigidPose.Identity, way * 5, scratch);
            Assert.Equal(CastStatus.OverlappingAtStart, hit.Status);
            CastResult convex = ConvexQuery.Cast(Box, RigidPose.Identity, default, Box, RigidPose.Identity, way * 5);
            Assert.Equal(convex.Depth, hit.Result.Depth, 1e-5f);
        }
    }

    private static AnyShape Crate(string kind)
    {
        var hull = new ConvexHull(Clouds.Box(Vector3.One));
        var triangles = new int[3 * hull.TriangleCount];
        for (int i = 0; i < hull.TriangleCount; i++)
            hull.GetTriangle(i, out triangles[3 * i], out triangles[3 * i + 1], out triangles[3 * i + 2]);
        Vector3[] corners = [.. Enumerable.Range(0, hull.VertexCount).Select(i => hull.GetVertex(i))];
        AnyShape solid = AnyShape.Solid(new TriangleMesh(corners, triangles));
        return kind == "crate" ? solid : AnyShape.Of(new CompoundShape([new CompoundPart(solid, RigidPose.Identity)]));
    }
}
