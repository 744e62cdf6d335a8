namespace Gjk.Demo.Tests.Fuzz;

/// <summary>The meshes that fuzz generates have the features of real ones: tiny poles, doubled seams, repeated
/// vertices, and copies one float apart.</summary>
public sealed class MadeMeshTests
{
    private const int Draws = 400;

    [Fact]
    public void ASpheresPolesAreAsWideAsTheSineOfPi()
    {
        int inDouble = 0, inFloat = 0, seams = 0;
        foreach (Vector3[] sphere in Many(Lathe.Sphere))
        {
            Assert.All(sphere, p => Assert.InRange(p.Length(), 0.99999f, 1.00001f));
            float pole = sphere.Where(p => p.Y < -0.9999999f).Max(p => Math.Max(Math.Abs(p.X), Math.Abs(p.Z)));
            Assert.InRange(pole, 1e-17, 1e-6);
            if (pole < 1e-12) inDouble++;
            else inFloat++;
            if (sphere.Length != sphere.Distinct().Count()) seams++;
        }

        Assert.True(
            inDouble > Draws / 4 && inFloat > Draws / 4 && seams > Draws / 4,
            $"{inDouble} in double, {inFloat} in float, {seams} with seams or repeats");
    }

    [Fact]
    public void RoundMeshesHaveFromThreeToFortyPointsARing()
    {
        int[] counts = [.. Many(random => new Vector3[Lathe.Count(random)]).Select(c => c.Length)];
        Assert.Equal(3, counts.Min());
        Assert.InRange(counts.Max(), 30, 40);
    }

    [Fact]
    public void AnIcosphereIsASphere()
    {
        foreach (Vector3[] sphere in Many(Icosphere.Any))
        {
            Assert.All(sphere, p => Assert.InRange(p.Length(), 0.999999f, 1.000001f));
            int faces = sphere.Length / 3;
            Assert.Contains(faces, (int[])[20, 80, 320]);

            // By Euler's formula there are half as many corners as faces, plus two. The middles of one edge may differ
            // in the last place where they were rounded on the way.
            int corners = sphere.Select(p => Vector3.Truncate(p * 1e4f)).Distinct().Count();
            Assert.InRange(corners, faces / 2 + 2, faces / 2 + 40);
        }
    }

    [Fact]
    public void ABevelledBoxHasThreePointsForEveryCorner()
    {
        double least = 1, most = 0;
        foreach (Vector3[] box in Many(Boxes.Bevelled))
        {
            Assert.Equal(24, box.Length);
            for (int i = 0; i < box.Length; i += 3)
            {
                double width = (box[i] - box[i + 1]).Length() / box[i].Length();
                Assert.InRange(width, 0, 0.2);
                (least, most) = (Math.Min(least, width), Math.Max(most, width));
            }
        }

        Assert.True(least < 1e-6 && most > 0.03, $"from {least} to {most}");
    }

    [Fact]
    public void CopiesAreOneFloatAway()
    {
        Vector3[] cloud = [new(1, -2, 0.3f), new(0, 1e-20f, -1)];
        Vector3[] copies = Copies.OneFloatApart(new Rng(1), cloud, 50);
        Assert.Equal(2 + 100, copies.Length);
        Assert.True(copies.Distinct().Count() > 20);
        for (int i = 0; i < copies.Length; i++)
        {
            foreach (int axis in (int[])[0, 1, 2])
                Assert.InRange(
                    copies[i][axis], MathF.BitDecrement(cloud[i % 2][axis]), MathF.BitIncrement(cloud[i % 2][axis]));
        }
    }

    [Fact]
    public void AScansNoiseIsAsLargeAsAsked()
    {
        Vector3[] cloud = Clouds.OnSphere(new Rng(2), 200);
        Vector3[] scan = Copies.Scanned(new Rng(3), cloud, 1e-3);
        Assert.InRange(cloud.Zip(scan, (p, q) => (p - q).Length()).Max(), 1e-3, 1.8e-3);
    }

    /// <summary>No generator may give points that a hull refuses, or so many points that a search spends all its time
    /// on them.</summary>
    [Fact]
    public void EveryMeshIsFiniteAndOfAModestSize()
    {
        int solid = 0, repeated = 0;
        foreach (Vector3[] cloud in Many(MadeMeshes.Any).Concat(Many(MadeMeshes.Baked)))
        {
            Assert.InRange(cloud.Length, 4, 4000);
            Assert.True(
                cloud.All(p => float.IsFinite(p.X) && float.IsFinite(p.Y) && float.IsFinite(p.Z) && p.Length() < 100));
            solid += new ConvexHull(cloud).Dimension == 3 ? 1 : 0;
            repeated += cloud.Length > cloud.Distinct().Count() ? 1 : 0;
        }

        Assert.True(solid > 1.5 * Draws && repeated > 0.5 * Draws, $"{solid} solids, {repeated} with repeats");
    }

    [Fact]
    public void ASeedGivesTheSameMesh()
    {
        foreach (ulong seed in (ulong[])[1, 2, 3, 4, 5])
            Assert.Equal(MadeMeshes.Any(new Rng(seed)), MadeMeshes.Any(new Rng(seed)));
    }

    private static IEnumerable<Vector3[]> Many(Func<Rng, Vector3[]> make)
    {
        for (ulong seed = 0; seed < Draws; seed++) yield return make(new Rng(seed));
    }
}
