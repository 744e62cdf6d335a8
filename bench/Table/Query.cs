namespace Gjk.Bench.Table;

/// <summary>What a row of the table asks for.</summary>
internal enum Query
{
    /// <summary>Distance with closest points, nothing kept between the calls.</summary>
    Cold,

    /// <summary>Distance with a warm start per pair; nothing moves.</summary>
    Warm,

    /// <summary>The same; every object turns by a degree and moves by a hundredth of its size between the calls.</summary>
    Moving,

    /// <summary>Whether the shapes overlap, nothing kept between the calls.</summary>
    Boolean,
}
