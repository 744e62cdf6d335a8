namespace Gjk.Exact.Answers;

/// <summary>A hash of results: FNV-1a, 64 bits. For each pair in order it takes a, b (int32), the status (byte, see
/// <see cref="StatusCode"/>), and the IEEE bits of the distance, both points and the normal. All are little-endian, and
/// -0 counts as +0. Iterations are not in it. Programs print it; <see cref="BitHash"/> holds every field.</summary>
public struct ResultHash
{
    private Fnv1a _hash = new();

    public ResultHash()
    {
    }

    public void Add(int a, int b, in DistanceResult result)
    {
        _hash.Add((uint)a);
        _hash.Add((uint)b);
        _hash.Add(StatusCode.Of(result.Status));
        Add(result.Distance);
        Add(result.PointA);
        Add(result.PointB);
        Add(result.Normal);
    }

#if NET
    /// <summary>The pairs that a frame found intersecting: how many, then a and b of each.</summary>
    public void Add(System.ReadOnlySpan<ObjectPair> pairs)
    {
        _hash.Add((uint)pairs.Length);
        foreach (ObjectPair pair in pairs)
        {
            _hash.Add((uint)pair.A);
            _hash.Add((uint)pair.B);
        }
    }
#endif

    /// <summary>16 lowercase hexadecimal digits.</summary>
    public override readonly string ToString() => _hash.ToString();

    private void Add(Vector3 v)
    {
        Add(v.X);
        Add(v.Y);
        Add(v.Z);
    }

    private unsafe void Add(float x) => _hash.Add(x == 0 ? 0 : *(uint*)&x);
}
