namespace Gjk.Bench.Reporting;

/// <summary>Writes times in a unit that is easy to read.</summary>
internal static class TimeText
{
    public static string Of(double nanoseconds) => nanoseconds switch
    {
        < 1e3 => nanoseconds.ToString("0.## ns", CultureInfo.InvariantCulture),
        < 1e6 => (nanoseconds / 1e3).ToString("0.## µs", CultureInfo.InvariantCulture),
        < 1e9 => (nanoseconds / 1e6).ToString("0.## ms", CultureInfo.InvariantCulture),
        _ => (nanoseconds / 1e9).ToString("0.## s", CultureInfo.InvariantCulture),
    };
}
