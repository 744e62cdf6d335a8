namespace Gjk.Core;

/// <summary>What a pair remembers from one query to the next. Keep one per pair and pass it by reference;
/// <c>default</c> is a cold start. What it holds only suggests where to begin: stale or foreign content costs time,
/// never correctness.</summary>
/// <remarks>Mutable, 48 bytes, no references. It holds the ids of the last simplex's support vertices, which are asked
/// from the shapes anew, and the last normal for shapes without vertices.</remarks>
public struct WarmStart
{
    private short _count;
    private bool _isOfB;
    private int _a0, _a1, _a2, _a3;
    private int _b0, _b1, _b2, _b3;
    private float _x, _y, _z;

    /// <summary>Back to a cold start.</summary>
    public void Clear() => this = default;

    /// <summary>Squared length: what is stored is a unit vector rounded to float; anything that is longer than this, or
    /// NaN, was not stored by a query. A larger limit would only believe a stray normal, which is a guess like any
    /// other. Pinned by PairFrameTests.AKeptNormalIsTheFirst.</summary>
    internal const double LongestNormal = 2;

    /// <summary>The first search direction: the last normal in A's frame, or the cold query's where there is
    /// none.</summary>
    internal readonly Double3 FirstNormal(in PairFrame frame)
    {
        var normal = new Double3(_x, _y, _z);
        if (_isOfB) normal = -frame.Rotation.Rotate(normal);
        double squared = normal.LengthSquared;
        return squared > 0 && squared <= LongestNormal ? normal : frame.FirstNormal;
    }

    /// <summary>Puts the remembered vertices, as they are now, and the first search direction into a state without
    /// vertices; the direction alone when the shapes no longer have them.</summary>
    internal readonly void Seed<TA, TB>(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        // A stray count is only a wrong guess.
        int count = (uint)_count <= 4u ? _count : 0;
        ref Simplex simplex = ref state.Simplex;
        bool found = count > 0 && MinkowskiDifference.TryMakeVertex(ref a, ref b, frame, _a0, _b0, ref simplex.At(0));
        if (count > 1) found &= MinkowskiDifference.TryMakeVertex(ref a, ref b, frame, _a1, _b1, ref simplex.At(1));
        if (count > 2) found &= MinkowskiDifference.TryMakeVertex(ref a, ref b, frame, _a2, _b2, ref simplex.At(2));
        if (count > 3) found &= MinkowskiDifference.TryMakeVertex(ref a, ref b, frame, _a3, _b3, ref simplex.At(3));
        if (found) simplex.Select(count, 0, 1, 2, 3);
        state.Feature.Normal = FirstNormal(frame);
    }

    /// <summary>Exchanges A and B. The normal stays as it is, and which body's frame it is in is remembered: turned, it
    /// would be rounded.</summary>
    internal void Exchange()
    {
        (_a0, _a1, _a2, _a3, _b0, _b1, _b2, _b3) = (_b0, _b1, _b2, _b3, _a0, _a1, _a2, _a3);
        _isOfB = !_isOfB;
    }

    /// <summary>Remembers where a query ended, unless the shapes contradicted themselves.</summary>
    internal void Save(in SolverState state)
    {
        if (state.Verdict == Verdict.Contradiction) Clear();
        else Store(state.Simplex, state.Feature.Normal);
    }

    /// <summary>Remembers a simplex.</summary>
    internal void Store(in Simplex simplex, in Double3 normal)
    {
        _count = (short)simplex.Count;
        (_a0, _b0) = _count > 0 ? (simplex.IdA(simplex.A), simplex.IdB(simplex.A)) : (-1, -1);
        if (_count > 1) (_a1, _b1) = (simplex.IdA(simplex.B), simplex.IdB(simplex.B));
        if (_count > 2) (_a2, _b2) = (simplex.IdA(simplex.C), simplex.IdB(simplex.C));
        if (_count > 3) (_a3, _b3) = (simplex.IdA(simplex.D), simplex.IdB(simplex.D));

        // Only shapes without vertices need the normal, and a query whose first plane was further than asked.
        if ((_a0 | _b0) < 0) SetNormal(normal);
    }

    /// <summary>Brought to unit length, it is a float for any size of shape.</summary>
    internal void SetNormal(in Double3 normal)
    {
        double scale = 1 / System.Math.Sqrt(normal.LengthSquared);
        (_x, _y, _z) = ((float)(normal.X * scale), (float)(normal.Y * scale), (float)(normal.Z * scale));
        _isOfB = false;
    }

#if NET
    /// <summary>How many vertices there seem to be: a warm start can hold anything.</summary>
    internal readonly int Count => _count;

    /// <summary>The last normal, if there was one, in A's frame.</summary>
    internal readonly Double3 Normal => _isOfB ? default : new(_x, _y, _z);

    /// <summary>The ids of A's support points, and of B's, of the four vertices that there may be.</summary>
    internal readonly Vector128<int> IdsA => Vector128.LoadUnsafe(in _a0);

    /// <inheritdoc cref="IdsA"/>
    internal readonly Vector128<int> IdsB => Vector128.LoadUnsafe(in _b0);

    /// <summary>Remembers so many vertices.</summary>
    internal void Set(int count, Vector128<int> idsA, Vector128<int> idsB)
    {
        _count = (short)count;
        Vector128<int> isNew = Vector128.LessThan(Vector128.Create(0, 1, 2, 3), Vector128.Create(count));
        Vector128.ConditionalSelect(isNew, idsA, IdsA).StoreUnsafe(ref _a0);
        Vector128.ConditionalSelect(isNew, idsB, IdsB).StoreUnsafe(ref _b0);
        if (count == 0) (_a0, _b0) = (-1, -1);
    }
#endif
}
