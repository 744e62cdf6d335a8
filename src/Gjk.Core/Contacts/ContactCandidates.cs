namespace Gjk.Core;

/// <summary>The places of which some become contact points, in order around what is shared, each with a surface of both
/// shapes.</summary>
/// <param name="memory">Room for <see cref="Capacity"/> candidates.</param>
internal unsafe ref struct ContactCandidates(Candidate* memory)
{
    /// <summary>Count: one for each place, and the deepest point.</summary>
    public const int Capacity = ContactPlaces.Capacity + 1;

    /// <summary>The first candidate; the others follow.</summary>
    public readonly Candidate* Pointer = memory;

    /// <summary>How many there are.</summary>
    public int Count { get; private set; } = 0;

    /// <summary>A candidate.</summary>
    public readonly ref Candidate this[int index] => ref Pointer[index];

    /// <summary>The first of those with the least gap.</summary>
    public readonly Candidate Deepest
    {
        get
        {
            int least = 0;
            for (int i = 1; i < Count; i++)
                if (Pointer[i].Gap < Pointer[least].Gap) least = i;
            return Pointer[least];
        }
    }

    /// <summary>Adds one; there is room.</summary>
    public void Add(in Candidate candidate) => Pointer[Count++] = candidate;

    /// <summary>Leaves some, whose numbers rise.</summary>
    public void Keep(int* kept, int count)
    {
        for (int i = 0; i < count; i++) Pointer[i] = Pointer[kept[i]];
        Count = count;
    }

    /// <summary>Leaves the corners of the convex outline, in order around it (Andrew 1979): places that moved to where
    /// a face is flat may have left it.</summary>
    public void KeepOutline()
    {
        Sort(byPlace: true);
        Candidate* outline = stackalloc Candidate[Capacity + 1];
        int count = 0;
        for (int i = 0; i < Count; i++) Append(outline, ref count, 0, Pointer[i]);
        int half = count - 1;
        for (int i = Count - 2; i >= 0; i--) Append(outline, ref count, half, Pointer[i]);
        Count = count - 1;
        for (int i = 0; i < Count; i++) Pointer[i] = outline[i];
    }

    /// <summary>Sorts by the ids, or along U, then V.</summary>
    public readonly void Sort(bool byPlace)
    {
        for (int i = 1; i < Count; i++)
        {
            Candidate moved = Pointer[i];
            int k = i;
            for (; k > 0 && IsBefore(moved, Pointer[k - 1], byPlace); k--) Pointer[k] = Pointer[k - 1];
            Pointer[k] = moved;
        }
    }

    private static bool IsBefore(in Candidate p, in Candidate q, bool byPlace) =>
        !byPlace ? ContactFeature.IsBefore(p.Id, q.Id) : p.U != q.U ? p.U < q.U : p.V < q.V;

    /// <summary>Adds the next corner of half an outline, and takes away those before it that it makes hollow.</summary>
    private static void Append(Candidate* outline, ref int count, int begin, in Candidate next)
    {
        while (count > begin + 1 && !(Candidate.Area(outline[count - 2], outline[count - 1], next) > 0)) count--;
        outline[count++] = next;
    }

    /// <summary>Makes room between two and puts one there.</summary>
    public void Insert(int index, in Candidate candidate)
    {
        for (int i = Count++; i > index; i--) Pointer[i] = Pointer[i - 1];
        Pointer[index] = candidate;
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
