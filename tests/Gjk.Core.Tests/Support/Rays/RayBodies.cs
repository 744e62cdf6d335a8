namespace Gjk.Core.Tests.Support.Rays;

/// <summary>Where a line may cross a surface, and the normal there.</summary>
internal readonly record struct Crossing(Fixed T, FixedVector Normal);

/// <summary>A convex body by brute force: all points of a line that are on one of its surfaces and in the body. The
/// least and the greatest are where the line enters and leaves.</summary>
internal abstract class RayBodyReference
{
    public abstract IEnumerable<Crossing> Crossings(FixedVector o, FixedVector d);

    /// <summary>The roots of |o + t d|² = r² with x, y and z weighted.</summary>
    protected static IEnumerable<Crossing> Quadric(FixedVector o, FixedVector d, FixedVector weight, Fixed r2)
    {
        Fixed a = Form(d, d), b = Form(o, d), c = Form(o, o) - r2, discriminant = b * b - a * c;
        if (discriminant.Sign < 0) yield break;
        Fixed root = Fixed.Sqrt(discriminant);
        if (Fixed.Abs(a) > Fixed.Tiny)
        {
            yield return At((-b - root) / a);
            yield return At((-b + root) / a);
        }
        else if (Fixed.Abs(b) > Fixed.Tiny)
        {
            yield return At(-c / (b + b));
        }

        Fixed Form(FixedVector p, FixedVector q) =>
            p.X * q.X * weight.X + p.Y * q.Y * weight.Y + p.Z * q.Z * weight.Z;
        Crossing At(Fixed t)
        {
            FixedVector p = o + d * t;
            return new Crossing(t, new(p.X * weight.X, p.Y * weight.Y, p.Z * weight.Z));
        }
    }

    protected static IEnumerable<Crossing> Level(FixedVector o, FixedVector d, Fixed y, Fixed sign)
    {
        if (d.Y.Sign != 0) yield return new Crossing((y - o.Y) / d.Y, new(0.0, sign, 0.0));
    }
}

/// <summary>Balls and what is between them.</summary>
internal sealed class CapsuleReference(Double3 a, Double3 b, double radius) : RayBodyReference
{
    public override IEnumerable<Crossing> Crossings(FixedVector o, FixedVector d)
    {
        FixedVector one = new Double3(1, 1, 1), from = a, axis = (FixedVector)b - from;
        Fixed r2 = (Fixed)radius * radius, length2 = FixedVector.Dot(axis, axis);
        IEnumerable<Crossing> all = Quadric(o - from, d, one, r2).Concat(Quadric(o - b, d, one, r2));
        if (length2.Sign == 0) return all;

        // Without their parts along the axis, the points of the side are those of a ball.
        FixedVector across = Across(o - from), acrossD = Across(d);
        return all.Concat(Quadric(across, acrossD, one, r2).Where(c => IsBeside(o + d * c.T)));

        FixedVector Across(FixedVector v) => v - axis * (FixedVector.Dot(v, axis) / length2);
        bool IsBeside(FixedVector p)
        {
            Fixed along = FixedVector.Dot(p - from, axis);
            return along.Sign >= 0 && along <= length2;
        }
    }
}

internal sealed class EllipsoidReference(Double3 radii) : RayBodyReference
{
    public override IEnumerable<Crossing> Crossings(FixedVector o, FixedVector d)
    {
        FixedVector r = radii, one = new Double3(1, 1, 1);
        foreach (Crossing c in Quadric(FixedVector.Divide(o, r), FixedVector.Divide(d, r), one, 1.0))
            yield return c with { Normal = FixedVector.Divide(c.Normal, r) };
    }
}

internal sealed class CylinderReference(double radius, double half) : RayBodyReference
{
    public override IEnumerable<Crossing> Crossings(FixedVector o, FixedVector d)
    {
        Fixed r2 = (Fixed)radius * radius;
        return Quadric(o, d, new Double3(1, 0, 1), r2).Where(c => Fixed.Abs((o + d * c.T).Y) <= half)
            .Concat(Level(o, d, half, 1.0).Concat(Level(o, d, -half, -1.0)).Where(c => IsOver(o + d * c.T)));
        bool IsOver(FixedVector p) => p.X * p.X + p.Z * p.Z <= r2;
    }
}

internal sealed class ConeReference(double radius, double half) : RayBodyReference
{
    public override IEnumerable<Crossing> Crossings(FixedVector o, FixedVector d)
    {
        Fixed r2 = (Fixed)radius * radius, k = (Fixed)radius / (2 * half);
        var apex = new FixedVector(0.0, half, 0.0);
        return Quadric(o - apex, d, new(1.0, -(k * k), 1.0), 0.0).Where(c => Fixed.Abs((o + d * c.T).Y) <= half)
            .Concat(Level(o, d, -half, -1.0).Where(c => IsOver(o + d * c.T)));
        bool IsOver(FixedVector p) => p.X * p.X + p.Z * p.Z <= r2;
    }
}

/// <summary>The hull of a few points: every plane through three of them that has all others on one side.</summary>
internal sealed class PolytopeReference : RayBodyReference
{
    private readonly List<(FixedVector Normal, Fixed Offset)> _planes = [];

    public PolytopeReference(Double3[] corners)
    {
        FixedVector[] p = [.. corners.Select(v => (FixedVector)v)];
        for (int i = 0; i < p.Length; i++)
            for (int j = 0; j < p.Length; j++)
                for (int k = 0; k < p.Length; k++)
                    if (i < j && i < k && j != k) Try(p, p[i], FixedVector.Cross(p[j] - p[i], p[k] - p[i]));
    }

    public override IEnumerable<Crossing> Crossings(FixedVector o, FixedVector d)
    {
        foreach ((FixedVector normal, Fixed offset) in _planes)
        {
            Fixed slope = FixedVector.Dot(normal, d);
            if (slope.Sign == 0) continue;
            Fixed t = (offset - FixedVector.Dot(normal, o)) / slope;
            FixedVector p = o + d * t;
            if (_planes.All(q => FixedVector.Dot(q.Normal, p) - q.Offset <= Slack(q.Normal)))
                yield return new(t, normal);
        }
    }

    /// <summary>What the division that found the point can have moved it by, along a normal.</summary>
    private static Fixed Slack(FixedVector normal) =>
        Fixed.Tiny * (1.0 + Fixed.Abs(normal.X) + Fixed.Abs(normal.Y) + Fixed.Abs(normal.Z));

    private void Try(FixedVector[] points, FixedVector on, FixedVector normal)
    {
        if (FixedVector.Dot(normal, normal).Sign == 0) return;
        Fixed offset = FixedVector.Dot(normal, on);
        if (points.All(q => FixedVector.Dot(normal, q) <= offset)) _planes.Add((normal, offset));
    }
}
