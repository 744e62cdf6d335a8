namespace Gjk.Core;

/// <summary>Finds the pairs of boxes that overlap without a look at every pair. All implementations give the same
/// pairs; they differ in speed only.</summary>
/// <remarks>Mutable and not thread-safe. Objects are known by numbers of the caller's choice, from 0 to 16,777,215;
/// memory grows with the largest one, so keep them dense. A number is free again once it was removed. Nothing is
/// allocated once the internal buffers and the caller's lists have their size. A refused call changes
/// nothing.</remarks>
public interface IBroadPhase
{
    /// <summary>How many objects there are.</summary>
    int Count { get; }

    /// <summary>Adds an object.</summary>
    /// <param name="id">From 0 to 16,777,215, and not in use.</param>
    /// <param name="bounds">A box that holds the object.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is negative, or too large.</exception>
    /// <exception cref="ArgumentException">The number is in use.</exception>
    void Add(int id, in Aabb bounds);

    /// <summary>Replaces an object's box.</summary>
    /// <param name="id">A number in use.</param>
    /// <param name="bounds">A box that holds the object where it is now.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such object.</exception>
    void Move(int id, in Aabb bounds);

    /// <summary>Removes an object.</summary>
    /// <param name="id">A number in use.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such object.</exception>
    void Remove(int id);

    /// <summary>Removes all objects.</summary>
    void Clear();

    /// <summary>All pairs whose boxes overlap, touching included, when one of the two is widened by the margin on every
    /// side.</summary>
    /// <param name="margin">At least 0; may be infinite.</param>
    /// <param name="pairs">Emptied first; then the pairs, A less than B, sorted by (A, B).</param>
    /// <exception cref="ArgumentOutOfRangeException">The margin is negative or NaN.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="InvalidOperationException">There are more than 1,073,741,824 pairs. The list is left empty; the
    /// broad phase is as it was.</exception>
    void CollectPairs(float margin, List<ObjectPair> pairs);

    /// <summary>All objects whose boxes overlap a given one, touching included.</summary>
    /// <param name="box">Where to look.</param>
    /// <param name="ids">Emptied first; then the objects, sorted.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    void CollectInBox(in Aabb box, List<int> ids);

    /// <summary>Shows a visitor the objects whose boxes a ray or a translated box meets, touching included; each once,
    /// in no order that counts. The tree shows near ones first as a rule, and so profits most from a path that is
    /// shortened; the other phases look at all boxes.</summary>
    /// <typeparam name="TVisitor">A struct.</typeparam>
    /// <param name="path">The path.</param>
    /// <param name="visitor">What it throws passes through.</param>
    void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor;
}

/// <summary>Is shown the objects whose boxes a path meets, and says how much of the path is still of interest.
/// Implement it with a struct: it is called without boxing.</summary>
public interface ISweepVisitor
{
    /// <summary>One object. The broad phase must not be changed before the last visit has returned.</summary>
    /// <param name="id">Its number.</param>
    /// <returns>The largest fraction that is of interest from now on: boxes that the path meets only later are left
    /// out. It does not grow again. +infinity to see all boxes; for the first hit, <see cref="SweptBox.After"/>
    /// that.</returns>
    double Visit(int id);
}

/// <summary>How a <see cref="CollisionScene"/> finds the pairs that are worth a query. The results are the same for all
/// of them.</summary>
public enum BroadPhaseKind
{
    /// <summary>Sorted anew along one axis each time: simple and steady, up to some thousands.</summary>
    SortAndSweep = 0,

    /// <summary>A tree of boxes, kept between frames: the one that grows best.</summary>
    DynamicTree,
}
