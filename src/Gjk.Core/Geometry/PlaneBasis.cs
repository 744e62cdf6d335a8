namespace Gjk.Core;

/// <summary>Two unit vectors that span the plane across a third; the three are right-handed.</summary>
internal readonly struct PlaneBasis
{
    /// <summary>The plane's axes.</summary>
    public readonly Double3 U, V;

    /// <param name="normal">Of unit length.</param>
    public PlaneBasis(in Double3 normal)
    {
        // Across the coordinate axis that is furthest from the normal, so that nothing cancels.
        double x = Math.Abs(normal.X), y = Math.Abs(normal.Y), z = Math.Abs(normal.Z);
        Double3 across = x <= y && x <= z ? new Double3(0, -normal.Z, normal.Y)
            : y <= z ? new Double3(normal.Z, 0, -normal.X) : new Double3(-normal.Y, normal.X, 0);
        U = across * (1 / across.Length);
        V = Double3.Cross(normal, U);
    }

    /// <summary>Both axes.</summary>
    public void Deconstruct(out Double3 u, out Double3 v) => (u, v) = (U, V);
}
