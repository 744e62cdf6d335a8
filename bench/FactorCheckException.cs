namespace Gjk.Bench;

/// <summary>The library and the baseline give different answers, so comparing their times would be
/// meaningless.</summary>
public sealed class FactorCheckException(string message) : Exception(message);
