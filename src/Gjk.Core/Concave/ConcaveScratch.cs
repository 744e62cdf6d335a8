namespace Gjk.Core;

/// <summary>The memory of queries on <see cref="AnyShape"/>: it grows to what a query needs and is used again, so that
/// later queries allocate nothing. Keep one for each thread; its content says nothing between calls.</summary>
public sealed class ConcaveScratch
{
    internal readonly PartSide A = new(), B = new();
    internal readonly PartHeap Heap = new();
    internal readonly TriangleFilter Filter = new();
    internal readonly PlaneProof Plane = new();
    internal readonly WindingNumber Winding = new();
    internal readonly List<PairDistance> Pairs = [];
    internal readonly List<PairContacts> Pushes = [];
    internal readonly List<FaceContact> FaceContacts = [], Orphans = [];
    internal readonly List<OpenPlane> Planes = [], Ends = [];
    internal readonly List<bool> AreAtJoints = [], AreOpen = [];
    internal readonly List<(float Distance, int Contact)> Shallowest = [];
    internal readonly List<CastHit> Casts = [], Met = [];
    private readonly Stack<ConcaveScratch> _idle = new();
    internal PartPairSearch Search;
    internal PartCastSearch CastSearch;

    /// <summary>How many pairs of parts were searched for what a face meets.</summary>
    internal int Searched;

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
