namespace Gjk.Core;

/// <summary>Up to four points where two shapes touch, and the direction in which they push each other: what
/// <see cref="ConvexQuery"/>'s contacts fill. Kept by the caller; mutable, and a copy is independent.</summary>
public struct ContactManifold
{
    /// <summary>The most points that a manifold has: four carry any flat contact.</summary>
    public const int Capacity = 4;

    private ManifoldPoint _first, _second, _third, _fourth;

    /// <summary>How many points there are, from 0 to <see cref="Capacity"/>.</summary>
    public int Count { get; private set; }

    /// <summary>The unit vector in which B leaves A, common to all points; zero when there are none.</summary>
    public Vector3 Normal { get; private set; }

    /// <summary>A point. Those of two convex shapes are in an order of their <see cref="ManifoldPoint.FeatureId"/>s,
    /// by the lesser half and then by the greater one, so that it stays from frame to frame; the exchanged pair has
    /// the same order. One of them is the deepest, or as deep to within 1e-6 of the size. Those of parts of other
    /// shapes have the deepest first. Know a point again by its id, not by its place.</summary>
    /// <param name="index">From 0 to <see cref="Count"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such point.</exception>
    public readonly ManifoldPoint this[int index]
    {
        get
        {
            if ((uint)index >= (uint)Count)
                throw new ArgumentOutOfRangeException(nameof(index), index, "There is no such contact point.");
            return index == 0 ? _first : index == 1 ? _second : index == 2 ? _third : _fourth;
        }
    }

    /// <summary>The same manifold with A and B exchanged.</summary>
    public readonly ContactManifold Swapped
    {
        get
        {
            var swapped = default(ContactManifold);
            swapped.Begin(Opposite.Of(Normal));
            for (int i = 0; i < Count; i++) swapped.Add(this[i].Swapped);
            return swapped;
        }
    }

    /// <summary>Removes all points.</summary>
    public void Clear() => Begin(Vector3.Zero);

    /// <summary>The points, for people to read.</summary>
    public override readonly string ToString() =>
        FormattableString.Invariant($"{Count} points along {((Double3)Normal).ToText()}");

    internal void Begin(Vector3 normal)
    {
        Count = 0;
        Normal = normal;
    }

    internal void Add(in ManifoldPoint point)
    {
        int index = Count++;
        if (index == 0) _first = point;
        else if (index == 1) _second = point;
        else if (index == 2) _third = point;
        else _fourth = point;
    }
}
