namespace Gjk.Core;

/// <summary>A contact that may replace one of a pair whose own way out the surface does not show, if the pair needs
/// one.</summary>
/// <param name="contact">The contact.</param>
/// <param name="own">The pair's contact along its own way.</param>
/// <param name="isOfA">Whether the contact is along a face of A.</param>
/// <param name="shortened">See <see cref="Shortened"/>.</param>
internal readonly struct FaceContact(
    in PairContacts contact, in PairContacts own, bool isOfA, Vector3 shortened = default) : IComparable<FaceContact>
{
    public readonly PairContacts Contact = contact;

    /// <summary>The pair's parts. The contact may name another part, which has the other side's tip.</summary>
    public readonly int PartA = own.PartA, PartB = own.PartB;

    /// <summary>Whether the contact is along a face of A.</summary>
    public readonly bool IsOfA = isOfA;

    /// <summary>The distance of the two parts along their own way; negative where they overlap.</summary>
    public readonly float Own = own.Result.Distance;

    /// <summary>Their own way, from A to B.</summary>
    public readonly Vector3 OwnNormal = own.Result.Normal;

    /// <summary>The normal of the face, from A to B, if the contact is along the pair's own way because that is much
    /// shorter; else 0.</summary>
    public readonly Vector3 Shortened = shortened;

    /// <summary>A contact along its pair's own way.</summary>
    public FaceContact(in PairContacts own)
        : this(own, own, true)
    {
    }

    /// <summary>The contact, with the pair's own parts.</summary>
    public PairContacts OfOwnParts => new(PartA, PartB, Contact.Result, Contact.Manifold, Contact.Pair);

    /// <summary>False of a <c>default</c> struct.</summary>
    public bool IsThere => Contact.Manifold.Count > 0;

    /// <summary>The deepest first, and then by the parts.</summary>
    public int CompareTo(FaceContact other)
    {
        int order = Contact.Result.Distance.CompareTo(other.Contact.Result.Distance);
        if (order == 0) order = Contact.Pair.CompareTo(other.Contact.Pair);
        if (order == 0) order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }
}
