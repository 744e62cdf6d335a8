namespace Gjk.Core;

/// <summary>A contact that may stand for a pair whose own way out does not show, if the pair needs one.</summary>
internal readonly struct FaceContact : IComparable<FaceContact>
{
    public readonly PairContacts Contact;

    /// <summary>The pair; the contact may name another part, where the other side's tip is.</summary>
    public readonly int PartA, PartB;

    /// <summary>Whether the contact is along a face of A.</summary>
    public readonly bool IsOfA;

    /// <summary>How far the two parts are apart, by their own way; negative where they overlap.</summary>
    public readonly float Own;

    /// <summary>That way, from A to B.</summary>
    public readonly Vector3 OwnNormal;

    /// <summary>The face's normal, from A to B, where the contact is along the pair's own way, as that is much shorter;
    /// else 0.</summary>
    public readonly Vector3 Shortened;

    public FaceContact(in PairContacts contact, in PairDistance pair, bool isOfA, in DistanceResult own)
    {
        Contact = contact;
        (PartA, PartB, IsOfA) = (pair.PartA, pair.PartB, isOfA);
        (Own, OwnNormal) = (own.Distance, own.Normal);
    }

    /// <summary>A contact along its pair's own way.</summary>
    public FaceContact(in PairContacts own, bool isOfA = true, Vector3 shortened = default)
    {
        Contact = own;
        (PartA, PartB, IsOfA, Shortened) = (own.PartA, own.PartB, isOfA, shortened);
        (Own, OwnNormal) = (own.Result.Distance, own.Result.Normal);
    }

    /// <summary>The deepest first, and then by the parts.</summary>
    public int CompareTo(FaceContact other)
    {
        int order = Contact.Result.Distance.CompareTo(other.Contact.Result.Distance);
        if (order == 0) order = Contact.Pair.CompareTo(other.Contact.Pair);
        if (order == 0) order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }
}
