namespace Gjk.Exact.Answers;

/// <summary>What the library promises, in numbers (contracts 5 and 6).</summary>
public static class Accuracy
{
    /// <summary>Ratio to the distance: its rounding to float (2^-24), and that of the bound, each in its
    /// direction.</summary>
    public const double DistanceRatio = 1.2e-7;

    /// <summary>Length, as a fraction of the scale: below it a distance is noise of double arithmetic.</summary>
    public const double DistanceScale = 1e-14;

    /// <summary>Length, as a fraction of the scale: shapes that overlap or are apart by more than this must get the
    /// right flag.</summary>
    public const double FlagScale = 1e-9;

    /// <summary>Length, as a fraction of how far a shape is from its own origin: what turning it there costs in
    /// double-double, 2^-100. It is seen only where both shapes are points.</summary>
    public const double Offset = 7.9e-31;

    /// <summary>Length, as a fraction of max(scale, distance), for shapes with a curved core.</summary>
    public const double CurvedRatio = 1e-6;

    /// <summary>Length, as a fraction of the longest side of its shape: how far a closest point may be off
    /// it.</summary>
    public const double WitnessScale = 1.2e-7;

    /// <summary>A pure number: how far the normal's length may be from 1.</summary>
    public const double UnitLength = 1e-6;

    /// <summary>A pure number: the angle, in radians, by which rounding its components to float may turn a unit vector:
    /// the root of three times 2^-25, rounded up.</summary>
    public const double NormalTurn = 1.1e-7;

    /// <summary>Ratio: the rounding of one coordinate to float, 2^-24.</summary>
    public const double HalfFloat = 1.0 / (1 << 24);

    /// <summary>Ratio: a dozen roundings to double (2^-53 each), for what the checks themselves compute.</summary>
    public const double Rounding = 12.0 / (1L << 53);

    /// <summary>Length: below it a float has no digits; the least one is 1.4e-45.</summary>
    public const double LeastFloat = 1.5e-45;

    /// <summary>How far the distance of polytopes, margins included, may be off.</summary>
    public static double Band(double distance, double scale) => DistanceRatio * distance + DistanceScale * scale;

    /// <summary>The same where a core is curved.</summary>
    public static double CurvedBand(double distance, double scale) => CurvedRatio * Math.Max(scale, distance);
}
