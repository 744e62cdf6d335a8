namespace Gjk.Core;

/// <summary>The verbs: do two convex shapes overlap, how far apart are they, where are the closest points.</summary>
/// <remarks>Every method is thread-safe, allocates nothing, never throws (exceptions of a shape of your own pass
/// through) and ends on any input. One pipeline serves all of them: compose the frame, refuse invalid input, solve the
/// cores, finish with the margins.</remarks>
public static partial class ConvexQuery
{
}
