using System;

namespace Gjk.Core.Tests.Support;

/// <summary>The promised accuracy (contract 5 and 6), in one place.</summary>
internal static class Tolerance
{
    /// <summary>Ratio to the distance: two roundings to float (2^-24 each).</summary>
    public const double DistanceRatio = 1.2e-7;

    /// <summary>Length, as a fraction of the scale: below it a distance is noise of double arithmetic.</summary>
    public const double DistanceScale = 1e-14;

    /// <summary>Length, as a fraction of the scale: distances and depths above it must get the right flag.</summary>
    public const double Flag = 1e-9;

    /// <summary>Length, as a fraction of max(scale, distance), for cylinder, cone and ellipsoid.</summary>
    public const double Curved = 1e-6;

    /// <summary>Length, as a fraction of the scale: how far a witness point may be off its shape.</summary>
    public const double Witness = 1.2e-7;

    public static double Band(double distance, double scale) => DistanceRatio * distance + DistanceScale * scale;

    public static double CurvedBand(double distance, double scale) => Curved * Math.Max(distance, scale);

    public static double Band(TestPair pair, double distance) =>
        pair.IsPolytope ? Band(distance, pair.Scale) : CurvedBand(distance, pair.Scale);
}
