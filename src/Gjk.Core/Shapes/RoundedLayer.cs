namespace Gjk.Core;

/// <summary>Volume, centre and spread of what a polyhedron grows by when it is widened by a radius, at density 1: a
/// prism on each face, a sector of a cylinder along each edge, and at each corner a sector of a ball.</summary>
/// <remarks>Source: J. Steiner, "Über parallele Flächen", 1840, for the volume; the moments are those of the same
/// pieces. A corner's sector is as wide as the angles of its faces leave of a whole turn (Descartes), and its moments
/// follow from the angles of its edges by the divergence theorem; the two ends of an edge are taken together, so that
/// most of it cancels before it is rounded. What is flat has two sides, with half a turn between them.</remarks>
/// <param name="apex">Any point; best in the middle.</param>
/// <param name="radius">At least 0.</param>
internal struct RoundedLayer(in Double3 apex, double radius)
{
    private readonly Double3 _apex = apex;
    private readonly double _r = radius, _square = radius * radius / 2, _cube = radius * radius * radius / 3;
    private double _volume;
    private Double3 _first, _squares, _products;

    /// <summary>The prism on a triangle, and what the ball at each corner loses to it.</summary>
    /// <param name="p">The first corner.</param>
    /// <param name="q">The second one, counter-clockwise seen from outside.</param>
    /// <param name="s">The third one.</param>
    /// <param name="normal">Of unit length, outward; 0 where there is no area.</param>
    public void AddFace(in Double3 p, in Double3 q, in Double3 s, out Double3 normal)
    {
        Double3 a = p - _apex, b = q - _apex, c = s - _apex, sum = a + b + c, cross = Double3.Cross(b - a, c - a);
        double area = cross.Length / 2, share = area * _r / 12;
        normal = area > 0 ? cross * (0.5 / area) : default;
        _volume += area * _r;
        _first += sum * (area * _r / 3) + normal * (area * _square);
        Spread(share, a, a);
        Spread(share, b, b);
        Spread(share, c, c);
        Spread(share, sum, sum);
        Spread(area * _square * 2 / 3, sum, normal);
        Spread(area * _cube, normal, normal);
        AddBall(p, -Angle(b - a, c - a));
        AddBall(q, -Angle(c - b, a - b));
        AddBall(s, -Angle(a - c, b - c));
    }

    /// <summary>The sector along an edge, and what it adds to the balls at its ends.</summary>
    /// <param name="p">Where the edge begins, seen so that the first face is on its left.</param>
    /// <param name="q">Where it ends.</param>
    /// <param name="left">The normal of that face.</param>
    /// <param name="right">That of the other one.</param>
    public void AddEdge(in Double3 p, in Double3 q, in Double3 left, in Double3 right)
    {
        Double3 a = p - _apex, b = q - _apex, along = b - a;
        double length = along.Length;
        if (!(length > 0)) return;
        Double3 unit = along * (1 / length), down = Double3.Cross(unit, left);
        double sine = Double3.Dot(down, right), cosine = Double3.Dot(left, right);

        // Of the two sides of what is flat the sine is rounding.
        if (cosine < 0) sine = Math.Max(sine, 0);
        double angle = ArcTangent.Atan2(sine, cosine), sector = angle * _square * length;
        Double3 mean = left * sine + down * (1 - cosine), sum = a + b;
        _volume += sector;
        _first += sum * (sector / 2) + mean * (_cube * length);
        Spread(sector / 6, a, a);
        Spread(sector / 6, b, b);
        Spread(sector / 6, sum, sum);
        Spread(_cube * length, sum, mean);
        double fourth = _square * _square * length, product = sine * cosine;
        Spread(fourth / 2 * (angle + product), left, left);
        Spread(fourth / 2 * (angle - product), down, down);
        Spread(fourth * sine * sine, left, down);
        Spread(fourth * angle, unit, unit);
    }

    /// <summary>A sector of the ball at a corner, but for what edges add.</summary>
    /// <param name="center">The corner.</param>
    /// <param name="angle">The solid angle: the whole turn of a corner, or less one of its faces' angles.</param>
    public void AddBall(in Double3 center, double angle)
    {
        Double3 at = center - _apex;
        double volume = angle * _cube, even = volume * _r * _r / 5;
        _volume += volume;
        _first += at * volume;
        _squares += new Double3(even, even, even);
        Spread(volume, at, at);
    }

    /// <summary>Of what was added; ends the sum.</summary>
    public MassProperties ToMass()
    {
        Double3 center = _first * (1 / _volume);
        Spread(-_volume, center, center);
        return new MassProperties(_volume, center + _apex, _squares, _products);
    }

    private static double Angle(in Double3 a, in Double3 b) =>
        ArcTangent.Atan2(Double3.Cross(a, b).Length, Double3.Dot(a, b));

    /// <summary>Adds the symmetric product of two vectors to the second moments.</summary>
    private void Spread(double weight, in Double3 a, in Double3 b)
    {
        _squares += Double3.Multiply(a, b) * weight;
        _products += new Double3(a.X * b.Y + a.Y * b.X, a.X * b.Z + a.Z * b.X, a.Y * b.Z + a.Z * b.Y) * (weight / 2);
    }
}
