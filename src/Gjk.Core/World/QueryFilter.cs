namespace Gjk.Core;

/// <summary>Which objects of a <see cref="CollisionScene"/> a question sees whose shape or ray is not in the scene.
/// Immutable; <c>default</c> sees all.</summary>
/// <remarks>The rule is that of <see cref="ObjectSettings"/>: the question is in groups that an object's mask admits,
/// and the object is in a group that the question's mask admits. Here, all bits set means that the half of the rule
/// does not apply; so objects in no group, and objects whose masks are empty, are seen too unless something is
/// said.</remarks>
public readonly struct QueryFilter : IEquatable<QueryFilter>
{
    // Stored so that a default struct has the default values.
    private readonly uint _groupsFromAll, _maskFromAll;
    private readonly int _notIgnoredId;
    private readonly bool _skipsStatic, _skipsMoving;
    private readonly Predicate<int>? _sees;

    /// <summary>Makes a filter.</summary>
    /// <param name="groups">The groups that the question is in, one bit each; all bits: masks are not looked
    /// at.</param>
    /// <param name="mask">The groups that it sees, one bit each; all bits: groups are not looked at.</param>
    /// <param name="seesStatic">Whether it sees static objects.</param>
    /// <param name="seesMoving">Whether it sees the others.</param>
    /// <param name="ignoredId">An object that it does not see, such as the one that asks; -1 for none.</param>
    /// <param name="sees">Says of an object, by its id, whether it is seen, if nothing else says that it is not; null:
    /// it is. It may be called from several threads, in any order, and must not use the scene. What it throws passes
    /// through.</param>
    public QueryFilter(
        uint groups = uint.MaxValue, uint mask = uint.MaxValue, bool seesStatic = true, bool seesMoving = true,
        int ignoredId = -1, Predicate<int>? sees = null)
    {
        (_groupsFromAll, _maskFromAll, _notIgnoredId) = (~groups, ~mask, ~ignoredId);
        (_skipsStatic, _skipsMoving, _sees) = (!seesStatic, !seesMoving, sees);
    }

    /// <summary>The groups that the question is in, one bit each.</summary>
    public uint Groups => ~_groupsFromAll;

    /// <summary>The groups that it sees, one bit each.</summary>
    public uint Mask => ~_maskFromAll;

    /// <summary>Whether it sees static objects.</summary>
    public bool SeesStatic => !_skipsStatic;

    /// <summary>Whether it sees objects that are not static.</summary>
    public bool SeesMoving => !_skipsMoving;

    /// <summary>The object that it does not see, or -1.</summary>
    public int IgnoredId => ~_notIgnoredId;

    /// <summary>Whether it sees an object with these settings.</summary>
    /// <param name="id">The object.</param>
    /// <param name="settings">How the scene treats it.</param>
    public bool Sees(int id, in ObjectSettings settings) =>
        id != IgnoredId
        && !(settings.IsStatic ? _skipsStatic : _skipsMoving)
        && (_groupsFromAll == 0 || (Groups & settings.Mask) != 0)
        && (_maskFromAll == 0 || (Mask & settings.Groups) != 0)
        && (_sees is null || _sees(id));

    /// <summary>Whether all parts are the same.</summary>
    public static bool operator ==(in QueryFilter a, in QueryFilter b) => a.Equals(b);

    /// <summary>Whether some parts differ.</summary>
    public static bool operator !=(in QueryFilter a, in QueryFilter b) => !a.Equals(b);

    /// <inheritdoc/>
    public bool Equals(QueryFilter other) =>
        _groupsFromAll == other._groupsFromAll && _maskFromAll == other._maskFromAll
        && _notIgnoredId == other._notIgnoredId && _skipsStatic == other._skipsStatic
        && _skipsMoving == other._skipsMoving && _sees == other._sees;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is QueryFilter other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode()
    {
        int groups = _groupsFromAll.GetHashCode() * 397 ^ _maskFromAll.GetHashCode();
        return ((groups * 397 ^ _notIgnoredId) * 2 + (_skipsStatic ? 1 : 0)) * 2 + (_skipsMoving ? 1 : 0);
    }
}
