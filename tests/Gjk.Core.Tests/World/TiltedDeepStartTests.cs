namespace Gjk.Core.Tests.World;

/// <summary>Tilted bodies that begin deep in a flat floor of many parts sink no further.</summary>
public class TiltedDeepStartTests
{
    private static readonly CastOptions NoDeeper = CastOptions.OnlyDeeper(1e-3f);

    /// <summary>The way out of the part that a tilted body's tip is in leads aside, into the next part: it gets no
    /// deeper there, either.</summary>
    [Theory]
    [InlineData("field", "cylinder")]
    [InlineData("field", "box")]
    [InlineData("field", "cone")]
    [InlineData("tiles", "cylinder")]
    [InlineData("tiles", "box")]
    [InlineData("tiles", "cone")]
    [InlineData("compound", "box")]
    [InlineData("compound", "cone")]
    public void ATiltedBodyThatIsDeepDoesNotSinkOn(string floor, string name)
    {
        ConvexShape body = name switch
        {
            "cylinder" => ConvexShape.Cylinder(0.3f, 0.4f),
            "cone" => ConvexShape.Cone(0.3f, 0.4f),
            _ => ConvexShape.Box(new Vector3(0.3f, 0.4f, 0.2f)),
        };
        var scene = new CollisionScene();
        AddTiles(scene, floor);
        int count = Budget.Whole(90), slid = 0;
        for (int i = 0; i < count; i++)
        {
            var random = new Rng((ulong)(700 + i));
            Quaternion turn = random.Rotation();
            body.Support((Double3)Vector3.Transform(-Vector3.UnitY, Quaternion.Conjugate(turn)), out Double3 tip);
            float low = Vector3.Transform((Vector3)(body.Center + tip), turn).Y, deep = random.Float(0.05, 0.15);
            Vector3 start = new(random.Float(-1, 1), -low - deep, random.Float(-1, 1));
            Vector3 at = start, way = new(random.Float(-0.05, 0.05), -0.002f, random.Float(-0.05, 0.05));
            for (int frame = 0; frame < 30; frame++)
            {
                Vector3 rest = way;
                for (int k = 0; k < 4; k++)
                {
                    bool isHit = scene.TryFindCastHit(
                        body, new RigidPose(turn, at), rest, out CastHit hit, options: NoDeeper);
                    at += hit.Fraction * rest;
                    if (!isHit) break;
                    rest *= 1 - hit.Fraction;
                    rest -= Vector3.Dot(rest, hit.Result.Normal) * hit.Result.Normal;
                }

                if (Math.Abs(at.X) > 3 || Math.Abs(at.Z) > 3) break;
            }

            if (Math.Abs(at.X - start.X) + Math.Abs(at.Z - start.Z) > 0.1f) slid++;
            Assert.True(at.Y >= start.Y - 1e-5f, $"{700 + i}, {deep} deep, by {way}: from {start} to {at}");
        }

        Assert.InRange((double)slid / count, 0.5, 1);
    }

    /// <summary>However short the steps are: what the way out of the floor leads against is no rounding.</summary>
    [Theory]
    [InlineData("field")]
    [InlineData("tiles")]
    [InlineData("compound")]
    public void ShortStepsDownDoNotAddUp(string floor)
    {
        var scene = new CollisionScene();
        AddTiles(scene, floor);
        foreach (ConvexShape body in new[] { ConvexShape.Sphere(0.5f), ConvexShape.Capsule(0.4f, 0.1f) })
        {
            foreach (float aside in new[] { 0, 0.01f })
            {
                Vector3 at = new(0.1f, 0.4f, 0.27f), way = new(aside, -5e-6f, aside);
                for (int frame = 0; frame < 300; frame++)
                {
                    bool isHit = scene.TryFindCastHit(
                        body, new RigidPose(at), way, out CastHit hit, options: CastOptions.OnlyDeeper());
                    Assert.True(isHit || aside > 0, $"{frame}");
                    Vector3 rest = (1 - hit.Fraction) * way;
                    at += hit.Fraction * way;
                    if (isHit) at += rest - Vector3.Dot(rest, hit.Result.Normal) * hit.Result.Normal;
                }

                Assert.InRange(at.Y, 0.4f - 1e-5f, 0.41f);
            }
        }
    }

    /// <summary>A scene of one convex object has the answer of the pair, to the last bit.</summary>
    [Fact]
    public void OneObjectAnswersAsThePair()
    {
        var random = new Rng(5);
        int within = 0;
        for (int i = 0; i < 4000; i++)
        {
            var box = ConvexShape.Box(new Vector3(random.Float(0.1, 1), random.Float(0.1, 1), random.Float(0.1, 1)));
            var pose = new RigidPose(random.Rotation(), random.Vector(2));
            var scene = new CollisionScene();
            scene.Add(box, pose);
            ConvexShape body = ConvexShape.Sphere(random.Float(0.05, 0.5));
            RigidPose at = new(pose.Position + random.Vector(1));
            Vector3 way = random.Vector(1) * MathF.Pow(10, random.Float(-5, 0));
            CastOptions options = CastOptions.OnlyDeeper(random.OneIn(2) ? 0 : 1e-3f);
            CastResult pair = ConvexQuery.Cast(body, at, way, box, pose, Vector3.Zero, 1, options);
            scene.TryFindCastHit(body, at, way, out CastHit hit, options: options);
            if (pair.Status == CastStatus.OverlappingAtStart) within++;
            Assert.True(
                hit.Status == pair.Status && hit.Result.Normal.Equals(pair.Normal) && hit.Result.Depth == pair.Depth,
                $"{i}: {hit} for {pair}");
        }

        Assert.InRange(within, 100, 4000);
    }

    /// <summary>Less deep than its position can say, it slides over the seams of flush tiles all the same.</summary>
    [Fact]
    public void ARoundingDeepIsNoWall()
    {
        var scene = new CollisionScene();
        AddTiles(scene, "tiles");
        ConvexShape capsule = ConvexShape.Capsule(0.4f, 0.6f);
        for (int i = 0; i < 100; i++)
        {
            var random = new Rng((ulong)i);
            Vector3 at = new(random.Float(-2, 2), 1, random.Float(-2, 2));
            Vector3 way = new(random.Float(-3, 3), 0, random.Float(-3, 3));
            bool isHit = scene.TryFindCastHit(
                capsule, new RigidPose(at), way, out CastHit hit, options: CastOptions.OnlyDeeper());
            Assert.False(isHit, $"{i}: {at} by {way}: {hit}");
        }
    }

    /// <summary>A flat floor at height 0 of squares of .5 or 1.</summary>
    private static void AddTiles(CollisionScene scene, string floor)
    {
        if (floor == "field")
        {
            scene.Add(
                AnyShape.Surface(TriangleMesh.FromHeights(new float[33 * 33], 33, new Vector2(0.5f))),
                new RigidPose(new Vector3(-8, 0, -8)));
            return;
        }

        CompoundPart[] parts = [.. Enumerable.Range(0, 64).Select(i => new CompoundPart(
            ConvexShape.Box(new Vector3(0.5f, 1, 0.5f)), new RigidPose(new Vector3(i % 8 - 3.5f, -1, i / 8 - 3.5f))))];
        if (floor == "compound") scene.Add(AnyShape.Of(new CompoundShape(parts)), RigidPose.Identity);
        else foreach (CompoundPart part in parts) scene.Add(part.Shape, part.Pose);
    }
}
