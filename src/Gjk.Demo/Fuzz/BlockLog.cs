using Gjk.Exact.Fuzz.Blocks;

namespace Gjk.Demo.Fuzz;

/// <summary>The log of a run that may take several sittings: a line for each finished block, and the refuted pairs in a
/// file beside it. Without a file it only counts. Held open, so that no other process continues it too.</summary>
internal sealed class BlockLog : IDisposable
{
    private const string Header = "# gjk-demo fuzz --certificate --seed ";

    private readonly SortedDictionary<long, BlockResult> _blocks = [];
    private readonly FileStream? _file;
    private readonly string? _name;

    private BlockLog(ulong seed, string? name, FileStream? file)
    {
        Seed = seed;
        _name = name;
        _file = file;
    }

    /// <summary>Of the run.</summary>
    public ulong Seed { get; }

    /// <summary>The finished blocks by their numbers.</summary>
    public IReadOnlyDictionary<long, BlockResult> Blocks => _blocks;

    /// <summary>How many pairs they have.</summary>
    public long Pairs => _blocks.Values.Sum(b => b.Pairs);

    /// <summary>The file of the refuted pairs, or null.</summary>
    public string? FindsName => _name is null ? null : _name + ".finds";

    /// <summary>Opens a log, or begins one.</summary>
    /// <param name="name">The file as the user named it; null: none.</param>
    /// <param name="seed">Of the run; null: that of the log, or another one each time.</param>
    /// <param name="cancel">Ends the reading.</param>
    /// <exception cref="RefusedException">It cannot be read or written, is no log, or one of another seed.</exception>
    public static BlockLog Open(string? name, ulong? seed, CancellationToken cancel)
    {
        ulong own = seed ?? (ulong)Random.Shared.Next();
        if (name is null) return new BlockLog(own, null, null);
        FileStream? file = null;
        try
        {
            file = new FileStream(name, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
            if (file.Length == 0)
            {
                Append(file, Header + own.ToString(CultureInfo.InvariantCulture) + "\n" + BlockResult.Columns + "\n");
                return new BlockLog(own, name, file);
            }

            cancel.ThrowIfCancellationRequested();
            using var reader = new StreamReader(file, Encoding.UTF8, false, -1, leaveOpen: true);
            return Read(name, reader.ReadToEnd(), seed, file);
        }
        catch (Exception e)
        {
            file?.Dispose();
            if (RefusedException.IsFileTrouble(e)) throw new RefusedException(name, "cannot be continued", e);
            throw;
        }
    }

    /// <summary>Adds a finished block, and what it found.</summary>
    /// <exception cref="RefusedException">It cannot be written.</exception>
    public void Add(BlockResult result, IReadOnlyList<BlockFind> finds)
    {
        _blocks.Add(result.Number, result);
        if (_file is null) return;
        try
        {
            // The finds first: a block that is in the log is not asked again.
            foreach (BlockFind find in finds) File.AppendAllText(FindsName!, find.Text);
            Append(_file, result.Line + "\n");
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(_name!, "cannot be written", e);
        }
    }

    public void Dispose() => _file?.Dispose();

    private static BlockLog Read(string name, string text, ulong? seed, FileStream file)
    {
        string[] lines = text.Split('\n');
        if (!lines[0].StartsWith(Header, StringComparison.Ordinal)
            || !ulong.TryParse(
                lines[0].AsSpan(Header.Length), NumberStyles.None, CultureInfo.InvariantCulture, out ulong own))
        {
            throw new RefusedException($"{name}: line 1: this is no log of fuzz --certificate");
        }

        if (seed is { } given && given != own)
            throw new RefusedException($"{name}: line 1: it is of the seed {own}, not {given}");
        if (lines.Length < 2 || lines[1] != BlockResult.Columns)
            throw new RefusedException($"{name}: line 2: it should be {BlockResult.Columns}");
        if (lines[^1].Length > 0) throw new RefusedException($"{name}: line {lines.Length}: its end is missing");
        var log = new BlockLog(own, name, file);
        for (int i = 2; i < lines.Length - 1; i++)
        {
            bool isBlock = BlockResult.TryParse(lines[i], out BlockResult block);
            if (!isBlock || block.Seed != BlockResult.SeedOf(own, block.Number))
                throw new RefusedException($"{name}: line {i + 1}: it is no block of the seed {own}");
            if (!log._blocks.TryAdd(block.Number, block))
                throw new RefusedException($"{name}: line {i + 1}: the block {block.Number} is there already");
        }

        return log;
    }

    /// <summary>One write, down to the disk: a line is there as a whole or not at all.</summary>
    private static void Append(FileStream file, string text)
    {
        file.Seek(0, SeekOrigin.End);
        file.Write(Encoding.ASCII.GetBytes(text));
        file.Flush(flushToDisk: true);
    }
}
