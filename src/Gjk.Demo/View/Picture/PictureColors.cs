namespace Gjk.Demo.View;

/// <summary>The colours of the page and the picture. Red marks objects that intersect, green the others, and yellow the
/// triangles and parts that an answer is about.</summary>
internal static class PictureColors
{
    public static string Of(PictureTone tone, double brightness)
    {
        (int r, int g, int b) = tone switch
        {
            PictureTone.Hit => (0xe5, 0x48, 0x4d),
            PictureTone.Lit => (0xff, 0xd1, 0x66),
            _ => (0x38, 0xa8, 0x73),
        };
        return string.Create(
            CultureInfo.InvariantCulture,
            $"#{Scaled(r, brightness):x2}{Scaled(g, brightness):x2}{Scaled(b, brightness):x2}");
    }

    private static int Scaled(int value, double brightness) => (int)Math.Clamp(Math.Round(value * brightness), 0, 255);
}

/// <summary>What the colour of a body says.</summary>
internal enum PictureTone
{
    Free,

    /// <summary>It intersects another.</summary>
    Hit,

    /// <summary>It is the triangle or part that a shown answer is about.</summary>
    Lit,
}
