namespace Gjk.Core;

/// <summary>The questions about two convex shapes: whether they overlap, how far apart or how deep they are, where they
/// touch, when they meet on their way, and what a ray meets.</summary>
/// <remarks>Every method is thread-safe, allocates nothing, never throws (exceptions of a shape of your own pass
/// through) and ends on any input. One pipeline serves all of them: compose the frame, refuse invalid input, solve the
/// cores, finish with the margins.</remarks>
public static partial class ConvexQuery
{
}
