namespace Gjk.Core;

/// <summary>Selects among numbered items on several threads, and keeps their order.</summary>
/// <typeparam name="T">What is selected.</typeparam>
internal sealed class Selection<T>
    where T : struct
{
    /// <summary>Count of items that one thread looks at in turn. A matter of speed only.</summary>
    private const int ShareLength = 2048;

    /// <summary>What each share selected, from the share's begin on, and how many.</summary>
    private T[] _selected = [];
    private int[] _counts = [];

    /// <summary>Adds the selected items to a list.</summary>
    /// <param name="selector">Is asked about each item once, by several threads at a time.</param>
    /// <param name="count">How many items there are.</param>
    /// <param name="results">The list.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    public void Collect<TSelector>(in TSelector selector, int count, List<T> results, Workers? workers)
        where TSelector : struct, ISelector<T>
    {
        int shares = Select(selector, count, workers);
        for (int share = 0; share < shares; share++)
        {
            int begin = share * ShareLength;
#if NET
            CollectionExtensions.AddRange(results, _selected.AsSpan(begin, _counts[share]));
#else
            for (int i = begin; i < begin + _counts[share]; i++) results.Add(_selected[i]);
#endif
        }
    }

    /// <summary>Writes the selected items to an array, which may be where the selector finds them.</summary>
    /// <returns>How many there are.</returns>
    public int CopyTo<TSelector>(in TSelector selector, int count, T[] results, Workers? workers)
        where TSelector : struct, ISelector<T>
    {
        int shares = Select(selector, count, workers), sum = 0;
        for (int share = 0; share < shares; sum += _counts[share++])
            Array.Copy(_selected, share * ShareLength, results, sum, _counts[share]);
        return sum;
    }

    private int Select<TSelector>(in TSelector selector, int count, Workers? workers)
        where TSelector : struct, ISelector<T>
    {
        if (_selected.Length < count)
        {
            int length = (int)Math.Min(Math.Max(2L * _selected.Length, count), int.MaxValue / 2);
            int[] counts = new int[length / ShareLength + 1];
            (_selected, _counts) = (new T[length], counts);
        }

        var job = new Job<TSelector>(selector, _selected, _counts);
        Workers.Run(workers, job, count, ShareLength);
        return (count + ShareLength - 1) / ShareLength;
    }

    private readonly struct Job<TSelector>(TSelector selector, T[] selected, int[] counts) : IShareJob
        where TSelector : struct, ISelector<T>
    {
        public void Run(int begin, int end)
        {
            TSelector ask = selector;
            int next = begin;
            for (int i = begin; i < end; i++)
                if (ask.TrySelect(i, out selected[next])) next++;
            counts[begin / ShareLength] = next - begin;
        }
    }
}

/// <summary>Says which of numbered items are wanted.</summary>
internal interface ISelector<T>
{
    /// <summary>Whether an item is wanted, and what it is; anything where it is not.</summary>
    bool TrySelect(int index, out T item);
}
