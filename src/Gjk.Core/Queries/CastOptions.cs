namespace Gjk.Core;

/// <summary>Which contacts end a cast, a ray or a time of impact. Immutable; <c>default</c>: every contact
/// does.</summary>
public readonly struct CastOptions : IEquatable<CastOptions>
{
    private CastOptions(float allowedDepth)
    {
        AllowedDepth = allowedDepth;
        PassesShallow = true;
    }

    /// <summary>Whether contacts are passed in which the shapes get no deeper than is allowed.</summary>
    public bool PassesShallow { get; }

    /// <summary>World units: how deep they may get; at least 0.</summary>
    public float AllowedDepth { get; }

    /// <summary>A contact counts only if the motion, up to the largest fraction, takes the shapes deeper into each
    /// other than is allowed, and deeper than they are at the start. So what overlaps at the start may slide and leave,
    /// and a body that slides over the seam of two flush tiles is not stopped. Of meshes, compounds and scenes a
    /// contact of a part counts only if it does so from where the body is out of their union, too: what is inside the
    /// union at the start may slide along it, but gets no deeper, however short its steps are; on rough ground, whose
    /// way out may be another one where the motion ends, a step may end deeper, and the next is stopped. Where the
    /// union is met, and no part says so as early, the contact is the one with the union from there. The fraction of
    /// any other contact that counts is still the one at which the shapes first share a point. Where a cast along flush
    /// parts gets too deep in one of them, the contact is the first with their surface, not that with the seam.
    /// </summary>
    /// <param name="allowedDepth">World units, at least 0. What positions in float are off by, some 1e-6 of the sizes
    /// and coordinates, is too little to see and enough for seams. A millionth of the way after the contact is allowed
    /// on top of it where a face is met: what rounding does to a motion along a surface.</param>
    /// <exception cref="ArgumentOutOfRangeException">The depth is negative, NaN or infinite.</exception>
    public static CastOptions OnlyDeeper(float allowedDepth = 0) =>
        new(Guard.NonNegative(allowedDepth, nameof(allowedDepth)));

    /// <summary>Whether a cast that ends so has no contact to measure, nor one to pass.</summary>
    internal bool Settles(CastStatus status) =>
        status != CastStatus.OverlappingAtStart && !(PassesShallow && status == CastStatus.Hit);

    /// <summary>Whether both pass the same contacts.</summary>
    public static bool operator ==(CastOptions a, CastOptions b) => a.Equals(b);

    /// <summary>Whether one passes contacts that the other does not.</summary>
    public static bool operator !=(CastOptions a, CastOptions b) => !a.Equals(b);

    /// <inheritdoc/>
    public bool Equals(CastOptions other) => PassesShallow == other.PassesShallow && AllowedDepth == other.AllowedDepth;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is CastOptions other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => PassesShallow ? AllowedDepth.GetHashCode() + 1 : 0;

    /// <summary>What is passed, for people to read.</summary>
    public override string ToString() => PassesShallow
        ? FormattableString.Invariant($"Only what goes deeper than {AllowedDepth:G9}")
        : "Every contact";
}
