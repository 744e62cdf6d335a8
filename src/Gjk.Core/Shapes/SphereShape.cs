namespace Gjk.Core;

/// <summary>A ball about the local origin: a point core with the radius as its margin.</summary>
public readonly struct SphereShape : ISupportMap, IRayTarget, ITightBounds
{
    /// <summary>The radius, at least 0.</summary>
    public readonly float Radius;

    /// <summary>Makes a sphere.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The radius is negative, NaN or infinite.</exception>
    public SphereShape(float radius) => Radius = Guard.NonNegative(radius, nameof(radius));

    /// <inheritdoc/>
    public Vector3D Center => default;

    /// <inheritdoc/>
    public double Margin => Radius;

    /// <inheritdoc/>
    public double BoundingRadius => Radius;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out SegmentCore segment) =>
        SegmentCore.Make(default, default, 1, default, Radius, Radius, out segment);

    bool IRayTarget.TryGetTarget(out RayTarget target)
    {
        RayTarget.Ball(Radius, out target);
        return true;
    }

    /// <inheritdoc/>
    public int Support(in Vector3D direction, out Vector3D point)
    {
        point = default;
        return 0;
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Vector3D point)
    {
        point = default;
        return id == 0;
    }
}
