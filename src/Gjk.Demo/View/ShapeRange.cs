namespace Gjk.Demo.View;

/// <summary>Checks that the corners of the shapes are floats. The queries themselves also answer for larger shapes, but
/// a page or a picture is drawn from corners.</summary>
internal static class ShapeRange
{
    private static readonly Double3[] Axes =
        [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1)];

    /// <param name="scene">The scene, all of whose objects are drawn.</param>
    /// <param name="name">The user's name for it.</param>
    /// <exception cref="RefusedException">A shape with its scale is too large.</exception>
    public static void Check(Scene scene, string name)
    {
        for (int i = 0; i < scene.Objects.Length; i++) Check(scene, name, i);
    }

    /// <summary>Checks one object.</summary>
    /// <inheritdoc cref="Check(Scene, string)"/>
    public static void Check(Scene scene, string name, int index)
    {
        if (scene.Objects[index].Shape.Kind == ShapeKind.HalfSpace)
        {
            throw new RefusedException(
                $"{name}: $.objects[{index}]: a half-space has no end, so it cannot be drawn");
        }

        foreach (Double3 axis in Axes)
        {
            Double3 point = SupportSamples.Support(scene.Objects[index].Any, axis);
            if (Math.Max(Math.Max(Math.Abs(point.X), Math.Abs(point.Y)), Math.Abs(point.Z)) <= float.MaxValue) continue;
            throw new RefusedException(
                $"{name}: $.objects[{index}]: the shape with its scale leaves the range of float, so it cannot be "
                + "drawn");
        }
    }
}
