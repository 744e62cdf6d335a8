namespace Gjk.Core.Tests.Concave;

/// <summary>Contacts at a great gap, where most pairs of parts are far from each other.</summary>
public class FarContactTests
{
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    /// <summary>A search takes as long as seven questions of two parts.</summary>
    [Theory]
    [InlineData("ball")]
    [InlineData("box")]
    [InlineData("prism")]
    public void PairsThatAreFarAsideAreNotSearched(string name)
    {
        AnyShape grid = AnyShape.Surface(SeamBodies.Plate(40, 2, (_, _) => 0)), body = SeamBodies.Named(name);
        foreach (float height in new[] { -0.01f, 0, 0.3f })
        {
            RigidPose at = SeamBodies.Placed(body, new Vector3(0.3f, 0, 0.2f), Quaternion.Identity, height);
            Assert.True(ConcaveQuery.FindContacts(grid, RigidPose.Identity, body, at, 1e30f, _scratch, _contacts));
            Assert.All(_contacts, c => Assert.Equal(Vector3.UnitY, c.Manifold.Normal));
            Assert.InRange(_scratch.Searched, 0, 64);
            Assert.True(ConcaveQuery.FindContacts(body, at, grid, RigidPose.Identity, 1e30f, _scratch, _contacts));
            Assert.InRange(_scratch.Searched, 0, 64);
        }
    }

    /// <summary>All parts are paired, so each pair that looked at all others would look at thousands.</summary>
    [Theory]
    [InlineData(4, true)]
    [InlineData(8, true)]
    [InlineData(4, false)]
    [InlineData(8, false)]
    public void WorkGrowsWithThePairsAndNotWithTheirSquare(int tiles, bool isScene)
    {
        var parts = new List<CompoundPart>();
        for (int i = 0; i < tiles * tiles; i++)
        {
            var at = new RigidPose(new Vector3(i / tiles, -0.5f, i % tiles));
            parts.Add(new(AnyShape.Solid(Solids.Box(new Vector3(-0.5f), new Vector3(0.5f))), at));
        }

        AnyShape body = AnyShape.Solid(Solids.Box(new Vector3(-0.4f), new Vector3(0.4f)));
        var over = new RigidPose(new Vector3(1.6f, 0.39f, 1.7f));
        if (isScene)
        {
            _scratch.B.TrySet(body, over);
            foreach (CompoundPart part in parts)
            {
                var box = new Aabb(part.Pose.Position - new Vector3(0.5f), part.Pose.Position + new Vector3(0.5f));
                JoinedGrounds.Add(_scratch, part.Shape, part.Pose, box, 0, float.PositiveInfinity);
            }

            JoinedGrounds.FindContacts(_scratch, float.PositiveInfinity, float.PositiveInfinity, _contacts);
        }
        else
        {
            Assert.True(ConcaveQuery.FindContacts(
                AnyShape.Of(new CompoundShape(parts)), RigidPose.Identity, body, over, float.PositiveInfinity,
                _scratch, _contacts));
        }

        Assert.Equal(144 * tiles * tiles, _scratch.Pairs.Count);
        Assert.InRange(_scratch.AtPoint.Looks / _scratch.Pairs.Count, 1, 64);
    }

    /// <summary>The counts are those where no pair is passed over.</summary>
    [Theory]
    [InlineData("box", 576)]
    [InlineData("capsule", 397)]
    [InlineData("prism", 527)]
    public void NoPairThatHasAContactIsPassedOver(string name, int expected)
    {
        AnyShape hills = AnyShape.Surface(
            SeamBodies.Plate(12, 2, (x, z) => 0.9f * MathF.Sin(2.1f * x) * MathF.Cos(1.7f * z)));
        AnyShape body = SeamBodies.Named(name);
        var random = new Rng(4747);
        int count = 0;
        for (int i = 0; i < 200; i++)
        {
            var at = new RigidPose(random.Rotation(), random.Vector(1.5) + new Vector3(0, 0.7f, 0));
            Assert.True(ConcaveQuery.FindContacts(hills, RigidPose.Identity, body, at, 0.4f, _scratch, _contacts));
            count += _contacts.Count;
        }

        Assert.Equal(expected, count);
    }
}
