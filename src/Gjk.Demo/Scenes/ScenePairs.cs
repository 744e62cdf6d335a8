namespace Gjk.Demo.Scenes;

/// <summary>The pairs of a scene, in order. They are either a list or, without one, all pairs i &lt; j. In the second
/// case even millions of pairs need no memory.</summary>
internal readonly struct ScenePairs
{
    private readonly int[]? _indices;
    private readonly int _objects;

    /// <summary>The first pair's place in the whole list; above 0 only in a shard.</summary>
    private readonly long _first;

    private ScenePairs(int[]? indices, int objects, long first, long count)
    {
        _indices = indices;
        _objects = objects;
        _first = first;
        Count = count;
    }

    public long Count { get; }

    /// <summary>All pairs i &lt; j. Those with the lowest i come first.</summary>
    public static ScenePairs All(int objects) => new(null, objects, 0, (long)objects * (objects - 1) / 2);

    /// <summary>The pairs of a list, which holds a and b of the first pair, then a and b of the second, and so
    /// on.</summary>
    public static ScenePairs Listed(int[] indices) => new(indices, 0, 0, indices.Length / 2);

    /// <summary>One of so many parts that follow each other, are as long as each other but for one pair, and depend on
    /// nothing but the three numbers.</summary>
    /// <param name="number">From 1.</param>
    /// <param name="of">How many parts there are.</param>
    public ScenePairs Shard(int number, int of)
    {
        long from = (long)((Int128)Count * (number - 1) / of), to = (long)((Int128)Count * number / of);
        return new ScenePairs(_indices, _objects, _first + from, to - from);
    }

    /// <summary>Copies both members of every pair, each into an array of its own.</summary>
    public void CopyTo(Span<int> a, Span<int> b)
    {
        int i = 0;
        foreach ((int first, int second) in this)
        {
            a[i] = first;
            b[i++] = second;
        }
    }

    public Enumerator GetEnumerator() => new(this);

    public struct Enumerator
    {
        private readonly int[]? _indices;
        private readonly int _objects;
        private long _next, _left;
        private int _a, _b;

        public Enumerator(in ScenePairs pairs)
        {
            (_indices, _objects, _left) = (pairs._indices, pairs._objects, pairs.Count);
            if (_indices is not null) _next = 2 * pairs._first;
            else (_a, _b) = Before(pairs._first, pairs._objects);
        }

        public readonly (int A, int B) Current => (_a, _b);

        public bool MoveNext()
        {
            if (--_left < 0) return false;
            if (_indices is not null)
            {
                _a = _indices[_next];
                _b = _indices[_next + 1];
                _next += 2;
            }
            else if (++_b >= _objects)
            {
                _b = ++_a + 1;
            }

            return true;
        }

        /// <summary>The state from which one step leads to the pair at a place in the list of all pairs.</summary>
        private static (int A, int B) Before(long place, long objects)
        {
            // The pairs of the objects before a take a * (2 * objects - a - 1) / 2 places.
            long low = 0, high = objects;
            while (high - low > 1)
            {
                long a = (low + high) / 2;
                if (a * (2 * objects - a - 1) / 2 <= place) low = a;
                else high = a;
            }

            return ((int)low, (int)(low + place - low * (2 * objects - low - 1) / 2));
        }
    }
}
