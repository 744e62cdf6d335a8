namespace Gjk.Core;

/// <summary>The frame in which a shape keeps its faces, as seen from outside an uneven scale. The scale changes angles:
/// a face that is level inside may be steep outside, where another face is more level.</summary>
internal readonly struct OuterFrame
{
    /// <summary>The images of the inner axes, at most of unit length; their size says nothing.</summary>
    private readonly Double3 _x, _y, _z;

    /// <summary>The direction in which a face is asked for, outside, of unit length.</summary>
    public readonly Double3 Direction;

    /// <param name="factors">The scale between the two, none 0.</param>
    /// <param name="direction">Outside, not 0.</param>
    public OuterFrame(in Double3 factors, in Double3 direction)
        : this(new Double3(1, 0, 0), new Double3(0, 1, 0), new Double3(0, 0, 1), Unit(direction)) =>
        this = Stretched(factors);

    private OuterFrame(in Double3 x, in Double3 y, in Double3 z, in Double3 direction) =>
        (_x, _y, _z, Direction) = (x, y, z, direction);

    /// <summary>The same for a frame inside another scale.</summary>
    public OuterFrame Stretched(in Double3 factors)
    {
        double one = 1 / factors.LargestMagnitude;
        return new(_x * (factors.X * one), _y * (factors.Y * one), _z * (factors.Z * one), Direction);
    }

    /// <summary>The same for a frame that is turned.</summary>
    public OuterFrame Turned(in RotationD rotation) => new(
        Outward(new Double3(rotation.M00, rotation.M10, rotation.M20)),
        Outward(new Double3(rotation.M01, rotation.M11, rotation.M21)),
        Outward(new Double3(rotation.M02, rotation.M12, rotation.M22)), Direction);

    /// <summary>An edge as it is seen, but for its length.</summary>
    public Double3 Outward(in Double3 edge) => _x * edge.X + _y * edge.Y + _z * edge.Z;

    /// <summary>The cosine between a face's normal as it is seen and the direction; 0 where there is none.</summary>
    /// <param name="normal">Inside, of any length: normals are mapped by the matrix of cofactors.</param>
    public double Cosine(in Double3 normal)
    {
        Double3 yz = Double3.Cross(_y, _z);
        Double3 seen = yz * normal.X + Double3.Cross(_z, _x) * normal.Y + Double3.Cross(_x, _y) * normal.Z;
        double length = seen.Length, along = Double3.Dot(seen, Direction);
        if (!(length > 0)) return 0;
        return (Double3.Dot(_x, yz) < 0 ? -along : along) / length;
    }

    private static Double3 Unit(in Double3 direction)
    {
        Double3 safe = DirectionRange.ToUnit(direction);
        return safe * (1 / safe.Length);
    }
}
