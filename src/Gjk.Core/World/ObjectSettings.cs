namespace Gjk.Core;

/// <summary>How a <see cref="CollisionScene"/> treats an object beside its shape and pose. Immutable; <c>default</c> is
/// an object that is tested against all others.</summary>
/// <remarks>Two objects are tested against each other when not both are static, and each is in a group that the other's
/// mask admits: the rule of most physics engines, so that their filters can be used as they are. The finders of the
/// scene honour it; a question that names both objects is answered in any case.</remarks>
public readonly struct ObjectSettings : IEquatable<ObjectSettings>
{
    /// <summary>The group of objects that were given none.</summary>
    public const uint DefaultGroup = 1;

    // Stored so that a default struct has the default values.
    private readonly uint _groupFromDefault, _maskFromAll;

    /// <summary>Makes settings.</summary>
    /// <param name="isStatic">Whether the object is one of those that are never tested against each other, such as
    /// walls and floors. It can be moved all the same.</param>
    /// <param name="groups">The groups that it is in, one bit each.</param>
    /// <param name="mask">The groups that it is tested against, one bit each.</param>
    /// <param name="tag">A number of your own, which the scene keeps for you.</param>
    public ObjectSettings(bool isStatic = false, uint groups = DefaultGroup, uint mask = uint.MaxValue, long tag = 0)
    {
        (_groupFromDefault, _maskFromAll) = (groups ^ DefaultGroup, ~mask);
        (IsStatic, Tag) = (isStatic, tag);
    }

    /// <summary>Whether the object is never tested against another static one.</summary>
    public bool IsStatic { get; }

    /// <summary>The groups that it is in, one bit each.</summary>
    public uint Groups => _groupFromDefault ^ DefaultGroup;

    /// <summary>The groups that it is tested against, one bit each.</summary>
    public uint Mask => ~_maskFromAll;

    /// <summary>A number of your own.</summary>
    public long Tag { get; }

    /// <summary>Whether it is tested against all others of which this is true: those of the default group.</summary>
    internal bool AreUsual => (Groups & Mask & DefaultGroup) != 0 && !IsStatic;

    /// <summary>Whether objects with these settings are tested against each other; the order does not matter.</summary>
    public static bool AreTested(in ObjectSettings a, in ObjectSettings b) =>
        (a.Groups & b.Mask) != 0 && (b.Groups & a.Mask) != 0 && !(a.IsStatic && b.IsStatic);

    /// <summary>Whether all settings are the same.</summary>
    public static bool operator ==(in ObjectSettings a, in ObjectSettings b) => a.Equals(b);

    /// <summary>Whether some settings differ.</summary>
    public static bool operator !=(in ObjectSettings a, in ObjectSettings b) => !a.Equals(b);

    /// <inheritdoc/>
    public bool Equals(ObjectSettings other) =>
        IsStatic == other.IsStatic && Groups == other.Groups && Mask == other.Mask && Tag == other.Tag;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is ObjectSettings other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() =>
        ((Groups.GetHashCode() * 397 ^ Mask.GetHashCode()) * 397 ^ Tag.GetHashCode()) * 2 + (IsStatic ? 1 : 0);
}
