using System;

namespace Gjk.Bench;

/// <summary>The library and the baseline answer differently, so that timing them would compare nothing.</summary>
public sealed class FactorCheckException(string message) : Exception(message);
