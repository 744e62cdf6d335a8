namespace Gjk.Core;

/// <summary>The corners between those that a disc is shown by. A turn of the disc is linear, so they are sums of
/// corners that are a quarter apart, as these lie in the contact plane.</summary>
internal static unsafe class DiscCorners
{
    /// <summary>Cosine and sine of a thirty-second of a turn, and of a sixty-fourth.</summary>
    private const double
        Cosine32 = 0.98078528040323043, Sine32 = 0.19509032201612825, Cosine64 = 0.99518472667219693,
        Sine64 = 0.098017140329560602;

    /// <summary>Puts a corner behind each that is there, half way to the next.</summary>
    /// <param name="corners">The corners, and room for twice as many.</param>
    /// <param name="count">How many there are: those that a shape shows, or twice as many.</param>
    public static void Double(FlatCorner* corners, int count)
    {
        FlatCorner* shown = stackalloc FlatCorner[FaceCorners.Capacity / 2];
        for (int i = 0; i < count; i++) shown[i] = corners[i];
        bool isFirst = count == FaceCorners.Capacity / FaceCorners.DiscStep;
        double cosine = isFirst ? Cosine32 : Cosine64, sine = isFirst ? Sine32 : Sine64;
        double middleU = 0.5 * (shown[0].U + shown[count / 2].U), middleV = 0.5 * (shown[0].V + shown[count / 2].V);
        double middleHeight = 0.5 * (shown[0].Height + shown[count / 2].Height), rest = 1 - cosine - sine;
        for (int i = 0; i < count; i++)
        {
            ref FlatCorner p = ref shown[i], across = ref shown[(i + count / 4) % count];
            corners[2 * i] = p;
            corners[2 * i + 1] = new FlatCorner
            {
                U = p.U * cosine + across.U * sine + middleU * rest,
                V = p.V * cosine + across.V * sine + middleV * rest,
                Height = p.Height * cosine + across.Height * sine + middleHeight * rest,
                Id = p.Id + (isFirst ? 2 : 1),
            };
        }
    }
}
