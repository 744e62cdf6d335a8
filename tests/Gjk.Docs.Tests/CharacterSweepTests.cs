using System.Globalization;

namespace Gjk.Docs.Tests;

/// <summary>Walks with the character of docs/tasks/character-sweep.md: what the page shows must not freeze, sink in, or
/// go through, wherever the walls stand and whatever floats make of them.</summary>
public class CharacterSweepTests
{
    /// <summary>Behind the page's character: worlds at many places, and what became of the walks.</summary>
    private const string Walks = """
        using System.Globalization;
        using System.Numerics;
        using Gjk.Core;
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        var random = new Random(7);
        for (int i = 0; i < 24; i++)
        {
            Vector3 at = new Vector3(Part(), Part(), Part()) * (i % 3 == 0 ? 0 : i % 3 == 1 ? 7 : 300);
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 2 == 0 ? 0 : Part());
            ConvexShape body = (i % 4) switch
            {
                0 => ConvexShape.Box(new Vector3(0.4f, 1, 0.4f)),
                1 => ConvexShape.Cylinder(0.4f, 1),
                _ => ConvexShape.Capsule(0.4f, 0.6f),
            };
            var world = new World(at, turn, body);
            world.Tiles(12, 20, 0);
            world.Walk("over seams", new(0, 1, -8), new(0.01f * Part(), 0, 0.04f), 400);
            world = new World(at, turn, body);
            world.Tiles(12, 20, 0);
            for (int k = 0; k < 12; k++) world.Add(new(2.1f, 2, k * 2 - 11), new(0.7f, 2, 1));
            world.Walk("at a wall", new(0.3f, 1, -8), new(0.03f, 0, 0.04f), 400);
            world = new World(at, turn, body);
            world.Tiles(6, 12, 0);
            world.Add(new(3.1f, 2, 0), new(0.7f, 2, 8));
            world.Add(new(0, 2, 4.3f), new(8, 2, 0.7f));
            world.Walk("into a corner", new(0, 1, 0), new(0.05f, 0, 0.06f), 200);
            world.Walk("in a corner", null, new(0.05f, 0, 0.06f), 50);
            world.Walk("out of a corner", null, new(-0.03f, 0, -0.04f), 80);
            world = new World(at, turn, body);
            world.Add(new(0, -1, -1), new(4, 1, 1.5f));
            for (int k = 1; k < 10; k++) world.Add(new(0, -1 - 0.2f * k, k), new(4, 1, 0.5f));
            world.Add(new(0, -3, 15), new(4, 1, 5.5f));
            world.Add(new(4.1f, 0, 5), new(0.7f, 6, 20));
            world.Walk("down steps", new(1, 1, -1), new(0.03f, 0, 0.04f), 400);
            world.Walk("up steps", null, new(0.03f, 0, -0.04f), 400);
            world = new World(at, turn, body);
            world.Tiles(6, 12, 0);
            world.Add(new(0, 0.2f, 3), new(8, 0.7f, 1));
            world.Walk("at what is too high", new(0, 1, -1), new(0, 0, 0.05f), 100);
            world = new World(at, turn, body);
            world.Tiles(6, 12, 0);
            world.Add(new(2.1f, 2, 0), new(0.7f, 2, 8));
            world.Walk("in a wall", new(1.3f, 0.9f, -3), new(0.01f, 0, 0.04f), 100);
        }

        float Part() => (float)(2 * random.NextDouble() - 1);

        sealed class World(Vector3 origin, Quaternion turn, ConvexShape body)
        {
            readonly CollisionScene _scene = new();
            readonly List<RigidPose> _poses = [];
            readonly List<ConvexShape> _shapes = [];
            readonly List<float> _reaches = [];
            Vector3 _position;

            public void Add(Vector3 at, Vector3 half)
            {
                _shapes.Add(ConvexShape.Box(half));
                _poses.Add(new RigidPose(turn, origin + Vector3.Transform(at, turn)));
                _reaches.Add(half.Length() + 1.2f);
                _scene.Add(_shapes[^1], _poses[^1]);
            }

            public void Tiles(int across, int along, float y)
            {
                for (int i = 0; i < across; i++)
                    for (int k = 0; k < along; k++)
                        Add(new((i - across / 2) * 1.1f, y - 0.7f, (k - along / 2) * 0.9f), new(0.55f, 0.7f, 0.45f));
            }

            public void Walk(string name, Vector3? from, Vector3 wish, int frames)
            {
                if (from is { } start) _position = origin + Vector3.Transform(start, turn);
                Vector3 first = _position, way = Vector3.Transform(wish, turn);
                float deepest = 0;
                int still = 0;
                for (int i = 0; i < frames; i++)
                {
                    Vector3 before = _position;
                    _position = Character.Move(_scene, body, _position, way);
                    if ((_position - before).Length() < 0.2f * way.Length()) still++;
                    for (int k = 0; k < _poses.Count; k++)
                    {
                        // No body reaches 1.2 from its centre, so that what is farther is not in it.
                        if ((_poses[k].Position - _position).Length() > _reaches[k]) continue;
                        float signed = ConvexQuery.SignedDistance(
                            body, new RigidPose(_position), _shapes[k], _poses[k]).Distance;
                        deepest = MathF.Max(deepest, -signed);
                    }
                }

                Vector3 went = Vector3.Transform(_position - first, Quaternion.Conjugate(turn));
                Console.WriteLine(FormattableString.Invariant(
                    $"{name};{went.X:R};{went.Y:R};{went.Z:R};{deepest:R};{still}"));
            }
        }
        """;

