using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>The boxes of a broad phase by object number, with the checks that all of them share.</summary>
internal sealed class BoundsTable
{
    private const int FirstCapacity = 16;

    /// <summary>The boxes; meaningless where <see cref="Present"/> is false.</summary>
    public Aabb[] Boxes = [];

    /// <summary>Which numbers are in use.</summary>
    public bool[] Present = [];

    /// <summary>How many numbers are in use.</summary>
    public int Count;

    /// <summary>One more than the largest number ever in use since the last clear.</summary>
    public int End;

    public void Add(int id, in Aabb bounds)
    {
        if (id < 0) throw new ArgumentOutOfRangeException(nameof(id), id, "Must not be negative.");
        if (IsPresent(id)) throw new ArgumentException(FormattableString.Invariant($"There is an object {id} already."), nameof(id));
        if (id >= Boxes.Length)
        {
            int capacity = Grown(Boxes.Length, id);
            Array.Resize(ref Boxes, capacity);
            Array.Resize(ref Present, capacity);
        }

        Boxes[id] = bounds;
        Present[id] = true;
        Count++;
        End = Math.Max(End, id + 1);
    }

    public void Move(int id, in Aabb bounds)
    {
        Check(id);
        Boxes[id] = bounds;
    }

    public void Remove(int id)
    {
        Check(id);
        Present[id] = false;
        Count--;
    }

    public void Clear()
    {
        Array.Clear(Present, 0, End);
        Count = End = 0;
    }

    public bool IsPresent(int id) => (uint)id < (uint)Present.Length && Present[id];

    public void CollectInBox(in Aabb box, List<int> ids)
    {
        Guard.NotNull(ids, nameof(ids)).Clear();
        for (int i = 0; i < End; i++)
            if (Present[i] && Boxes[i].Overlaps(box)) ids.Add(i);
    }

    public static void CheckQuery(float margin, List<ObjectPair> pairs)
    {
        if (!(margin >= 0)) throw new ArgumentOutOfRangeException(nameof(margin), margin, "Must not be negative or NaN.");
        Guard.NotNull(pairs, nameof(pairs)).Clear();
    }

    /// <summary>
    /// Whether two boxes overlap when one of them is widened. The sum is rounded to float at once, as the sorted phases need it: rounding is monotone, so the
    /// order of the rounded ends is all that counts, in every phase alike.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Near(in Aabb a, in Aabb b, float margin) =>
        a.Min.X <= (float)(b.Max.X + margin) && b.Min.X <= (float)(a.Max.X + margin) &&
        a.Min.Y <= (float)(b.Max.Y + margin) && b.Min.Y <= (float)(a.Max.Y + margin) &&
        a.Min.Z <= (float)(b.Max.Z + margin) && b.Min.Z <= (float)(a.Max.Z + margin);

    /// <summary>At least twice the length, and room for the index.</summary>
    public static int Grown(int length, int index) => Math.Max(Math.Max(2 * length, FirstCapacity), index + 1);

    private void Check(int id)
    {
        if (!IsPresent(id)) throw new ArgumentOutOfRangeException(nameof(id), id, "There is no such object.");
    }
}
