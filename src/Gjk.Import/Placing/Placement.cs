namespace Gjk.Import;

/// <summary>Tells a scale along the axes from a skew, and places the smooth shapes under either.</summary>
internal static class Placement
{
    /// <summary>Share of the largest factor. The rotations of a file are rounded to float, so even a hierarchy without
    /// skew leaves about 1e-7 of it. A vertex moves by less than 1e-6 of the size if this much is left out, which
    /// HierarchyTests.ASmallSkewIsKept pins.</summary>
    private const double RotationNoise = 3e-7;

    /// <summary>True if a map only scales along the axes, up to the rounding of rotations.</summary>
    /// <param name="local">The map, seen from the object's rotation.</param>
    /// <param name="factors">The scale.</param>
    public static bool IsAlongAxes(in Affine local, out Double3 factors)
    {
        factors = new Double3(local.X.X, local.Y.Y, local.Z.Z);
        double across = Largest(
            Largest(local.X.Y, local.X.Z, local.Y.X), Largest(local.Y.Z, local.Z.X, local.Z.Y), 0);
        return across <= RotationNoise * Largest(factors.X, factors.Y, factors.Z);
    }

    /// <summary>True if none is 0 or beyond the range of float.</summary>
    public static bool IsUsableScale(in Double3 factors) =>
        IsUsableScale(factors.X) && IsUsableScale(factors.Y) && IsUsableScale(factors.Z);

    /// <summary>A ball, whatever the map makes of it.</summary>
    public static ImportedObject Ball(string name, double radius, in Affine world, in TurnD rotation)
    {
        if (!IsAlongAxes(world.SeenFrom(rotation), out Double3 factors))
        {
            Stretch stretch = Stretch.Of(world);
            return Ellipsoid(name, Absolute(stretch.Factors) * radius, world, stretch.After);
        }

        factors = Absolute(factors);
        return AreEqual(factors.X, factors.Y) && AreEqual(factors.Y, factors.Z)
            ? new ImportedObject(name, ImportedShape.Sphere(factors.X * radius), world, rotation)
            : Ellipsoid(name, factors * radius, world, rotation);
    }

    /// <summary>A capsule or a cylinder along y that a map has scaled, perhaps with skew.</summary>
    /// <param name="name">The object's name.</param>
    /// <param name="make">Makes the shape of a radius and half a height.</param>
    /// <param name="radius">Before the map.</param>
    /// <param name="halfHeight">Before the map. A capsule's caps are not part of it.</param>
    /// <param name="world">The map.</param>
    /// <param name="rotation">The object's rotation.</param>
    /// <exception cref="UnreadableException">The map makes it flat.</exception>
    public static ImportedObject AlongY(
        string name, Func<double, double, ImportedShape> make, double radius, double halfHeight, in Affine world,
        in TurnD rotation)
    {
        if (IsAlongAxes(world.SeenFrom(rotation), out Double3 factors))
        {
            Double3 size = Absolute(factors);
            if (AreEqual(size.X, size.Y) && AreEqual(size.Y, size.Z))
                return new ImportedObject(name, make(radius * size.X, halfHeight * size.X), world, rotation);
            if (!IsUsableScale(factors)) throw Flat();
            var plain = new ImportedObject(name, make(radius, halfHeight), world, rotation);
            return plain with { Scale = (Vector3)factors };
        }

        Stretch stretch = Stretch.Of(world);
        if (!IsUsableScale(stretch.Factors)) throw Flat();
        ImportedShape turned = make(radius, halfHeight) with { Rotation = stretch.Before.ToFloat() };
        return new ImportedObject(name, turned, world, stretch.After) with { Scale = (Vector3)stretch.Factors };
    }

    public static Double3 Absolute(in Double3 v) => new(Math.Abs(v.X), Math.Abs(v.Y), Math.Abs(v.Z));

    private static ImportedObject Ellipsoid(string name, in Double3 radii, in Affine world, in TurnD rotation) =>
        new(name, ImportedShape.Ellipsoid((Vector3)radii), world, rotation);

    private static bool IsUsableScale(double factor) => (float)factor != 0 && float.IsFinite((float)factor);

    private static UnreadableException Flat() => new("a scale of 0 makes the round shape flat");

    private static bool AreEqual(double a, double b) => Math.Abs(a - b) <= RotationNoise * Math.Max(a, b);

    private static double Largest(double a, double b, double c) =>
        Math.Max(Math.Abs(a), Math.Max(Math.Abs(b), Math.Abs(c)));
}
