using System;
using System.Collections.Generic;
using Gjk.Demo.Output;

namespace Gjk.Demo.Import;

/// <summary>
/// What could not be read, and what was read but may surprise. Both are printed at the end, in the order in which they
/// were found, because a refusal must stay a single line.
/// </summary>
internal sealed class ImportLog
{
    private readonly List<string> _lines = [];
    private readonly HashSet<string> _known = new(StringComparer.Ordinal);

    /// <summary>The lines so far.</summary>
    public IReadOnlyList<string> Lines => _lines;

    /// <summary>How many things could not be read.</summary>
    public int Missing { get; private set; }

    /// <summary>Something that the scene lacks now.</summary>
    /// <param name="where">File, line and fileID.</param>
    /// <param name="reason">Why it cannot be read.</param>
    public void CannotRead(string where, string reason)
    {
        if (!_known.Add($"{where}: {reason}")) return;
        Missing++;
        _lines.Add($"{where}: {reason}");
    }

    /// <summary>
    /// Something that is in the scene, but perhaps not as the user expects. Repeats are printed once.
    /// </summary>
    public void Warn(string where, string what)
    {
        if (_known.Add($"{where}: warning: {what}")) _lines.Add($"{where}: warning: {what}");
    }

    public void Print()
    {
        foreach (string line in _lines) StandardError.Line(line);
    }
}
