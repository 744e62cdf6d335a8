using System;
using System.Linq;
using Gjk.Core;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>
/// In no direction, of any length, does a shape's support value differ from the greatest dot product with the points that it was made of; of curved shapes, from the
/// formula. The support point is one of those points, to the last bit, and is the vertex that its id names.
/// </summary>
internal sealed class SupportsReachTheCloud : IPromise
{
    public string Name => "a support is the furthest point of the cloud";

    public string? Broken(FuzzPair pair)
    {
        ulong seed = BitConverter.DoubleToUInt64Bits(pair.PoseB.Position.X) + BitConverter.DoubleToUInt64Bits(pair.PoseB.Position.Y);
        return Problem(pair.A, pair.BodyA, seed, "A") ?? Problem(pair.B, pair.BodyB, seed + 1, "B");
    }

    private static string? Problem(in ConvexShape shape, PosedShape body, ulong seed, string name)
    {
        foreach (Vector3D d in SupportDirections.Of(body, seed))
        {
            if (d == default || !d.IsFinite) continue;
            int id = shape.Support(d, -1, out Vector3D point);
            string? problem = body.IsCurved ? OffTheFormula(body, d, point) : OffTheCloud(body, d, point) ?? OfAnotherName(shape, id, point);
            if (problem is not null) return Say.Line($"towards ({d.X:R}, {d.Y:R}, {d.Z:R}) {name} gives ({point.X:R}, {point.Y:R}, {point.Z:R}): {problem}");
        }

        return null;
    }

    private static string? OffTheCloud(PosedShape body, in Vector3D d, in Vector3D point)
    {
        Vector3D unit = Normal(d), p = point;
        if (!body.Vertices.Any(v => v == p)) return "no point of the cloud";
        double highest = body.CoreHeight(unit), height = Vector3D.Dot(unit, point - body.Center);
        return height >= highest - Rounding(body, unit) ? null : Say.Line($"lower than the highest point by {highest - height}");
    }

    private static string? OffTheFormula(PosedShape body, in Vector3D d, in Vector3D point)
    {
        Vector3D unit = Normal(d);
        double off = Vector3D.Dot(unit, point) - body.CoreHeight(unit);
        return Math.Abs(off) <= Rounding(body, unit) ? null : Say.Line($"off the formula's height by {off}");
    }

    private static string? OfAnotherName(in ConvexShape shape, int id, in Vector3D point) =>
        shape.TryGetVertex(id, out Vector3D vertex) && vertex == point ? null : Say.Line($"vertex {id} is ({vertex.X:R}, {vertex.Y:R}, {vertex.Z:R})");

    /// <summary>What the roundings of a dot product with a point of the shape, seen from its centre, come to.</summary>
    private static double Rounding(PosedShape body, in Vector3D unit) =>
        Accuracy.Rounding * 0.5 * (Math.Abs(unit.X) * body.Sides.X + Math.Abs(unit.Y) * body.Sides.Y + Math.Abs(unit.Z) * body.Sides.Z);

    /// <summary>Brought near unit length by a power of two, which rounds nothing but what is far below the rest.</summary>
    private static Vector3D Normal(in Vector3D d)
    {
        int exponent = -Math.ILogB(Math.Max(Math.Abs(d.X), Math.Max(Math.Abs(d.Y), Math.Abs(d.Z))));
        return new Vector3D(Math.ScaleB(d.X, exponent), Math.ScaleB(d.Y, exponent), Math.ScaleB(d.Z, exponent));
    }
}
