namespace Gjk.Bench.Table;

/// <summary>The query that a row of the table measures.</summary>
internal enum Query
{
    /// <summary>Distance with closest points. Nothing is kept between the calls.</summary>
    Cold,

    /// <summary>Distance with a warm start per pair. Nothing moves.</summary>
    Warm,

    /// <summary>The same, but every object turns by one degree and moves by a hundredth of its size between the
    /// calls.</summary>
    Moving,

    /// <summary>Whether the shapes overlap. Nothing is kept between the calls.</summary>
    Boolean,

    /// <summary>As <see cref="Cold"/>, the whole list in one call of <see cref="Core.PairBatch"/>, on one
    /// thread.</summary>
    BatchCold,

    /// <summary>As <see cref="Warm"/>, the whole list in one call.</summary>
    BatchWarm,

    /// <summary>As <see cref="Boolean"/>, the whole list in one call.</summary>
    BatchBoolean,

    /// <summary>The signed distance of overlapping pairs. Nothing is kept between the calls.</summary>
    Depth,

    /// <summary>The same with a warm start per pair. One object of every pair moves by a hundredth of its size between
    /// the calls.</summary>
    DepthMoving,

    /// <summary>What the contact points of overlapping pairs take on top of <see cref="Depth"/>. Nothing is kept
    /// between the calls.</summary>
    ContactsOnTop,

    /// <summary>The first touch of pairs of which one object moves. Nothing is kept between the calls.</summary>
    Cast,
}
