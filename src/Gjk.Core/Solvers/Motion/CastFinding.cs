namespace Gjk.Core;

/// <summary>What a cast found.</summary>
internal struct CastFinding
{
    /// <summary>Enclosed where the shapes touch, Apart where they do not.</summary>
    public Verdict Outcome;

    /// <summary>Up to here they are apart.</summary>
    public double Fraction;

    /// <summary>Of the plane that was crossed last, from A to B, of unit length; zero at the start.</summary>
    public Vector3D Normal;

    /// <summary>Where they touch, on A's core, in A's frame from its centre.</summary>
    public Vector3D OnA;

    /// <summary>Support calls made on each shape.</summary>
    public int Iterations;
}
