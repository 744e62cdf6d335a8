using static Gjk.Core.Tests.Support.SameMass;

namespace Gjk.Core.Tests.Concave;

/// <summary>Mass, centre and inertia of polyhedra, against integers; of compounds; and what has none.</summary>
public class MassTests
{
    private static readonly RigidPose Pose =
        new(Quaternion.Normalize(new Quaternion(0.2f, -0.5f, 0.4f, 0.7f)), new Vector3(3, -7, 5));

    private static readonly Vector3 Uneven = new(0.7f, -1.9f, 1.3f);

    [Fact]
    public void ItIsASentence()
    {
        MassProperties crate = ConvexShape.Box(Vector3.One).Placed(new RigidPose(new Vector3(1, 2, 3)))
            .GetMassProperties(3);
        Assert.Equal("mass 24, volume 8, centre <1, 2, 3>, inertia <16, 16, 16> and <0, 0, 0>", crate.ToString());
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(0, 1000)]
    [InlineData(60, 0)]
    [InlineData(-60, 0)]
    [InlineData(-60, 1000)]
    public void HullsAreRightToTheRounding(int power, float away)
    {
        int seen = 0;
        for (ulong seed = 1; seed <= 60; seed++)
        {
            var random = new Rng(seed);
            Vector3[] cloud = seed % 2 == 0
                ? Clouds.InBox(random, 4 + random.Below(40), new Vector3(1, random.Float(1e-3, 1), 1))
                : MadeMeshes.Baked(random);
            float size = MathF.ScaleB(1, power);
            var hull = new ConvexHull(Array.ConvertAll(cloud, p => (p + new Vector3(away, 0, -away)) * size));
            if (hull.Dimension < 3) continue;
            seen++;
            Same(ExactOf(hull), ConvexShape.Mesh(hull).GetMassProperties(), $"seed {seed}");
        }

        Assert.True(seen > 50, $"{seen}");
    }

    [Theory]
    [InlineData("ball")]
    [InlineData("gear")]
    [InlineData("ring")]
    [InlineData("rock")]
    public void SolidsAreRightToTheRoundingWhicheverWayTheyAreTurned(string name)
    {
        TriangleMesh plain = Solids.Named(name, 3);
        Vector3[] far = [.. Enumerable.Range(0, plain.VertexCount).Select(i => plain.GetVertex(i) + new Vector3(5e4f))];
        foreach (TriangleMesh mesh in new[] { plain, plain.Scaled(Uneven), plain.WithVertices(far) })
        {
            ExactMass exact = ExactOf(mesh, Solids.Sign(mesh));
            Same(exact, mesh.GetMassProperties(), name);
            Same(exact, Solids.Flipped(mesh).Scaled(mesh.Scale).GetMassProperties(), name + " flipped");
            Same(exact, AnyShape.Solid(mesh).GetMassProperties(), name + " as any");
        }
    }

    [Fact]
    public void PiecesCountEachWithTheirOwnTurnAndCavitiesDoNot()
    {
        TriangleMesh cube = Solids.Box(-Vector3.One, Vector3.One), inner = Solids.Scaled(cube, 0.5f);
        TriangleMesh apart = Solids.Joined((cube, default), (Solids.Flipped(cube), new Vector3(4, 0, 0)));
        Assert.Equal((16, 2), (apart.GetMassProperties().Volume, apart.GetMassProperties().Center.X));
        TriangleMesh hollow = Solids.Joined((cube, default), (Solids.Flipped(inner), default));
        Assert.Equal((7, 7), (hollow.GetMassProperties().Volume, Solids.Flipped(hollow).GetMassProperties().Volume));
        Assert.Equal(9, Solids.Joined((cube, default), (inner, default)).GetMassProperties().Volume);
    }

    [Fact]
    public void WhatIsFoldedFlatHasNoVolume()
    {
        for (ulong seed = 1; seed <= 200; seed++)
        {
            var random = new Rng(seed);
            Vector3[] corners = [random.Vector(1), random.Vector(1), random.Vector(1)];
            MassProperties none = new TriangleMesh(corners, [0, 1, 2, 1, 0, 2]).Scaled(Uneven).GetMassProperties();
            Assert.Equal((0, 0, default), (none.Volume, none.Mass, none.InertiaDiagonal));
            Assert.True(none.Center.SumOfMagnitudes < 4, $"seed {seed}: {none.Center}");

            // A float away from the middle of the plane there is a volume.
            Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
            corners = [.. corners, new Vector3(middle.X, middle.Y, middle.Z + 1e-6f)];
            TriangleMesh thin = new TriangleMesh(corners, [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]).Scaled(Uneven);
            Same(ExactOf(thin, Solids.Sign(thin)), thin.GetMassProperties(), $"seed {seed}, thin");
        }
    }

