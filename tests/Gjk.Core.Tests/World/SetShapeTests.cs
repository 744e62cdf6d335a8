namespace Gjk.Core.Tests.World;

/// <summary>A scene in which objects got other shapes answers as one that was built with these shapes.</summary>
public class SetShapeTests
{
    private static readonly RigidPose Above = new(new Vector3(0, 1.5f, 0));

    /// <summary>Objects move, go, come and get other shapes of any kind, half-spaces among them; in some frames only
    /// shapes change.</summary>
    [Theory]
    [InlineData(BroadPhaseKind.DynamicTree)]
    [InlineData(BroadPhaseKind.SortAndSweep)]
    public void AllAnswersAreThoseOfAFreshScene(BroadPhaseKind kind)
    {
        using var workers = new Workers(2);
        int met = 0, exchanged = 0;
        for (int seed = 0; seed < Budget.Count(3); seed++)
        {
            var crowd = new ChangingCrowd(kind, (ulong)seed, 18);
            for (int frame = 0; frame < 16; frame++)
            {
                crowd.Change();
                exchanged += crowd.Exchanged.Count;
                met += crowd.Check($"seed {seed}, frame {frame}", frame % 3 == 0 ? workers : null);
            }
        }

        Assert.InRange(met, 500, 1_000_000);
        Assert.InRange(exchanged, 50, 1_000_000);
    }

    /// <summary>A warm start of the old shape would cost nothing but the last bits.</summary>
    [Fact]
    public void APairBeginsColdWithTheNewShape()
    {
        var rng = new Rng(4);
        List<PairDistance> found = [];
        int differ = 0;
        for (int i = 0; i < 200; i++)
        {
            ConvexShape old = Generators.Shape(rng, "hull").Shape, next = Generators.Shape(rng, "cylinder").Shape;
            ConvexShape other = Generators.Shape(rng, "ellipsoid").Shape;
            RigidPose a = Generators.Pose(rng, Vector3.Zero), b = Generators.Pose(rng, new Vector3(3, 0, 0));
            var scene = new CollisionScene();
            scene.Add(old, a);
            scene.Add(other, b);
            scene.FindPairsWithin(9, found);
            scene.SetShape(0, next);
            scene.FindPairsWithin(9, found);
            DistanceResult cold = ConvexQuery.Distance(next, a, other, b, 9);
            Assert.Equal(ResultBits.Of(cold), ResultBits.Of(found[0].Result));
            WarmStart warm = default;
            ConvexQuery.Distance(old, a, other, b, ref warm, 9);
            if (!ResultBits.AreSame(cold, ConvexQuery.Distance(next, a, other, b, ref warm, 9))) differ++;
        }

        Assert.InRange(differ, 5, 200);
    }

    [Fact]
    public void IdPoseAndSettingsStay()
    {
        var settings = new ObjectSettings(isStatic: true, groups: 2, mask: 5, tag: 9);
        var scene = new CollisionScene();
        int id = scene.Add(ConvexShape.Sphere(1), Above, settings);
        AnyShape torus = AnyShape.Solid(ConcaveShapes.Torus(8, 6));
        scene.SetShape(id, torus);
        Assert.Equal((AnyShapeKind.Solid, ShapeKind.None), (scene.GetAnyShape(id).Kind, scene.GetShape(id).Kind));
        Assert.Same(torus.Mesh, scene.GetAnyShape(id).Mesh);
        scene.SetShape(id, ConvexShape.Capsule(0.3f, 0.5f));
        Assert.Equal((AnyShapeKind.Convex, ShapeKind.Capsule), (scene.GetAnyShape(id).Kind, scene.GetShape(id).Kind));
        Assert.Equal((1, Above, settings), (scene.Count, scene.GetPose(id), scene.GetSettings(id)));
        Assert.Equal(1, scene.Add(ConvexShape.Sphere(1), Above));
    }

    [Fact]
    public void BadCallsAreRefusedAndTheSceneIsUnchanged()
    {
        var scene = new CollisionScene();
        int gone = scene.Add(ConvexShape.Sphere(1), Above), id = scene.Add(ConvexShape.Sphere(1), Above);
        scene.Remove(gone);
        foreach (int none in new[] { gone, -1, 2, int.MaxValue })
        {
            Assert.Equal(
                "id", Assert.Throws<ArgumentOutOfRangeException>(
                    () => scene.SetShape(none, ConvexShape.Sphere(2))).ParamName);
        }

        Assert.Equal(
            "shape", Assert.Throws<ArgumentException>(() => scene.SetShape(id, default(ConvexShape))).ParamName);
        Assert.Equal("shape", Assert.Throws<ArgumentException>(() => scene.SetShape(id, default(AnyShape))).ParamName);
        Assert.Equal(1, scene.GetShape(id).BoundingRadius);
    }

    [Theory]
    [InlineData(BroadPhaseKind.DynamicTree)]
    [InlineData(BroadPhaseKind.SortAndSweep)]
    public void ShapesThatTakeTurnsAllocateNothing(BroadPhaseKind kind)
    {
        ConvexShape up = ConvexShape.Capsule(0.4f, 0.6f), down = ConvexShape.Capsule(0.4f, 0.1f);
        ConvexShape floor = ConvexShape.HalfSpace(Vector3.UnitY, 0), slab = ConvexShape.Box(new Vector3(5, 0.1f, 5));
        AnyShape whole = AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.5f)));
        AnyShape broken = AnyShape.Surface(ConcaveShapes.Torus(8, 6));
        var scene = new CollisionScene(kind);
        int body = scene.Add(up, Above), wall = scene.Add(whole, RigidPose.Identity);
        int ground = scene.Add(floor, RigidPose.Identity);
        List<PairDistance> near = [];
        List<PairContacts> contacts = [];
        bool turn = false;
        long least = Allocation.Least(() =>
        {
            for (int i = 0; i < 8; i++)
            {
                turn = !turn;
                scene.SetShape(body, turn ? down : up);
                scene.SetShape(wall, turn ? broken : whole);
                scene.SetShape(ground, turn ? slab : floor);
                scene.FindPairsWithin(2, near);
                scene.FindContacts(0.1f, contacts);
                scene.FindDepths(near);
            }
        });
        Assert.Equal(0, least);
        Assert.NotEmpty(contacts);
    }
}
