using System.Threading;
using System.Threading.Tasks;

namespace Gjk.Exact.Fuzz.Blocks;

/// <summary>Asks about pairs on several threads, block by block, until so many are done. Which pairs a block has
/// depends on its number alone, and blocks that an earlier sitting left out come first.</summary>
internal sealed class BlockRun
{
    /// <summary>Pairs: some seconds' work, which is what a sitting may lose at its end.</summary>
    public const long PairsOfABlock = 1_000_000;

    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(100);

    private readonly ulong _seed;
    private readonly IReadOnlyDictionary<long, BlockResult> _done;
    private readonly long _pairs, _pairsOfABlock;
    private readonly Lock _lock = new();
    private readonly Action<BlockResult, List<BlockFind>> _finished;
    private long _left, _next, _tried;

    /// <param name="seed">Of the run.</param>
    /// <param name="done">The finished blocks by their numbers; <paramref name="finished"/> may add to it.</param>
    /// <param name="pairs">How many pairs there are to be, those that are done included.</param>
    /// <param name="finished">Told each block and what is refuted in it, one at a time.</param>
    /// <param name="pairsOfABlock">How many pairs a block has; the last one may have less.</param>
    public BlockRun(
        ulong seed, IReadOnlyDictionary<long, BlockResult> done, long pairs,
        Action<BlockResult, List<BlockFind>> finished, long pairsOfABlock = PairsOfABlock)
    {
        (_seed, _done, _finished) = (seed, done, finished);
        (_pairs, _pairsOfABlock) = (pairs, pairsOfABlock);
        _tried = done.Values.Sum(b => b.Pairs);
        _left = pairs - _tried;
    }

    /// <param name="threads">How many at once.</param>
    /// <param name="progress">Told on this thread how much is done, from 0 to 1.</param>
    /// <param name="cancel">Ends it; unfinished blocks are dropped.</param>
    public void Run(int threads, Action<double> progress, CancellationToken cancel)
    {
        using var ending = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        Task[] workers = [.. Enumerable.Range(0, threads).Select(_ => Task.Factory.StartNew(
            () => Work(ending), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default))];
        var all = Task.WhenAll(workers);
        while (!((IAsyncResult)all).AsyncWaitHandle.WaitOne(Look))
            progress(Math.Min(1, Interlocked.Read(ref _tried) / (double)_pairs));
        all.GetAwaiter().GetResult();
    }

    private void Work(CancellationTokenSource ending)
    {
        try
        {
            while (!ending.IsCancellationRequested && TryClaim(out long number, out long pairs))
            {
                BlockResult? result = BlockResult.Run(
                    number, _seed, pairs, () => ending.IsCancellationRequested,
                    count => Interlocked.Add(ref _tried, count), out List<BlockFind> finds);
                if (result is not { } block) return;
                lock (_lock) _finished(block, finds);
            }
        }
        catch
        {
            // The other threads need not go on where a block cannot be kept.
            ending.Cancel();
            throw;
        }
    }

    /// <summary>The next block that is neither done nor at work.</summary>
    private bool TryClaim(out long number, out long pairs)
    {
        lock (_lock)
        {
            pairs = Math.Min(_pairsOfABlock, _left);
            while (_done.ContainsKey(_next)) _next++;
            number = _next;
            if (pairs <= 0) return false;
            _left -= pairs;
            _next++;
            return true;
        }
    }
}
