using System.Globalization;

namespace Gjk.Exact.Fuzz;

/// <summary>Sentences with numbers in invariant culture.</summary>
internal static class Say
{
    public static string Line(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
