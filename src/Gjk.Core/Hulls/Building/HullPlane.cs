namespace Gjk.Core;

/// <summary>The plane through three points in rounded form: fast to test against, with a bound on how wrong a test can
/// be.</summary>
internal struct HullPlane
{
    /// <summary>The points, by index; counter-clockwise seen from above.</summary>
    public int A, B, C;

    /// <summary>(B - A) x (C - A), in units squared.</summary>
    public double NormalX, NormalY, NormalZ;

    /// <summary>A height with a larger magnitude than this has the right sign, for every point of the cloud. In units
    /// cubed.</summary>
    public double HeightError;
}
