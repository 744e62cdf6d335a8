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
    internal readonly PairsAtPoint AtPoint = new();
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

    /// <summary>The static objects of a scene that count as one body, each of which is A in turn. Unused ones follow
    /// them.</summary>
    internal readonly List<PartSide> Grounds = [];

    /// <summary>How many of them are in use; 0 where A is one shape.</summary>
    internal int GroundCount;

    /// <summary>Whether any of the pairs overlaps or touches.</summary>
    internal bool AreAnyTouching;

    /// <summary>Whether a piece of A or B is inside the other; valid where no parts touch.</summary>
    internal bool IsOneInside => A.IsOneInside ??= Containment.TryFind(this, out _);

    /// <summary>How many pairs of parts went through the search of faces.</summary>
    internal int Searched;

    /// <summary>Makes A the static object of a pair.</summary>
    internal void SelectGround(ObjectPair pair)
    {
        if (GroundCount > 0) A = Grounds[pair.A];
    }

    /// <summary>One of the two bodies: B, or A's static object with a number.</summary>
    internal PartSide SideOf(int ground, bool isA) => !isA ? B : GroundCount > 0 ? Grounds[ground] : A;

    /// <summary>The range of a static object's pairs among all pairs.</summary>
    internal (int Begin, int End) PairsOf(int ground) => GroundCount == 0
        ? (0, Pairs.Count)
        : (ground == 0 ? 0 : Grounds[ground - 1].PairsEnd, Grounds[ground].PairsEnd);

    /// <summary>Another scratch, for one thread or one nested query. Give it back by <see cref="Return"/>.</summary>
    internal ConcaveScratch Rent()
    {
        lock (_idle) return _idle.Count > 0 ? _idle.Pop() : new ConcaveScratch();
    }

    /// <summary>Takes a scratch back.</summary>
    internal void Return(ConcaveScratch scratch)
    {
        lock (_idle) _idle.Push(scratch);
    }
}
