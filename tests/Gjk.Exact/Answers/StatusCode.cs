namespace Gjk.Exact.Answers;

/// <summary>The number of a status in result hashes and in the pages of `view`: 0 separated, 1 overlapping, 2 beyond
/// the largest distance, 3 iteration limit, 4 invalid input, 5 invalid shape. These numbers do not depend on the values
/// of <see cref="GjkStatus"/>.</summary>
public static class StatusCode
{
    public static byte Of(GjkStatus status) => (byte)(status - GjkStatus.Separated);
}
