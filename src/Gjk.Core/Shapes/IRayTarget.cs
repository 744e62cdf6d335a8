namespace Gjk.Core;

/// <summary>A shape of the library that may be one of the bodies that a ray meets in closed form.</summary>
internal interface IRayTarget
{
    /// <summary>What a ray sees of it.</summary>
    /// <returns>False where it is no such body.</returns>
    bool TryGetTarget(out RayTarget target);
}
