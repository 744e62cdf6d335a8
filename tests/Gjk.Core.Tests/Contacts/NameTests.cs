using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>Names of contact points, and their order, stay while bodies at rest shiver.</summary>
public class NameTests
{
    private static readonly ConvexShape Unit = ConvexShape.Box(new Vector3(0.5f));

    /// <summary>Pairs of the same or of other faces, and how far the upper body is turned and moved.</summary>
    public static TheoryData<string, string, float, float, float> Standing => new()
    {
        { "box", "box", 0, 0, 1e-3f },
        { "box", "box", MathF.PI / 2, 0, 1e-3f },
        { "box", "box", 0, 0.5f, 1e-3f },
        { "floor", "box", 0.3f, 0.1f, 1e-3f },
        { "rounded", "rounded", 0, 0, 1e-3f },
        { "floor", "cylinder", 0.3f, 0, 1e-3f },
        { "box", "cylinder", 0, 0, 1e-4f },
        { "cylinder", "cylinder", 0, 0, 1e-3f },
        { "cylinder", "cylinder", 0.2f, 0.1f, 1e-4f },
        { "floor", "cone", 0.1f, 0, 1e-4f },
        { "prism16", "prism16", 0.07f, 0, 1e-4f },
        { "floor", "prism64", 0.2f, 0, 1e-4f },
        { "prism64", "prism64", 0, 0, 1e-4f },
        { "prism64", "prism64", 0.07f, 0, 1e-4f },
        { "prism100", "cylinder", 0.07f, 0, 1e-4f },
    };

    [Theory]
    [MemberData(nameof(Standing))]
    public void NamesAndTheirOrderStayUnderNoise(string below, string above, float yaw, float shift, float noise)
    {
        ConvexShape a = Shape(below), b = Shape(above);
        var rng = new Rng(5);
        long[] last = [];
        int kept = 0, frames = 600;
        for (int i = 0; i <= frames; i++)
        {
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, yaw + rng.Float(-noise, noise))
                * Quaternion.CreateFromYawPitchRoll(0, rng.Float(-noise, noise), rng.Float(-noise, noise));
            var at = new Vector3(shift, 0.995f, shift / 2) + rng.Vector(-noise, noise);
            long[] names = Names(Ask(a, RigidPose.Identity, b, new RigidPose(turn, at), 0.02f));
            Assert.Equal(names.Length, names.Distinct().Count());
            if (names.SequenceEqual(last)) kept++;
            last = names;
        }