    [Fact]
    public void ACompoundIsTheSumOfItsParts()
    {
        ConvexShape half = ConvexShape.Box(new Vector3(0.5f, 1, 2));
        var compound = new CompoundShape(
            [new(half, new RigidPose(new Vector3(0.5f, 1, 4))), new(half, new RigidPose(new Vector3(-0.5f, 1, 4)))]);
        Near(
            ConvexShape.Box(new Vector3(1, 1, 2)).Placed(new RigidPose(new Vector3(0, 1, 4))).GetMassProperties(2),
            AnyShape.Of(compound).GetMassProperties(2), 1e-15);
        MassProperties light = half.GetMassProperties(0);
        Assert.Equal((light.Center, 0), ((light + light).Center, (light + light).Mass));
        MassProperties askew = half.GetMassProperties()
            + half.Placed(new RigidPose(new Vector3(1, 2, 3))).GetMassProperties();
        Assert.Equal(new Double3(0.5, 1, 1.5), askew.Center);
        Assert.Equal(new Double3(-8, -12, -24), askew.InertiaProducts);
    }

    [Fact]
    public void WhatHasNoVolumeHasACentre()
    {
        Vector3 a = new(1, 2, 3), b = new(3, 2, 1), c = new(2, 5, 2);
        (ConvexShape Shape, Double3 Center)[] flat =
        [
            (ConvexShape.Point().Placed(new RigidPose(a)), a), (ConvexShape.Segment(a, b), new Double3(2, 2, 2)),
            (ConvexShape.Triangle(a, b, c), new Double3(2, 3, 2)),
            (ConvexShape.Mesh([a, b, c]), new Double3(2, 3.5, 2)), (ConvexShape.TaperedCapsule(0, 0, 1), default),
            (ConvexShape.Cone(0, 1), default), (ConvexShape.Cone(1, 0), default),
            (ConvexShape.Box(new Vector3(1, 0, 1)), default), (ConvexShape.Sphere(0), default),
        ];
        foreach ((ConvexShape shape, Double3 center) in flat)
        {
            MassProperties found = shape.GetMassProperties(2);
            Assert.Equal((0, 0, default), (found.Volume, found.Mass, found.InertiaDiagonal));
            Assert.Equal(0, found.InertiaProducts.Length);
            Assert.True((found.Center - center).Length < 1e-15, $"{shape}: {found.Center}");
        }
    }

    [Fact]
    public void WhatHasNoFormIsRefusedInWords()
    {
        ConvexShape cone = ConvexShape.Cone(1, 1), mesh = ConvexShape.Mesh(Clouds.Box(Vector3.One));
        (string Words, Func<MassProperties> Ask)[] refused =
        [
            ("A half-space", () => ConvexShape.HalfSpace(Vector3.UnitY, 0).GetMassProperties()),
            ("A rounded ellipsoid", () => ConvexShape.Ellipsoid(Vector3.One).Rounded(1).GetMassProperties()),
            ("unevenly", () => cone.Scaled(Uneven).Rounded(1).GetMassProperties()),
            ("after it was scaled", () => mesh.Scaled(Uneven).Rounded(1).GetMassProperties()),
            ("unevenly", () => ConvexShape.Capsule(1, 1).Scaled(Uneven).Rounded(1).GetMassProperties()),
            ("after it was scaled", () => cone.Placed(Pose).Scaled(Uneven).Rounded(1).GetMassProperties()),
            ("A custom shape", () => ConvexShape.Custom(new SphereShape(1)).GetMassProperties()),
            ("A default ConvexShape", () => default(ConvexShape).GetMassProperties()),
            ("A default ConvexShape", () => default(AnyShape).GetMassProperties()),
            ("A surface", () => AnyShape.Surface(Solids.Named("ball", 1)).GetMassProperties()),
            ("The edge from vertex 0", () => new TriangleMesh([default, Vector3.UnitX, Vector3.UnitY], [0, 1, 2])
                .GetMassProperties()),
        ];
        foreach ((string words, Func<MassProperties> ask) in refused)
            Assert.Contains(words, Assert.Throws<InvalidOperationException>(() => ask()).Message);
        foreach (float density in new[] { -1, float.NaN, float.PositiveInfinity })
        {
            Assert.Throws<ArgumentOutOfRangeException>("density", () => cone.GetMassProperties(density));
            TriangleMesh ball = Solids.Named("ball", 1);
            Assert.Throws<ArgumentOutOfRangeException>("density", () => ball.GetMassProperties(density));
        }

        Assert.Throws<ArgumentOutOfRangeException>("pose", () => cone.GetMassProperties().At(default));
    }

    [Fact]
    public void NothingIsAllocated()
    {
        ConvexShape[] shapes =
        [
            ConvexShape.TaperedCapsule(1, 2, 3).Placed(Pose), ConvexShape.Mesh(Clouds.Box(Vector3.One)),
            ConvexShape.Box(Vector3.One).Rounded(1).Scaled(Uneven),
        ];
        TriangleMesh solid = Solids.Named("ring", 1);
        double sum = 0;
        Assert.Equal(0, Allocation.Least(() =>
        {
            foreach (ConvexShape shape in shapes) sum += shape.GetMassProperties().Mass;
            sum += solid.GetMassProperties().Mass;
        }));
        Assert.True(sum > 0);
    }
}
