using System;

namespace Gjk.Core;

/// <summary>Two unit vectors that span the plane across a third; the three are right-handed.</summary>
internal readonly struct PlaneBasis
{
    /// <summary>The plane's axes.</summary>
    public readonly Vector3D U, V;

    /// <param name="normal">Of unit length.</param>
    public PlaneBasis(in Vector3D normal)
    {
        // Across the coordinate axis that is furthest from the normal, so that nothing cancels.
        double x = Math.Abs(normal.X), y = Math.Abs(normal.Y), z = Math.Abs(normal.Z);
        Vector3D across = x <= y && x <= z ? new Vector3D(0, -normal.Z, normal.Y)
            : y <= z ? new Vector3D(normal.Z, 0, -normal.X) : new Vector3D(-normal.Y, normal.X, 0);
        U = across * (1 / across.Length);
        V = Vector3D.Cross(normal, U);
    }

    /// <summary>Both axes.</summary>
    public void Deconstruct(out Vector3D u, out Vector3D v) => (u, v) = (U, V);
}
