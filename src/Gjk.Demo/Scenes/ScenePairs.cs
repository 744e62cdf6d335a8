using System;

namespace Gjk.Demo.Scenes;

/// <summary>
/// The pairs of a scene, in order. They are either a list or, without one, all pairs i &lt; j. In the second case even
/// millions of pairs need no memory.
/// </summary>
internal readonly struct ScenePairs
{
    private readonly int[]? _indices;
    private readonly int _objects;

    private ScenePairs(int[]? indices, int objects, long count)
    {
        _indices = indices;
        _objects = objects;
        Count = count;
    }

    public long Count { get; }

    /// <summary>All pairs i &lt; j. Those with the lowest i come first.</summary>
    public static ScenePairs All(int objects) => new(null, objects, (long)objects * (objects - 1) / 2);

    /// <summary>
    /// The pairs of a list, which holds a and b of the first pair, then a and b of the second, and so on.
    /// </summary>
    public static ScenePairs Listed(int[] indices) => new(indices, 0, indices.Length / 2);

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
        private int _next;
        private int _a, _b;

        public Enumerator(in ScenePairs pairs)
        {
            _indices = pairs._indices;
            _objects = pairs._objects;
        }

        public readonly (int A, int B) Current => (_a, _b);

        public bool MoveNext()
        {
            if (_indices is null)
            {
                if (++_b < _objects) return true;
                _b = ++_a + 1;
                return _b < _objects;
            }

            if (_next >= _indices.Length) return false;
            _a = _indices[_next];
            _b = _indices[_next + 1];
            _next += 2;
            return true;
        }
    }
}
