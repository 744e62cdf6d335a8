namespace Gjk.Core;

/// <summary>An angle between 0 and half a turn, by its cosine and sine.</summary>
internal struct HullTurn
{
    /// <summary>Times any length.</summary>
    public double Cosine, Sine;

    /// <summary>Half a turn, less so little that double does not tell it from half a turn.</summary>
    public static HullTurn Half => new() { Cosine = -1, Sine = 1e-100 };

    /// <summary>The squared length that they are multiplied by.</summary>
    public readonly double SizeSquared => Cosine * Cosine + Sine * Sine;

    /// <summary>Of two products with directions a quarter turn apart, that with the direction between them.</summary>
    public readonly double Of(double here, double ahead) => here * Cosine + ahead * Sine;

    /// <summary>Shortens it to where a product falls to 0, that is not below 0 here, if that is sooner.</summary>
    /// <param name="here">The product now; rounding may have made it less than 0.</param>
    /// <param name="ahead">The product a quarter turn ahead.</param>
    public bool TryShorten(double here, double ahead)
    {
        double sine = Math.Max(here, 0);

        // What is 0 here and grows falls to 0 again after half a turn only; what is above 0 falls before that.
        if (!((ahead < 0 || sine > 0) && -ahead * Sine > Cosine * sine)) return false;
        Cosine = -ahead;
        Sine = sine;
        return true;
    }

    /// <summary>Brings cosine and sine to their lengths.</summary>
    public void Normalize()
    {
        double scale = 1 / Math.Sqrt(SizeSquared);
        Cosine *= scale;
        Sine *= scale;
    }

    /// <summary>Takes another angle away that is not larger.</summary>
    public void TakeAway(in HullTurn turn) =>
        (Cosine, Sine) = (Cosine * turn.Cosine + Sine * turn.Sine, Sine * turn.Cosine - Cosine * turn.Sine);
}
