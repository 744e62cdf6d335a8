namespace Gjk.Core;

/// <summary>An axis-aligned box, both ends included. Immutable.</summary>
public readonly struct Aabb : IEquatable<Aabb>
{
    /// <summary>The least coordinates.</summary>
    public readonly Vector3 Min;

    /// <summary>The greatest coordinates.</summary>
    public readonly Vector3 Max;

    /// <summary>Makes a box.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is NaN or infinite, or a maximum lies below its
    /// minimum.</exception>
    public Aabb(Vector3 min, Vector3 max)
    {
        Min = Guard.Finite(min, nameof(min));
        Max = Guard.Finite(max, nameof(max));
        if (max.X < min.X || max.Y < min.Y || max.Z < min.Z)
            throw new ArgumentOutOfRangeException(nameof(max), max, "No maximum may lie below its minimum.");
    }

    /// <summary>Finite corners, which nobody checks.</summary>
    internal Aabb(float minX, float minY, float minZ, float maxX, float maxY, float maxZ)
    {
        (Min.X, Min.Y, Min.Z) = (minX, minY, minZ);
        (Max.X, Max.Y, Max.Z) = (maxX, maxY, maxZ);
    }

    /// <summary>The box around finite points, at least one.</summary>
    internal static Aabb Around(Vector3[] points)
    {
        Vector3 min = points[0], max = min;
        foreach (Vector3 point in points)
        {
            min = Vector3.Min(min, point);
            max = Vector3.Max(max, point);
        }

        return new Aabb(min.X, min.Y, min.Z, max.X, max.Y, max.Z);
    }

    /// <summary>The longest side, in double because the difference of two floats need not be a float.</summary>
    public double LongestSide =>
        Math.Max(Math.Max((double)Max.X - Min.X, (double)Max.Y - Min.Y), (double)Max.Z - Min.Z);

    /// <summary>True when the boxes share a point, touching included.</summary>
    public bool Overlaps(in Aabb other) =>
        Min.X <= other.Max.X && other.Min.X <= Max.X &&
        Min.Y <= other.Max.Y && other.Min.Y <= Max.Y &&
        Min.Z <= other.Max.Z && other.Min.Z <= Max.Z;

    /// <inheritdoc/>
    public bool Equals(Aabb other) => Min.Equals(other.Min) && Max.Equals(other.Max);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Aabb other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Min.GetHashCode() * 397 ^ Max.GetHashCode();

    /// <summary>Both corners, for people to read.</summary>
    public override string ToString() => $"{((Double3)Min).ToText()} to {((Double3)Max).ToText()}";

    /// <summary>Equality of both corners.</summary>
    public static bool operator ==(in Aabb a, in Aabb b) => a.Equals(b);

    /// <summary>The opposite of equality.</summary>
    public static bool operator !=(in Aabb a, in Aabb b) => !a.Equals(b);
}
