using System;

namespace Gjk.Import;

/// <summary>
/// One thing in an input cannot be read. It is listed with its place, and the rest of the input is imported.
/// </summary>
internal sealed class UnreadableException(string reason) : Exception(reason);
