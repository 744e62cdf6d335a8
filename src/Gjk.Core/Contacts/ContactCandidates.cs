namespace Gjk.Core;

/// <summary>The places of which some become contact points, in order around what is shared, each with a surface of both
/// shapes.</summary>
internal unsafe ref struct ContactCandidates
{
    /// <summary>Count: one for each place, and the deepest point.</summary>
    public const int Capacity = ContactPlaces.Capacity + 1;

    private readonly Candidate* _candidates;

    /// <param name="memory">Room for <see cref="Capacity"/> candidates.</param>
    public ContactCandidates(Candidate* memory)
    {
        _candidates = memory;
        Count = 0;
    }

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>The first candidate; the others follow.</summary>
    public readonly Candidate* Pointer => _candidates;

    /// <summary>A candidate.</summary>
    public readonly ref Candidate this[int index] => ref _candidates[index];

    /// <summary>The first of those with the least gap.</summary>
    public readonly Candidate Deepest
    {
        get
        {
            int least = 0;
            for (int i = 1; i < Count; i++)
                if (_candidates[i].Gap < _candidates[least].Gap) least = i;
            return _candidates[least];
        }
    }

    /// <summary>Adds one; there is room.</summary>
    public void Add(in Candidate candidate) => _candidates[Count++] = candidate;

    /// <summary>Leaves some, whose numbers rise.</summary>
    public void Keep(int* kept, int count)
    {
        for (int i = 0; i < count; i++) _candidates[i] = _candidates[kept[i]];
        Count = count;
    }

    /// <summary>Leaves the corners of the convex outline, in order around it (Andrew 1979): places that moved to where
    /// a face is flat may have left it.</summary>
    public void KeepOutline()
    {
        for (int i = 1; i < Count; i++)
        {
            Candidate moved = _candidates[i];
            int k = i;
            for (; k > 0 && IsLeftOf(moved, _candidates[k - 1]); k--) _candidates[k] = _candidates[k - 1];
            _candidates[k] = moved;
        }

        Candidate* outline = stackalloc Candidate[Capacity + 1];
        int count = 0;
        for (int i = 0; i < Count; i++) Append(outline, ref count, 0, _candidates[i]);
        int half = count - 1;
        for (int i = Count - 2; i >= 0; i--) Append(outline, ref count, half, _candidates[i]);
        Count = count - 1;
        for (int i = 0; i < Count; i++) _candidates[i] = outline[i];
    }

    private static bool IsLeftOf(in Candidate p, in Candidate q) => p.U != q.U ? p.U < q.U : p.V < q.V;

    /// <summary>Adds the next corner of half an outline, and takes away those before it that it makes hollow.</summary>
    private static void Append(Candidate* outline, ref int count, int begin, in Candidate next)
    {
        while (count > begin + 1 && !(Candidate.Area(outline[count - 2], outline[count - 1], next) > 0)) count--;
        outline[count++] = next;
    }

    /// <summary>Makes room between two and puts one there.</summary>
    public void Insert(int index, in Candidate candidate)
    {
        for (int i = Count++; i > index; i--) _candidates[i] = _candidates[i - 1];
        _candidates[index] = candidate;
    }
}

/// <summary>A place where both shapes have a surface.</summary>
internal readonly struct Candidate(double u, double v, double heightA, double heightB, long id)
{
    /// <summary>In the plane across the normal, from the deepest point.</summary>
    public readonly double U = u, V = v;

    /// <summary>How far each shape reaches towards the other, margin included.</summary>
    public readonly double HeightA = heightA, HeightB = heightB;

    /// <summary>The point's name.</summary>
    public readonly long Id = id;

    /// <summary>How far apart the shapes are here.</summary>
    public double Gap => -(HeightA + HeightB);

    /// <summary>The same point by another name.</summary>
    public Candidate Named(long id) => new(U, V, HeightA, HeightB, id);

    /// <summary>The squared distance of another.</summary>
    public double SquaredTo(in Candidate other) => (U - other.U) * (U - other.U) + (V - other.V) * (V - other.V);

    /// <summary>Twice the area of a triangle, positive where it runs counter-clockwise.</summary>
    public static double Area(in Candidate p, in Candidate q, in Candidate r) =>
        (q.U - p.U) * (r.V - p.V) - (q.V - p.V) * (r.U - p.U);
}
