namespace Gjk.Core;

/// <summary>What a solver can say about two cores that move. The numbers are those of <see cref="Verdict"/>, so the
/// verdict on the distance at one fraction can be cast to the verdict on the motion so far.</summary>
internal enum MotionVerdict : byte
{
    /// <summary>The search ended at its limit; up to the fraction there is no contact.</summary>
    Undecided = Verdict.Undecided,

    /// <summary>They are apart up to the end.</summary>
    Miss = Verdict.Apart,

    /// <summary>They touch at the fraction, or get too deep there.</summary>
    Hit = Verdict.Enclosed,

    /// <summary>A contact that was followed is over at the fraction.</summary>
    Over = Verdict.Beyond,

    /// <summary>A support function contradicted itself or gave NaN.</summary>
    Contradiction = Verdict.Contradiction,
}

/// <summary>What a cast found.</summary>
internal struct CastFinding
{
    /// <summary>How the search ended.</summary>
    public MotionVerdict Outcome;

    /// <summary>Up to here they are apart.</summary>
    public double Fraction;

    /// <summary>Of the plane that was crossed last, from A to B, of unit length; zero at the start.</summary>
    public Double3 Normal;

    /// <summary>Where they touch, on A's core, in A's frame from its centre.</summary>
    public Double3 OnA;

    /// <summary>Support calls made on each shape.</summary>
    public int Iterations;
}
