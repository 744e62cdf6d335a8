namespace Gjk.Core;

/// <summary>A contact along the face of a triangle, whose pair's own way does not show.</summary>
internal readonly struct FaceContact
{
    public readonly PartContacts Contact;

    /// <summary>The pair that it was found of; its contact may name another part where the other side's tip
    /// is.</summary>
    public readonly int PartA, PartB;

    /// <summary>Whether the face is A's.</summary>
    public readonly bool IsOfA;

    /// <summary>How far the two parts are apart, by their own way; negative where they overlap.</summary>
    public readonly float Own;

    public FaceContact(in PartContacts contact, int partA, int partB, bool isOfA, float own)
    {
        Contact = contact;
        (PartA, PartB, IsOfA, Own) = (partA, partB, isOfA, own);
    }
}