        Assert.InRange(kept, frames * 99 / 100, frames);
    }

    /// <summary>Of more than four corners, each with a name of its own, the deepest takes the place of one; the other
    /// three stay, and half of the time all four do.</summary>
    [Theory]
    [InlineData("box", "box", 0.3f, 1e-3f)]
    [InlineData("box", "box", MathF.PI / 4, 1e-3f)]
    [InlineData("floor", "prism8", 0.2f, 1e-4f)]
    [InlineData("prism8", "prism8", 0.07f, 1e-4f)]
    [InlineData("floor", "prism12", 0.2f, 1e-4f)]
    [InlineData("prism12", "prism12", 0f, 1e-4f)]
    public void ThreeNamesStayWhereTheDeepestCornerChanges(string below, string above, float yaw, float noise)
    {
        ConvexShape a = Shape(below), b = Shape(above);
        var rng = new Rng(5);
        const int Frames = 600;
        List<long[]> frames = [];
        for (int i = 0; i < Frames; i++)
        {
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, yaw + rng.Float(-noise, noise))
                * Quaternion.CreateFromYawPitchRoll(0, rng.Float(-noise, noise), rng.Float(-noise, noise));
            Vector3 at = new Vector3(0, 0.995f, 0) + rng.Vector(-noise, noise);
            frames.Add(Names(Ask(a, RigidPose.Identity, b, new RigidPose(turn, at), 0.02f)));
        }

        long[] usual = [.. frames.SelectMany(f => f).GroupBy(id => id).OrderByDescending(g => g.Count()).Take(4)
            .Select(g => g.Key)];
        Assert.InRange(frames.Count(f => f.Intersect(usual).Count() >= 3), Frames * 99 / 100, Frames);
    }

    /// <summary>The largest area may exchange points, not names.</summary>
    [Fact]
    public void ANameIsThatOfThePointsOwnCorner()
    {
        var rng = new Rng(3);
        ConvexShape box = ConvexShape.Box(Vector3.One);
        int count = 0;
        for (int i = 0; i < 1200; i++)
        {
            var hull = new ConvexHull(Clouds.Prism(5 + rng.Below(6), 0.5f, 0.5f));
            float tilt = MathF.Pow(10, rng.Float(-6, -2)), angle = rng.Float(0, 6.3);
            var axis = new Vector3(MathF.Cos(angle), 0, MathF.Sin(angle));
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6.3));
            Quaternion turn = Quaternion.CreateFromAxisAngle(axis, tilt) * yaw;
            var pose = new RigidPose(turn, new Vector3(0.1f, 1.499f, 0.05f));
            foreach (ManifoldPoint p in Points(Ask(box, RigidPose.Identity, ConvexShape.Mesh(hull), pose, 0.02f)))
            {
                if ((p.FeatureId & 3) != 1) continue;
                count++;
                Vector3 corner = hull.GetVertex((int)(p.FeatureId & uint.MaxValue) >> 2);
                Assert.True((corner - p.LocalPointB).Length() < 0.01f, $"{i}: {p} is not at {corner}");
            }
        }

        Assert.InRange(count, 3600, int.MaxValue);
    }

    /// <summary>The sign of a last bit names no point.</summary>
    [Fact]
    public void EqualCubesHaveTheSameNamesAtAnyTinyTurn()
    {
        long[] Names(float yaw) => NameTests.Names(
            Ask(
                Unit, RigidPose.Identity, Unit,
                new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitY, yaw), new Vector3(0, 0.999f, 0))));
        long[] straight = Names(0);
        Assert.Equal(4, straight.Length);
        foreach (float yaw in new[] { 2e-6f, -3e-6f, 1e-4f, -1e-4f }) Assert.Equal(straight, Names(yaw));
    }

    /// <summary>A name is made of a corner of each body where two coincide, of one body's where it lies on the other's
    /// face, and of the two edges where they cross.</summary>
    [Fact]
    public void ANameSaysWhatItIsMadeOf()
    {
        const uint Corner = 1, Edge = 2;
        static uint Kind(long half) => (uint)half & 3;
        (uint, uint)[] Kinds(float yaw, float half) =>
        [
            .. Names(
                Ask(
                    Unit, RigidPose.Identity, ConvexShape.Box(new Vector3(half, 0.5f, half)),
                    new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitY, yaw), new Vector3(0, 0.999f, 0))))
                .Select(id => (Kind(id >> 32), Kind(id))),
        ];
        Assert.All(Kinds(0, 0.5f), k => Assert.Equal((Corner, Corner), k));
        Assert.All(Kinds(0, 0.25f), k => Assert.Equal((0u, Corner), k));
        Assert.All(Kinds(0, 1), k => Assert.Equal((Corner, 0u), k));
        Assert.All(Kinds(MathF.PI / 4, 0.5f), k => Assert.Equal((Edge, Edge), k));
    }

    [Fact]
    public void NamesAreThoseOfTheExchangedPair()
    {
        var rng = new Rng(8);
        for (int i = 0; i < 200; i++)
        {
            string[] names = ["box", "rounded", "cylinder", "prism8"];
            ConvexShape a = Shape(names[i % 4]), b = Shape(names[i / 4 % 4]);
            var pose = new RigidPose(
                Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6)),
                new Vector3(rng.Float(-0.3, 0.3), 0.99f, rng.Float(-0.3, 0.3)));
            ContactManifold m = Ask(a, RigidPose.Identity, b, pose), swapped = Ask(b, pose, a, RigidPose.Identity);
            Assert.Equal(Names(m).Order(), Names(swapped.Swapped).Order());
        }
    }

    /// <summary>A can on a plank touches it half way between the beginnings of its quarters: which of two quarters a
    /// point belongs to was a last bit, and the names turned with the exchange.</summary>
    [Fact]
    public void QuartersAreThoseOfTheExchangedPair()
    {
        var rng = new Rng(9);
        for (int i = 0; i < 200; i++)
        {
            ConvexShape plank = ConvexShape.Box(new Vector3(rng.Float(0.3, 0.9), 1, rng.Float(2, 4)));
            ConvexShape can = ConvexShape.Cylinder(1, rng.Float(0.3, 1)).Rounded(i % 2 * 0.002f);
            var standing = new RigidPose(
                Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 4 * (MathF.PI / 2)),
                new Vector3(0, 1 + (float)Height(can, Quaternion.Identity) + 1e-3f, 0));
            Quaternion turn = Quaternion.Normalize(rng.Rotation());
            Vector3 offset = rng.Vector(-9, 9);
            RigidPose a = new(turn, offset);
            RigidPose b = new(Quaternion.Normalize(turn * standing.Rotation), a.TransformPoint(standing.Position));
            ContactManifold m = Ask(plank, a, can, b), swapped = Ask(can, b, plank, a).Swapped;
            Assert.Equal(4, m.Count);
            foreach (ManifoldPoint p in Points(m))
            {
                ManifoldPoint same = Points(swapped).Single(q => q.FeatureId == p.FeatureId);
                Assert.True((same.PointA - p.PointA).Length() < 0.1f, $"{i}: {new QueryRecord(plank, a, can, b)}");
            }
        }
    }

    private static long[] Names(ContactManifold m) => [.. Points(m).Select(p => p.FeatureId)];

    private static ConvexShape Shape(string name) => name switch
    {
        "box" => Unit,
        "floor" => ConvexShape.Box(new Vector3(5, 0.5f, 5)),
        "rounded" => ConvexShape.Box(new Vector3(0.4f)).Rounded(0.1f),
        "cylinder" => ConvexShape.Cylinder(0.5f, 0.5f),
        "cone" => ConvexShape.Cone(0.5f, 0.5f),
        _ => ConvexShape.Mesh(Clouds.Prism(int.Parse(name["prism".Length..]), 0.5f, 0.5f)),
    };
}
