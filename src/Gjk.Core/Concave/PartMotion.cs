namespace Gjk.Core;

/// <summary>What a search for the first contact asks two parts.</summary>
internal enum PartMotion : byte
{
    /// <summary>Both move along lines.</summary>
    Cast,

    /// <summary>Both move along lines and turn.</summary>
    Impact,

    /// <summary>B is a point that moves: a ray.</summary>
    Ray,
}
