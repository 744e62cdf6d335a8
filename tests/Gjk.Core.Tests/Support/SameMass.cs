namespace Gjk.Core.Tests.Support;

/// <summary>Exact mass properties of hulls and meshes, and whether others are the same.</summary>
internal static class SameMass
{
    /// <summary>Ratio: two roundings of double.</summary>
    private const double Rounding = 4.5e-16;

    public static ExactMass ExactOf(ConvexHull hull) => new([.. Enumerable.Range(0, hull.TriangleCount).Select(i =>
    {
        hull.GetTriangle(i, out int a, out int b, out int c);
        return new Double3[] { hull.GetVertex(a), hull.GetVertex(b), hull.GetVertex(c) };
    })]);

    public static ExactMass ExactOf(TriangleMesh mesh, int side) =>
        new([.. Enumerable.Range(0, mesh.TriangleCount).Select(i =>
        {
            mesh.GetTriangle(i, out int a, out int b, out int c);
            Double3[] p = [.. new[] { a, b, c }.Select(v => Double3.Multiply(mesh.GetVertex(v), mesh.Scale))];
            return side * mesh.Scale.X * mesh.Scale.Y * mesh.Scale.Z > 0 ? p : [p[0], p[2], p[1]];
        })]);

    public static void Same(ExactMass exact, MassProperties found, string what)
    {
        double size = exact.Diagonal.SumOfMagnitudes, at = exact.Center.SumOfMagnitudes;
        double tiny = 1e-28 * Math.Sqrt(size / exact.Volume);
        Assert.True(Math.Abs(found.Volume / exact.Volume - 1) <= Rounding, $"{what}: {found.Volume} {exact.Volume}");
        Assert.True((found.Center - exact.Center).Length <= Rounding * at + tiny, $"{what}: {found.Center}");
        Assert.True(
            (found.InertiaDiagonal - exact.Diagonal).Length <= Rounding * size,
            $"{what}: {found.InertiaDiagonal} {exact.Diagonal}");
        Assert.True(
            (found.InertiaProducts - exact.Products).Length <= Rounding * size,
            $"{what}: {found.InertiaProducts} {exact.Products}");
    }

    public static void Near(ConvexShape one, ConvexShape other, double ratio = 4e-15) =>
        Near(one.GetMassProperties(), other.GetMassProperties(), ratio);

    public static void Near(MassProperties one, MassProperties other, double ratio)
    {
        double size = one.InertiaDiagonal.Length;
        Assert.InRange(other.Volume / one.Volume, 1 - ratio, 1 + ratio);
        Assert.InRange(other.Mass / one.Mass, 1 - ratio, 1 + ratio);
        Assert.True((one.Center - other.Center).Length <= ratio * (1 + one.Center.Length), $"{other.Center}");
        Assert.True(
            (one.InertiaDiagonal - other.InertiaDiagonal).Length <= ratio * size,
            $"{one.InertiaDiagonal} {other.InertiaDiagonal}");
        Assert.True((one.InertiaProducts - other.InertiaProducts).Length <= ratio * size);
    }
}
