using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// What a solver found, in A's frame and relative to A's centre, before margins and rounding to float: the common currency of the fast and the
/// extended-precision solver.
/// </summary>
internal struct GjkOutcome
{
    public GjkStatus Status;

    /// <summary>The nearest feature of the cores' Minkowski difference, or the tetrahedron that holds the origin.</summary>
    public Simplex Simplex;

    /// <summary>The feature's normal: from the origin to the feature, so from B to A, of any length; zero height when overlapping.</summary>
    public ClosestFeature Feature;

    /// <summary>The best separating plane's value, |normal| not divided out: LowerBound = PlaneValue / sqrt(PlaneNormalSquared).</summary>
    public double PlaneValue, PlaneNormalSquared;

    /// <summary>The normal of that plane, which at the end is the feature's.</summary>
    public Vector3D PlaneNormal;

    /// <summary>Support calls made on each shape.</summary>
    public int Iterations;

    /// <summary>Makes an outcome without vertices and planes; the contents of empty slots are not cleared.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Start(out GjkOutcome outcome)
    {
#if NET
        Unsafe.SkipInit(out outcome);
        outcome.Simplex.Clear();
        outcome.Iterations = 0;
        outcome.PlaneNormalSquared = 0;
        outcome.Status = GjkStatus.IterationLimit;
#else
        outcome = default;
#endif
    }
}
