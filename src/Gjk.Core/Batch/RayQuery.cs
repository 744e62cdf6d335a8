namespace Gjk.Core;

/// <summary>What a ray cast asks: from where, in which direction, and how far. Immutable; a <c>default</c> one has no
/// direction and is refused.</summary>
public readonly struct RayQuery
{
    /// <summary>Where the ray begins, in the world.</summary>
    public readonly Vector3 Origin;

    /// <summary>Its direction; the length does not matter.</summary>
    public readonly Vector3 Direction;

    /// <summary>World units: how far it reaches; +infinity for all the way, and 0 to ask whether the origin is inside a
    /// shape.</summary>
    public readonly float MaxDistance;

    /// <summary>Makes a ray.</summary>
    /// <param name="origin">Any finite point.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="maxDistance">World units, at least 0; +infinity for all the way.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is NaN or infinite, the direction is zero, or the
    /// distance is negative or NaN.</exception>
    public RayQuery(Vector3 origin, Vector3 direction, float maxDistance = float.PositiveInfinity)
    {
        Origin = Guard.Finite(origin, nameof(origin));
        Direction = Guard.Finite(direction, nameof(direction));
        if (direction == Vector3.Zero)
            throw new ArgumentOutOfRangeException(nameof(direction), direction, "Must not be zero.");
        MaxDistance = Guard.NonNegativeOrInfinite(maxDistance, nameof(maxDistance));
    }

    /// <summary>False for a <c>default</c> one.</summary>
    internal bool IsValid => Direction != Vector3.Zero;

    /// <summary>World units for a fraction of 1.</summary>
    internal double Length => ((Double3)Direction).Length;

    /// <summary>Origin, direction and reach, for people to read.</summary>
    public override string ToString()
    {
        string origin = ((Double3)Origin).ToText(), direction = ((Double3)Direction).ToText();
        return FormattableString.Invariant($"From {origin} along {direction} up to {MaxDistance:G9}");
    }

    /// <summary>The ray for a broad phase.</summary>
    internal SweptBox Path() => new(Origin, Origin, Direction, MaxDistance / Length);

    /// <summary>Refuses a list with a <c>default</c> ray in it, or with fewer results than rays.</summary>
    internal static void Check(RayQuery[] rays, Array results)
    {
        Guard.NotNull(rays, nameof(rays));
        if (Guard.NotNull(results, nameof(results)).Length < rays.Length)
            throw new ArgumentException("There must be at least as many results as rays.", nameof(results));
        for (int i = 0; i < rays.Length; i++)
        {
            if (rays[i].IsValid) continue;
            throw new ArgumentException(
                FormattableString.Invariant($"Ray {i} is a default RayQuery, which has no direction."), nameof(rays));
        }
    }
}
