namespace Gjk.Core;

/// <summary>Volume, centre and spread in closed form, at density 1: of balls, capsules and boxes, and of the pieces
/// that the others are the sum of, each in its own file.</summary>
/// <remarks>Source: the moments of balls, cylinders, cones, ellipsoids and boxes are those of any text on mechanics
/// (Meriam and Kraige, "Dynamics", 2012, table D/4); the others are polynomials, integrated along an axis. Nothing is
/// sampled, so what is left is the rounding of a few products in double.</remarks>
internal static class MassForms
{
    public static MassProperties Ball(double radius, in Double3 center)
    {
        double square = radius * radius / 5;
        return Even(4 * Math.PI / 3 * radius * radius * radius, center, new Double3(square, square, square));
    }

    /// <summary>A segment widened by a radius: a cylinder and two halves of a ball.</summary>
    public static MassProperties Capsule(in Double3 a, in Double3 b, double radius)
    {
        Double3 half = (a - b) * 0.5;
        double square = radius * radius, length = half.Length;
        double tube = 2 * Math.PI * square * length, ball = 4 * Math.PI / 3 * square * radius;
        double across = tube * (square / 4) + ball * (square / 5);
        double along = tube * (length * length / 3) + ball * (square / 5 + length * (0.75 * radius + length));
        Double3 unit = length > 0 ? half * (1 / length) : default;
        Double3 squares = Double3.Multiply(unit, unit) * (along - across) + new Double3(across, across, across);
        var crossed = new Double3(unit.X * unit.Y, unit.X * unit.Z, unit.Y * unit.Z);
        return new(tube + ball, (a + b) * 0.5, squares, crossed * (along - across));
    }

    /// <summary>A box widened by a radius: the box, six plates on it, twelve quarters of cylinders and eight octants of
    /// a ball (J. Steiner, "Über parallele Flächen", 1840, has the volume).</summary>
    public static MassProperties Box(in Double3 half, double radius)
    {
        double a = half.X, b = half.Y, c = half.Z, area = a * b + b * c + c * a;
        double volume = 8 * (a * b * c + radius * area)
            + Math.PI * radius * radius * (2 * (a + b + c) + 4.0 / 3 * radius);
        Double3 squares = new(Square(a, b, c, radius), Square(b, a, c, radius), Square(c, a, b, radius));
        return new(volume, default, squares);
    }

    /// <summary>The second moment of that along the axis on which the box reaches a.</summary>
    private static double Square(double a, double b, double c, double r)
    {
        double square = a * a, disc = Math.PI * r * r;
        double level = (8 * a * (b * c + r * (b + c)) + 2 * disc * a) * (square / 3);
        double plates = 8 * b * c * r * (square + r * (a + r / 3));
        double edges = 2 * (b + c) * (disc * (square + r * r / 4) + 8.0 / 3 * a * r * r * r);
        return level + plates + edges + disc * r * (4.0 / 3 * square + r * (a + 4.0 / 15 * r));
    }

    /// <summary>A frustum that stands on the origin.</summary>
    public static MassProperties Frustum(double a, double b, double height)
    {
        double whole = Math.PI * height;
        double fourth = a * a * a * a + a * b * (a * a + a * b + b * b) + b * b * b * b;
        return OfRevolution(
            whole / 3 * (a * a + a * b + b * b), whole * height / 12 * (a * a + 2 * a * b + 3 * b * b),
            whole * height * height / 30 * (a * a + 3 * a * b + 6 * b * b), whole / 20 * fourth);
    }

    /// <summary>The body inside of an arc about the y axis, from the level of its sine to its top: where the arc's
    /// centre is on the axis, a cap of a ball.</summary>
    /// <param name="from">How far the arc's centre is from the axis; 0, or the sine is at most 0.</param>
    /// <param name="radius">Of the arc, whose centre is on the level of the origin.</param>
    /// <param name="sine">Of the arc's lower end, over the level.</param>
    public static MassProperties Rim(double from, double radius, double sine)
    {
        double left = 1 - sine, level = left * (1 + sine), k = Math.Sqrt(level);

        // The integrals of powers of the cosine along the arc.
        double two = (ArcTangent.Atan2(k, sine) - sine * k) / 2, four = (3 * two - sine * k * level) / 4;
        double three = left * left * (2 + sine) / 3, five = left * left * left * (8 + sine * (9 + sine * 3)) / 15;
        double squared = left * left * (2 + sine * (4 + sine * (6 + sine * 3))) / 15;
        double r = radius, a = from, disc = Math.PI * r;
        return OfRevolution(
            disc * (a * a * left + r * (2 * a * two + r * three)),
            disc * r * level * (a * a / 2 + r * (2 * a * k / 3 + r * level / 4)),
            disc * r * r * (a * a * left * (1 + sine * (1 + sine)) / 3 + r * (2 * a * (two - four) + r * squared)),
            disc / 4 * (a * a * a * (a * left + 4 * r * two)
                + r * r * (6 * a * a * three + r * (4 * a * four + r * five))));
    }

    /// <summary>A body about the y axis, from the integrals of 1, y, y² and x² over it.</summary>
    private static MassProperties OfRevolution(double volume, double y, double yy, double xx)
    {
        double center = volume > 0 ? y / volume : 0;
        return new(volume, new Double3(0, center, 0), new Double3(xx, Math.Max(0, yy - y * center), xx));
    }

    /// <summary>The same along the y axis, mirrored where the side is -1.</summary>
    public static MassProperties Moved(in MassProperties body, double by, double side) =>
        body.Turned(QuaternionD.Identity, new Double3(0, side * body.Center.Y + by, 0));

    public static MassProperties Even(double volume, in Double3 center, in Double3 meanSquares) =>
        new(volume, center, meanSquares * volume);
}
