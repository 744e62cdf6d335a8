namespace Gjk.Core.Diagnostics;

/// <summary>What is known of the things that an answer says.</summary>
internal struct AnswerClaims
{
    private bool _isOpen, _isRefuted;

    /// <summary>Whether a depth among them is only proved not to be larger.</summary>
    public bool IsAtMost;

    /// <summary>Whether a depth among them may be more than the true one: a cast does not say whether its search had
    /// room.</summary>
    public bool MayBeLess;

    /// <summary>All of them together.</summary>
    public readonly CheckStatus Status => _isRefuted ? CheckStatus.Refuted : _isOpen ? CheckStatus.Open
        : IsAtMost ? CheckStatus.ProvedAtMost : CheckStatus.Proved;

    /// <summary>Whether anything is known.</summary>
    public bool AreAny { get; private set; }

    /// <summary>Something that was proved, refuted, or neither.</summary>
    public void Add(bool isProved, bool isRefuted)
    {
        _isOpen |= !isProved;
        _isRefuted |= isRefuted;
        AreAny |= isProved || isRefuted;
    }

    /// <summary>Something that is certain either way.</summary>
    public void Add(bool holds) => Add(holds, !holds);
}
