namespace Gjk.Import;

/// <summary>One thing in an input cannot be read. It is listed with its place, and the rest of the input is
/// imported.</summary>
/// <param name="reason">Why.</param>
/// <param name="kind">What else counts as the same; null for the same reason.</param>
internal sealed class UnreadableException(string reason, string? kind = null) : Exception(reason)
{
    public string? Kind { get; } = kind;
}
