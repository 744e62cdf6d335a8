using Gjk.Core.Tests.Support;

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
            var random = new FuzzRandom((ulong)(700 + i));
            Quaternion turn = Rotations.Even(random);
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
