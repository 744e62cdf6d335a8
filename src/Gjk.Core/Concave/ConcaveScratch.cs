using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// The memory of queries on <see cref="AnyShape"/>: it grows to what a query needs and is used again, so that later
/// queries allocate nothing. Keep one for each thread; its content says nothing between calls.
/// </summary>
public sealed class ConcaveScratch
{
    internal readonly PartSide A = new(), B = new();
    internal readonly PartHeap Heap = new();
    internal readonly TriangleFilter Filter = new();
    internal readonly PlaneProof Plane = new();
    internal readonly WindingNumber Winding = new();
    internal readonly List<PartDistance> Pairs = [];
    internal readonly List<PartContacts> Contacts = [];
    internal PartPairSearch Search;
    internal PartCastSearch CastSearch;
}
