namespace Gjk.Core;

/// <remarks>The normals and heights of faces.</remarks>
internal unsafe partial struct Polytope
{
    /// <summary>The key of a slot that holds no face.</summary>
    private const double Gone = double.MaxValue;

    /// <summary>The last bits of a key: the face's slot.</summary>
    private const long SlotBits = 511;

    /// <summary>The face of least height; the first of those that are equally high.</summary>
    /// <param name="key">Its key.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int Lowest(out double key)
    {
#if NET
        if (Avx2.IsSupported)
        {
            key = LeastKeyInLanes();
            return SlotOf(key);
        }
#endif
        key = _keys[0];
        for (int i = 1; i < _faceCount; i++)
            if (_keys[i] < key) key = _keys[i];
        return SlotOf(key);
    }

    /// <summary>The sort key of a face: h |h| of its height h, from its offset d and its normal n as d |d| / n², so
    /// that no root is taken. The slot takes the place of the last nine bits. Heights that differ by less than one part
    /// in 2^43 may change places; that is below float's rounding, which a depth ends with.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double KeyOf(double square, int slot) =>
        BitConverter.Int64BitsToDouble((BitConverter.DoubleToInt64Bits(square) & ~SlotBits) | (long)slot);

    private static int SlotOf(double key) => (int)(BitConverter.DoubleToInt64Bits(key) & SlotBits);

    /// <summary>Gives new faces their normals and keys; their vertices and twins are known.</summary>
    /// <param name="first">The first one's slot, a multiple of four.</param>
    /// <param name="count">How many; the slots behind them up to a multiple of four hold no face.</param>
    /// <param name="lowest">As for <see cref="TryExpand"/>.</param>
    /// <returns>False when a face of the first four has no area, and so no normal.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly bool TrySetFaces(int first, int count, double lowest)
    {
        int end = first + count;
        bool have = true;
#if NET
        if (Avx2.IsSupported && _cutCount == 0)
        {
            for (int i = first; i < end; i += 4) have &= TrySetLanes(i, end, lowest);
            return have;
        }
#endif
        for (int i = first; i < end; i++) have &= TrySetFace(i, lowest);
        for (int i = end; (i & 3) != 0; i++) _keys[i] = Gone;
        return have;
    }

    private readonly bool TrySetFace(int index, double lowest)
    {
        PolytopeFace* face = _faces + index;
        if (_cutCount > 0 && IsOpen(face))
        {
            SetOpenFace(index);
            return true;
        }

        ref readonly Double3 p = ref _vertices[face->Vertices[0]].W, q = ref _vertices[face->Vertices[1]].W;
        ref readonly Double3 r = ref _vertices[face->Vertices[2]].W;
        Double3.Normal(p, q, r, out face->Normal);
        double least = Offsets(face->Normal, p, q, r, out double most), length = SetNormal(index, least);
        return (most - least <= length * _level && _keys[index] >= lowest) || TryRepair(index, lowest);
    }

    /// <summary>Mends a face whose normal rounding has turned. Where its corners are not level, as a needle's, the
    /// normal is computed in 106 bits; where even that is none, it is that of the neighbour. And no new face is nearer
    /// the origin than the one that was taken away, since with the vertex it lies on one side of a plane: where its
    /// height is less, as between vertices that nearly coincide, the normal is turned to its point that is nearest the
    /// origin, along which its height is the most.</summary>
    /// <returns>False when the face is one of the first four, and has no normal.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly bool TryRepair(int index, double lowest)
    {
        PolytopeFace* face = _faces + index;
        Double3 p = _vertices[face->Vertices[0]].W, q = _vertices[face->Vertices[1]].W;
        Double3 r = _vertices[face->Vertices[2]].W, normal = face->Normal;
        double least = Offsets(normal, p, q, r, out double most);
        if (!(most - least <= normal.SumOfMagnitudes * _level && face->NormalSquared > 0))
        {
            Double3 cross = VectorDD.Normal(p, q, r);
            double length = cross.Length;
            if (!(length > 0) && index < 4) return false;
            normal = length > 0 ? cross * (1 / length) : _faces[face->Twins[0] >> 2].UnitNormal;
            SetNormal(index, normal, Offsets(normal, p, q, r, out _));
        }

        if (_keys[index] >= lowest) return true;
        Double3 nearest = ClosestPointWeights.Triangle(p, q, r).PointOf(p, q, r, default);
        normal = nearest * (1 / nearest.Length);
        least = Offsets(normal, p, q, r, out _);
        if (least * Math.Abs(least) > _keys[index]) SetNormal(index, normal, least);
        return true;
    }

    private readonly void SetNormal(int index, in Double3 normal, double least)
    {
        _faces[index].Normal = normal;
        SetNormal(index, least);
    }

    /// <summary>Sets the limit, the offset and the key that follow from a face's normal. Returns the sum of the
    /// normal's magnitudes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly double SetNormal(int index, double least)
    {
        PolytopeFace* face = _faces + index;
        double length = face->Normal.SumOfMagnitudes, squared = face->Normal.LengthSquared;
        face->Limit = least + length * _noise;
        face->Offset = least;
        face->NormalSquared = squared;
        _keys[index] = KeyOf(least * Math.Abs(least) / squared, index);
        return length;
    }

    /// <summary>Least and most of three points' products with a normal.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Offsets(in Double3 normal, in Double3 p, in Double3 q, in Double3 r, out double most)
    {
        double a = Double3.Dot(normal, p), b = Double3.Dot(normal, q), c = Double3.Dot(normal, r);
        double larger = a > b ? a : b, smaller = a < b ? a : b;
        most = larger > c ? larger : c;
        return smaller < c ? smaller : c;
    }
}
