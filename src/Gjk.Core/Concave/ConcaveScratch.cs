namespace Gjk.Core;

/// <summary>The memory of queries on <see cref="AnyShape"/>: it grows to what a query needs and is used again, so that
/// later queries allocate nothing. Keep one for each thread; its content says nothing between calls.</summary>
public sealed class ConcaveScratch
{
    internal PartSide A = new();
    internal readonly PartSide B = new();
    internal readonly PartHeap Heap = new();
    internal readonly TriangleFilter Filter = new();
    internal readonly PlaneProof Plane = new();
    internal readonly WindingNumber Winding = new();
    internal readonly List<PairDistance> Pairs = [], Near = [];
    internal readonly List<PairContacts> Pushes = [], Joined = [];
    internal readonly List<FaceContact> FaceContacts = [], Orphans = [];
    internal readonly List<OpenPlane> Planes = [], Ends = [];
    internal readonly List<bool> AreAtJoints = [], AreOpen = [];
    internal readonly List<(float Distance, int Contact)> Shallowest = [];
    internal readonly List<CastHit> Casts = [], Met = [];
    private readonly Stack<ConcaveScratch> _idle = new();
    internal PartPairSearch Search;
    internal PartCastSearch CastSearch;

    /// <summary>The static objects of a scene that count as one body and are A in turn; room for more after
    /// them.</summary>
    internal readonly List<PartSide> Grounds = [];

    /// <summary>How many there are; 0 where A is one shape.</summary>
    internal int GroundCount;

    /// <summary>Whether any of the pairs overlaps or touches.</summary>
    internal bool AreAnyTouching;

    /// <summary>How many pairs of parts were searched for what a face meets.</summary>
    internal int Searched;

    /// <summary>Makes A the static object that a pair is of.</summary>
    internal void Select(ObjectPair pair)
    {
        if (GroundCount > 0) A = Grounds[pair.A];
    }

    /// <summary>One of the two bodies: B, or the static object with a number among those that are A.</summary>
    internal PartSide SideOf(int ground, bool isA) => !isA ? B : GroundCount > 0 ? Grounds[ground] : A;

    /// <summary>Which of all pairs are of a static object.</summary>
    internal (int Begin, int End) PairsOf(int ground) => GroundCount == 0
        ? (0, Pairs.Count)
        : (ground == 0 ? 0 : Grounds[ground - 1].PairsEnd, Grounds[ground].PairsEnd);

    /// <summary>Another scratch for a thread of its own; this one keeps it.</summary>
    internal ConcaveScratch Rent()
    {
        lock (_idle) return _idle.Count > 0 ? _idle.Pop() : new ConcaveScratch();
    }

    /// <summary>Takes one back.</summary>
    internal void Return(ConcaveScratch scratch)
    {
        lock (_idle) _idle.Push(scratch);
    }
}
