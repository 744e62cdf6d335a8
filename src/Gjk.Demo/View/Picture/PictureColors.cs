using System;
using System.Globalization;

namespace Gjk.Demo.View;

/// <summary>
/// The two colours of the page and the picture. Red marks objects that intersect, green marks the others.
/// </summary>
internal static class PictureColors
{
    public static string Of(bool isHit, double brightness)
    {
        (int r, int g, int b) = isHit ? (0xe5, 0x48, 0x4d) : (0x38, 0xa8, 0x73);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"#{Scaled(r, brightness):x2}{Scaled(g, brightness):x2}{Scaled(b, brightness):x2}");
    }

    private static int Scaled(int value, double brightness) => (int)Math.Clamp(Math.Round(value * brightness), 0, 255);
}
