using System.Globalization;

namespace Gjk.Mutation;

/// <summary>One change of one place of the sources.</summary>
/// <param name="Id">Its number; the same as long as the sources are.</param>
/// <param name="Operator">The kind of change.</param>
/// <param name="File">Path below src/Gjk.Core.</param>
/// <param name="Line">From 1.</param>
/// <param name="Original">What stands there.</param>
/// <param name="Changed">What it becomes.</param>
/// <param name="Pins">The tests that a constant's comment names.</param>
internal sealed record Mutant(
    int Id, string Operator, string File, int Line, string Original, string Changed, string[] Pins)
{
    public string Place => string.Create(CultureInfo.InvariantCulture, $"{File}:{Line}");
}
