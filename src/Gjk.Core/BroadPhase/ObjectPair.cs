namespace Gjk.Core;

/// <summary>Two objects by their numbers: ids of a scene, or indices into the arrays of a batch. Immutable. Ordered by
/// <see cref="A"/>, then <see cref="B"/>.</summary>
public readonly struct ObjectPair : IEquatable<ObjectPair>, IComparable<ObjectPair>
{
    /// <summary>The first object; the lesser number in every pair that the library makes.</summary>
    public readonly int A;

    /// <summary>The second object.</summary>
    public readonly int B;

    /// <summary>Makes a pair, in the order given.</summary>
    public ObjectPair(int a, int b)
    {
        A = a;
        B = b;
    }

    /// <summary>No object of a scene.</summary>
    internal static ObjectPair None => new(-1, -1);

    /// <inheritdoc/>
    public int CompareTo(ObjectPair other) => A != other.A ? A.CompareTo(other.A) : B.CompareTo(other.B);

    /// <inheritdoc/>
    public bool Equals(ObjectPair other) => A == other.A && B == other.B;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is ObjectPair other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => A * 397 ^ B;

    /// <summary>The two numbers in parentheses.</summary>
    public override string ToString() => FormattableString.Invariant($"({A}, {B})");

    /// <summary>Equality of both numbers, in order.</summary>
    public static bool operator ==(ObjectPair a, ObjectPair b) => a.Equals(b);

    /// <summary>The opposite of equality.</summary>
    public static bool operator !=(ObjectPair a, ObjectPair b) => !a.Equals(b);
}
