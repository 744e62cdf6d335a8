namespace Gjk.Core;

/// <summary>A shape whose struct a <see cref="ConvexShape"/> keeps, and asks whatever its kind is.</summary>
internal interface ICurve : ILibraryShape
{
    /// <summary>At density 1, in closed form, widened by a radius, about the local origin.</summary>
    /// <exception cref="InvalidOperationException">Widened it has no closed form.</exception>
    MassProperties GetMass(double rounding);
}
