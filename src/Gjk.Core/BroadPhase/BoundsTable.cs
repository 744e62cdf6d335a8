namespace Gjk.Core;

/// <summary>The boxes of a broad phase by object number, with the checks that all of them share.</summary>
internal sealed class BoundsTable
{
    /// <summary>Count: numbers are below it. The largest array that grows with the numbers, the nodes of a tree, has 1
    /// GB then, and the ends of an axis leave a bit free.</summary>
    public const int IdLimit = 1 << 24;

    private const int FirstCapacity = 16;

    /// <summary>Count: the longest array of the runtime, for items of more than a byte.</summary>
    private const int MostItems = 0x7FFFFFC7;

    /// <summary>The boxes; meaningless where <see cref="Present"/> is false.</summary>
    public Aabb[] Boxes = [];

    /// <summary>Which numbers are in use.</summary>
    public bool[] Present = [];

    /// <summary>How many numbers are in use.</summary>
    public int Count;

    /// <summary>One more than the largest number ever in use since the last clear.</summary>
    public int End;

    /// <summary>Refuses a number that cannot be added, and makes room for one that can; nothing changes if there is no
    /// memory for it.</summary>
    public void Reserve(int id)
    {
        if (id < 0) throw new ArgumentOutOfRangeException(nameof(id), id, "Must not be negative.");
        if (id >= IdLimit) throw new ArgumentOutOfRangeException(nameof(id), id, "Must be below 16,777,216.");
        if (IsPresent(id))
            throw new ArgumentException(FormattableString.Invariant($"There is an object {id} already."), nameof(id));
        if (id < Boxes.Length) return;
        int capacity = Math.Min(Grown(Boxes.Length, id), IdLimit);
        Array.Resize(ref Present, capacity);
        Array.Resize(ref Boxes, capacity);
    }

    public void Add(int id, in Aabb bounds)
    {
        Reserve(id);
        Boxes[id] = bounds;
        Present[id] = true;
        Count++;
        End = Math.Max(End, id + 1);
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

    public static void CheckQuery(float margin, List<ObjectPair> pairs)
    {
        Guard.NonNegativeOrInfinite(margin, nameof(margin));
        Guard.NotNull(pairs, nameof(pairs)).Clear();
    }

    /// <summary>Whether two boxes overlap when one of them is widened. The sum is rounded to float at once, as the
    /// sorted phases need it: rounding is monotone, so the order of the rounded ends is all that counts, in every phase
    /// alike.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Near(in Aabb a, in Aabb b, float margin) =>
        a.Min.X <= (float)(b.Max.X + margin) && b.Min.X <= (float)(a.Max.X + margin) &&
        a.Min.Y <= (float)(b.Max.Y + margin) && b.Min.Y <= (float)(a.Max.Y + margin) &&
        a.Min.Z <= (float)(b.Max.Z + margin) && b.Min.Z <= (float)(a.Max.Z + margin);

    /// <summary>At least twice the length as long as an array can be that long, and room for the index.</summary>
    public static int Grown(int length, int index) =>
        Math.Max((int)Math.Min(Math.Max(2L * length, FirstCapacity), MostItems), checked(index + 1));

    /// <summary>Refuses a number that is not in use.</summary>
    public void Check(int id)
    {
        if (!IsPresent(id)) throw new ArgumentOutOfRangeException(nameof(id), id, "There is no such object.");
    }
}
