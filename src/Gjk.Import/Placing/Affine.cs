namespace Gjk.Import;

/// <summary>A linear map with a shift, in double: the images of the three axes, and of the origin.</summary>
internal readonly record struct Affine(Double3 X, Double3 Y, Double3 Z, Double3 Origin)
{
    public static readonly Affine Identity = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), default);

    /// <summary>Scales first, then turns, then shifts.</summary>
    public static Affine Of(in Double3 position, in TurnD rotation, in Double3 scale)
    {
        Affine r = rotation.ToAffine();
        return new Affine(r.X * scale.X, r.Y * scale.Y, r.Z * scale.Z, position);
    }

    public bool IsFinite => X.IsFinite && Y.IsFinite && Z.IsFinite && Origin.IsFinite;

    /// <summary>The image of a point.</summary>
    public Double3 Apply(in Double3 p) => Turn(p) + Origin;

    /// <summary>The image of a direction, without the shift.</summary>
    public Double3 Turn(in Double3 v) => X * v.X + Y * v.Y + Z * v.Z;

    /// <summary>The transposed linear part times a vector. It is the inverse if the map is a rotation.</summary>
    public Double3 TurnBack(in Double3 v) => new(Double3.Dot(X, v), Double3.Dot(Y, v), Double3.Dot(Z, v));

    /// <summary>First the right one, then the left one.</summary>
    public static Affine operator *(in Affine parent, in Affine child) => new(
        parent.Turn(child.X), parent.Turn(child.Y), parent.Turn(child.Z), parent.Apply(child.Origin));

    /// <summary>The linear part of this as seen in the frame of a rotation: its transpose times this.</summary>
    public Affine SeenFrom(in TurnD rotation)
    {
        Affine r = rotation.ToAffine();
        return new Affine(r.TurnBack(X), r.TurnBack(Y), r.TurnBack(Z), default);
    }

    /// <summary>The rotation that keeps the direction of x and the plane of x and y (Gram-Schmidt). A mirroring map
    /// becomes a rotation with a negative scale.</summary>
    public TurnD Rotation()
    {
        Double3 x = Unit(X), z = Unit(Double3.Cross(x, Unit(Y)));
        TurnD turn = TurnD.FromAxes(x, Double3.Cross(z, x), z);
        return double.IsFinite(turn.X + turn.Y + turn.Z + turn.W) ? turn : TurnD.Identity;
    }

    private static Double3 Unit(in Double3 v) => v * (1 / v.Length);
}
