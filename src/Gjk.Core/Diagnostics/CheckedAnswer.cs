namespace Gjk.Core.Diagnostics;

/// <summary>What <see cref="AnswerCheck"/> says of an answer.</summary>
public enum CheckStatus : byte
{
    /// <summary>The bounds neither prove nor refute it.</summary>
    Open = 0,

    /// <summary>All that it says holds, within the tolerance.</summary>
    Proved = 1,

    /// <summary>Of a depth: the shapes overlap, and along the normal they part after what it says. That no other way
    /// out is shorter is not proved.</summary>
    ProvedAtMost = 2,

    /// <summary>Something that it says does not hold, by more than the tolerance.</summary>
    Refuted = 3,
}

/// <summary>What a check says of an answer, and the bounds that it comes from. Immutable.</summary>
public readonly struct CheckedAnswer
{
    /// <summary>What is proved.</summary>
    public readonly CheckStatus Status;

    /// <summary>The true number is not below this: the distance or signed distance, of a cast the fraction of the first
    /// touch, of a ray the distance along it. It needs no trust in the answer.</summary>
    public readonly double LowerBound;

    /// <summary>The true number is not above this; +infinity where nothing is known.</summary>
    public readonly double UpperBound;

    internal CheckedAnswer(CheckStatus status, double lowerBound, double upperBound) =>
        (Status, LowerBound, UpperBound) = (status, lowerBound, upperBound);

    /// <summary>What is proved and the bounds, for people to read.</summary>
    public override string ToString() =>
        FormattableString.Invariant($"{Status}, from {LowerBound:R} to {UpperBound:R}");
}
