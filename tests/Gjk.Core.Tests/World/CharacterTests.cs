namespace Gjk.Core.Tests.World;

/// <summary>The loop of docs/tasks/character-sweep.md: from wherever a character begins in a flat floor it is out after
/// a few frames, straight up, and walks on, whatever the floor is made of.</summary>
public class CharacterTests
{
    private const int Half = 10;

    public static TheoryData<string> Floors => ["box", "triangles", "field", "mesh", "tiles", "compound", "solid"];

    [Theory]
    [MemberData(nameof(Floors))]
    public void ACharacterThatBeginsInAFloorIsOutAndWalksOn(string floor)
    {
        var scene = new CollisionScene();
        AddFloor(scene, floor);
        ConvexShape body = ConvexShape.Capsule(radius: 0.4f, halfHeight: 0.6f);
        var random = new Rng(4702);
        foreach (float deep in new[] { 0, 0.0005f, 0.002f, 0.05f, 0.2f, 0.35f })
        {
            for (int round = 0; round < 12; round++)
            {
                // Some begin on a seam, some on a corner of the grid.
                float x = random.Float(-2, 2), z = random.Float(-2, 2);
                if (round % 3 == 0) x = MathF.Round(2 * x) / 2;
                if (round % 4 == 0) z = MathF.Round(2 * z) / 2;
                Vector3 position = new(x, 1 - deep, z), out1 = new(x, 1, z);
                for (int frame = 0; frame < 10; frame++) position = Character.Move(scene, body, position, default);
                Assert.True((position - out1).Length() < 1e-3f, $"{floor}, {deep}, {round}: {position} from {out1}");
                Vector3 wish = new(0.05f, 0, -0.02f), there = position + 40 * wish;
                for (int frame = 0; frame < 40; frame++) position = Character.Move(scene, body, position, wish);
                Assert.True((position - there).Length() < 2e-3f, $"{floor}, {deep}, {round}: {position}, not {there}");
            }
        }
    }

    private static void AddFloor(CollisionScene scene, string floor)
    {
        var slab = ConvexShape.Box(new Vector3(Half, 0.5f, Half));
        var below = new RigidPose(new Vector3(0, -0.5f, 0));
        Vector3[] corners = [new(-Half, 0, -Half), new(Half, 0, -Half), new(Half, 0, Half), new(-Half, 0, Half)];
        CompoundPart[] tiles = [.. Enumerable.Range(0, 4 * Half * Half).Select(i => new CompoundPart(
            ConvexShape.Box(new Vector3(0.5f)),
            new RigidPose(new Vector3(i % (2 * Half) - Half + 0.5f, -0.5f, i / (2 * Half) - Half + 0.5f))))];
        switch (floor)
        {
            case "box":
                scene.Add(slab, below);
                break;
            case "triangles":
                scene.Add(AnyShape.Surface(new TriangleMesh(corners, [0, 2, 1, 0, 3, 2])), RigidPose.Identity);
                break;
            case "field":
                var heights = TriangleMesh.FromHeights(new float[41 * 41], 41, new Vector2(0.5f));
                scene.Add(AnyShape.Surface(heights), new RigidPose(corners[0]));
                break;
            case "mesh":
                TriangleMesh grid = Support.ConcaveShapes.Grid(40).Scaled(new Vector3(Half));
                scene.Add(AnyShape.Surface(grid), RigidPose.Identity);
                break;
            case "tiles":
                foreach (CompoundPart tile in tiles) scene.Add(tile.Shape, tile.Pose);
                break;
            case "compound":
                scene.Add(AnyShape.Of(new CompoundShape(tiles)), RigidPose.Identity);
                break;
            default:
                scene.Add(AnyShape.Solid(Support.ConcaveShapes.Box(new Vector3(Half, 0.5f, Half))), below);
                break;
        }
    }

    private static class Character
    {
        private const float StepDown = 0.3f;                          // world units: how far it follows the ground
        private static readonly CastOptions NoDeeper = CastOptions.OnlyDeeper(allowedDepth: 1e-3f);
        private static readonly List<CastHit> Hits = [];

        public static Vector3 Move(CollisionScene scene, ConvexShape body, Vector3 position, Vector3 wish)
        {
            position = Slide(scene, body, PushOut(scene, body, position), wish);
            Vector3 down = -StepDown * Vector3.UnitY;
            bool isGround = scene.TryFindCastHit(
                body, new RigidPose(position), down, out CastHit ground, options: NoDeeper);
            return isGround ? position + ground.Fraction * down : position;
        }

        private static Vector3 Slide(CollisionScene scene, ConvexShape body, Vector3 position, Vector3 wish)
        {
            Vector3 rest = wish, last = Vector3.Zero;
            for (int bounce = 0; bounce < 4; bounce++)
            {
                bool isHit = scene.TryFindCastHit(
                    body, new RigidPose(position), rest, out CastHit hit, options: NoDeeper);
                position += hit.Fraction * rest;              // all of it where nothing is in the way
                if (!isHit || hit.Status == CastStatus.IterationLimit) break;
                rest *= 1 - hit.Fraction;
                rest -= Vector3.Dot(rest, hit.Result.Normal) * hit.Result.Normal;
                if (Vector3.Dot(rest, last) > 0)              // back into the wall before: only the crease is left
                {
                    Vector3 crease = Vector3.Cross(last, hit.Result.Normal);
                    rest = Vector3.Dot(rest, crease) / MathF.Max(crease.LengthSquared(), 1e-6f) * crease;
                }

                if (Vector3.Dot(rest, wish) <= 1e-6f * wish.LengthSquared()) break;
                last = hit.Result.Normal;
            }

            return position;
        }

        private static Vector3 PushOut(CollisionScene scene, ConvexShape body, Vector3 position)
        {
            for (int push = 0; push < 8; push++)
            {
                scene.FindCastHits(body, new RigidPose(position), Vector3.Zero, Hits);
                if (Hits.Count == 0) break;
                CastResult deepest = Hits[0].Result;
                foreach (CastHit hit in Hits) if (hit.Result.Depth > deepest.Depth) deepest = hit.Result;
                position -= deepest.Depth * deepest.Normal;
            }

            return position;
        }
    }
}
