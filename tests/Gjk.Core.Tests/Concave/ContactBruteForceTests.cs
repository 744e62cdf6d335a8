namespace Gjk.Core.Tests.Concave;

/// <summary>Contacts are what single queries say of the parts, less what a surface does not show. A pair that
/// overlaps, that nothing else takes apart and whose face is far away keeps its own way out, shown or not: a body that
/// a thin wall runs through has to be held by something, and not to be pushed through by the face.</summary>
public class ContactBruteForceTests
{
    private const float Reach = 0.02f;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    [Fact]
    public void TheContactsAreThoseOfAllTrianglesThatTheSurfaceShows()
    {
        int kept = 0, dropped = 0, held = 0;
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Rng((ulong)seed);
            TriangleMesh mesh = seed % 3 == 0
                ? ConcaveShapes.Torus(11, 7)
                : SeamBodies.Plate(6, seed % 4, (_, _) => random.Float(-0.4f, 0.4f));
            if (seed % 5 == 0) mesh = mesh.Scaled(random.Factors(0.5, 2));
            AnyShape ground = AnyShape.Surface(mesh);
            AnyShape body = SeamBodies.Named(random.Of("ball", "box", "capsule", "hull"));
            var at = new RigidPose(random.Rotation(), random.Vector(1.2));
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, body, at, 0.1f, _scratch, _contacts);
            List<ConvexShape> parts = ConcaveShapes.Parts(ground);
            for (int i = 0; i < parts.Count; i++)
            {
                DistanceResult own = ConvexQuery.Contacts(
                    parts[i], RigidPose.Identity, body.Convex, at, 0.1f, out ContactManifold manifold);
                int index = _contacts.FindIndex(one => one.PartA == i);
                if (manifold.Count == 0)
                {
                    Assert.Equal(-1, index);
                    continue;
                }

                ConeReference truth = new(mesh, i, manifold.Normal);
                if (truth.IsUnclear) continue;
                if (truth.Stays)
                {
                    kept++;
                    Assert.True(index >= 0, $"seed {seed}: {i} is lost");
                    Assert.Equal(manifold.Normal, _contacts[index].Manifold.Normal);
                }
                else if (index >= 0)
                {
                    if (Math.Abs(Vector3.Dot(_contacts[index].Manifold.Normal, truth.Face)) > 1 - 1e-6f) continue;
                    held++;
                    Assert.Equal(own.Normal, _contacts[index].Manifold.Normal);
                    Assert.True(IsFarThrough(parts[i], truth.Face, body, at, own), $"seed {seed}: {i} is a ghost");
                    Assert.False(IsHeldByAnother(index, parts[i], body, at, own), $"seed {seed}: {i} is held");
                }
                else
                {
                    dropped++;
                }
            }
        }

        Assert.InRange(kept, 100, 10000);
        Assert.InRange(dropped, 100, 10000);
        Assert.InRange(held, 1, 3);
    }

    /// <summary>Whether a body overlaps a triangle and is four times as deep behind its face, to either side: pushed
    /// that far it would go through what is there.</summary>
    private static bool IsFarThrough(
        in ConvexShape triangle, Vector3 face, in AnyShape body, in RigidPose at, in DistanceResult own)
    {
        triangle.Support(face, out Double3 corner);
        double height = Double3.Dot(face, triangle.Center + corner);
        return Depth(face, body, at, height) < 4 * own.Distance && Depth(-face, body, at, -height) < 4 * own.Distance;
    }

    private static double Depth(Vector3 face, in AnyShape body, in RigidPose at, double height)
    {
        Vector3 local = Vector3.Transform(-face, Quaternion.Conjugate(at.Rotation));
        body.Convex.Support(local, out Double3 tip);
        tip += body.Convex.Center + (Double3)local * body.Convex.Margin;
        return Double3.Dot(face, at.TransformPoint((Vector3)tip)) - height;
    }

    /// <summary>Whether the push of another contact takes a pair apart, or half the way.</summary>
    private bool IsHeldByAnother(
        int index, in ConvexShape triangle, in AnyShape body, in RigidPose at, in DistanceResult own)
    {
        for (int i = 0; i < _contacts.Count; i++)
        {
            if (i == index) continue;
            Vector3 push = _contacts[i].Manifold.Normal * Math.Max(0, -_contacts[i].Result.Distance);
            var moved = new RigidPose(at.Rotation, at.Position + push);
            float left = ConvexQuery.SignedDistance(triangle, RigidPose.Identity, body.Convex, moved).Distance;
            if (left > own.Distance / 2) return true;
        }

        return false;
    }

    [Fact]
    public void PartsOfACompoundAllCount()
    {
        var random = new Rng(3);
        CompoundShape compound = ConcaveShapes.Compound(random, 30);
        AnyShape shape = AnyShape.Of(compound), body = SeamBodies.Named("box");
        ConcaveQuery.FindContacts(
            shape, RigidPose.Identity, body, RigidPose.Identity, Reach, _scratch, _contacts);
        int next = 0;
        for (int i = 0; i < compound.PartCount; i++)
        {
            DistanceResult result = ConvexQuery.Contacts(
                compound.GetPart(i), RigidPose.Identity, body.Convex, RigidPose.Identity, Reach,
                out ContactManifold manifold);
            if (manifold.Count == 0) continue;
            Assert.Equal(i, _contacts[next].PartA);
            Assert.Equal(-1, _contacts[next].PartB);
            Assert.Equal(result.Distance, _contacts[next].Result.Distance);
            Assert.Equal(manifold.Count, _contacts[next++].Manifold.Count);
        }

        Assert.Equal(next, _contacts.Count);
        Assert.InRange(next, 3, 30);
    }

    /// <summary>What a body's box reaches and the body does not costs no query.</summary>
    [Fact]
    public void FewTrianglesAreAskedBesideThoseInReach()
    {
        var random = new Rng(6);
        AnyShape ground = AnyShape.Surface(ConcaveShapes.Grid(40, (_, _) => random.Float(-0.002, 0.002)));
        AnyShape ball = AnyShape.Of(ConvexShape.Mesh(Clouds.OnSphere(random, 60)).Scaled(new Vector3(0.1f)));
        int asked = 0, found = 0;
        for (int i = 0; i < 40; i++)
        {
            var at = new RigidPose(
                random.Rotation(), new Vector3(random.Float(-0.3, 0.3), 0.095f, random.Float(-0.3, 0.3)));
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, ball, at, 0.005f, _scratch, _contacts);
            asked += _scratch.Search.QueryCount;
            found += _scratch.Pairs.Count;
        }

        Assert.InRange(found, 100, 4000);
        Assert.InRange(asked, found, 2 * found);
    }

    [Fact]
    public void WarmListsAllocateNothing()
    {
        AnyShape ground = AnyShape.Surface(SeamBodies.Plate(8, 1, (_, _) => 0)), body = SeamBodies.Named("box");
        RigidPose at = SeamBodies.Placed(body, new Vector3(0.1f, 0, 0.2f), Quaternion.Identity, -0.001f);
        Assert.Equal(
            0,
            Allocation.Least(() => ConcaveQuery.FindContacts(
                ground, RigidPose.Identity, body, at, Reach, _scratch, _contacts)));
        Assert.NotEmpty(_contacts);
    }
}