    private static readonly Lazy<List<(string Name, float[] Numbers)>> Results = new(Run);

    /// <summary>It goes all the way along, in no frame stands still, and is on the ground at the end.</summary>
    [Theory]
    [InlineData("over seams", 0, 16)]
    [InlineData("at a wall", 0, 16)]
    [InlineData("down steps", -2, 16)]
    [InlineData("up steps", 2, -16)]
    [InlineData("in a wall", 0.1f, 4)]
    public void AWalkIsNotStopped(string name, float up, float along)
    {
        foreach (float[] walk in Of(name))
        {
            Assert.InRange(walk[2] / along, 0.998f, 1.002f);
            Assert.InRange(walk[1], up - 2e-3f, up + 2e-3f);
            Assert.Equal(0, walk[4]);
        }
    }

    /// <summary>What is higher than a step and a round end stays a wall.</summary>
    [Fact]
    public void ItStepsOntoNothingThatIsTooHigh() => Assert.All(Of("at what is too high"), walk =>
    {
        Assert.InRange(walk[1], -2e-3f, 2e-3f);
        Assert.True(walk[2] < 3, $"it went {walk[2]}");
    });

    /// <summary>It comes to rest in the corner, stays there, and gets out again.</summary>
    [Fact]
    public void ACornerHoldsWhatWalksIntoItAndLetsItGo()
    {
        foreach (float[] walk in Of("into a corner"))
        {
            Assert.InRange(walk[0], 1.5f, 2.1f);
            Assert.InRange(walk[2], 2.7f, 3.3f);
        }

        foreach (float[] walk in Of("in a corner")) Assert.True(Math.Abs(walk[0]) + Math.Abs(walk[2]) < 1e-3f);
        foreach (float[] walk in Of("out of a corner"))
        {
            Assert.InRange(walk[0], -2.41f, -2.39f);
            Assert.InRange(walk[2], -3.21f, -3.19f);
        }
    }

    /// <summary>In no frame does it overlap anything by more than the page allows.</summary>
    [Fact]
    public void NothingIsGoneInto() => Assert.All(Results.Value, r => Assert.InRange(r.Numbers[3], 0, 1.1e-3f));

    private static IEnumerable<float[]> Of(string name)
    {
        float[][] walks = [.. Results.Value.Where(r => r.Name == name).Select(r => r.Numbers)];
        Assert.Equal(24, walks.Length);
        return walks;
    }

    private static List<(string Name, float[] Numbers)> Run()
    {
        CodeBlock character = CodeBlock.Of(Page.Read("docs/tasks/character-sweep.md"))[0];
        Assert.Contains("static class Character", character.Text, StringComparison.Ordinal);
        string output = PageProgram.Run([character, new CodeBlock(["csharp"], Walks, 1)], Path.GetTempPath())[1];
        return
        [
            .. output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split(';')).Select(
                cells => (cells[0], cells[1..].Select(c => float.Parse(c, CultureInfo.InvariantCulture)).ToArray())),
        ];
    }
}
