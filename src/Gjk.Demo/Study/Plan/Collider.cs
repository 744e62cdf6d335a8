using Gjk.Demo.View;

namespace Gjk.Demo.Study.Plan;

/// <summary>The simple shapes that games put around a mesh: each holds the whole shape, in the shape's own
/// frame.</summary>
internal static class Collider
{
    public const string Names = "box, sphere, capsule, or hull with 4 to 256 directions, such as \"hull 16\"";

    private const string Hull = "hull ";

    /// <summary>The golden angle in radians. Directions that turn by it spread evenly.</summary>
    private static readonly double GoldenAngle = Math.PI * (3 - Math.Sqrt(5));

    public static bool IsKnown(string name) =>
        name is "box" or "sphere" or "capsule" || Directions(name) is >= 4 and <= 256;

    /// <summary>The collider of a name for which <see cref="IsKnown"/> is true.</summary>
    public static ConvexShape Of(ConvexShape shape, string name)
    {
        if (name.StartsWith(Hull, StringComparison.Ordinal)) return HullOf(shape, Directions(name));
        Vector3 high = Ends(shape, 1), low = Ends(shape, -1);
        Vector3 center = (low + high) / 2, half = (high - low) / 2;
        var place = new RigidPose(center);
        List<Vector3> points = SupportSamples.Of(shape, isCoarse: true);
        switch (name)
        {
            case "box":
                return ConvexShape.Box(half).Placed(place);
            case "sphere":
                return ConvexShape.Sphere(points.Max(p => Vector3.Distance(p, center))).Placed(place);
            default:
                float radius = points.Max(p => Across(p - center));
                float halfHeight = points.Max(
                    p => MathF.Abs(p.Y - center.Y) - MathF.Sqrt(
                        MathF.Max(0, radius * radius - Square(Across(p - center)))));
                return ConvexShape.Capsule(radius, MathF.Max(halfHeight, 0)).Placed(place);
        }
    }

    private static int Directions(string name) =>
        name.StartsWith(Hull, StringComparison.Ordinal)
        && int.TryParse(name.AsSpan(Hull.Length), NumberStyles.None, CultureInfo.InvariantCulture, out int n) ? n : 0;

    /// <summary>The distance from the y axis.</summary>
    private static float Across(Vector3 v) => MathF.Sqrt(v.X * v.X + v.Z * v.Z);

    private static float Square(float x) => x * x;

    private static Vector3 Ends(in ConvexShape shape, int sign) => new(
        (float)SupportSamples.Support(shape, new Double3(sign, 0, 0)).X,
        (float)SupportSamples.Support(shape, new Double3(0, sign, 0)).Y,
        (float)SupportSamples.Support(shape, new Double3(0, 0, sign)).Z);

    /// <summary>The hull of the furthest points in directions that spread evenly.</summary>
    private static ConvexShape HullOf(in ConvexShape shape, int directions)
    {
        var corners = new Vector3[directions];
        for (int i = 0; i < directions; i++)
        {
            double y = 1 - 2 * (i + 0.5) / directions, ring = Math.Sqrt(1 - y * y);
            (double sin, double cos) = Math.SinCos(i * GoldenAngle);
            corners[i] = (Vector3)SupportSamples.Support(shape, new Double3(ring * cos, y, ring * sin));
        }

        return ConvexShape.Mesh(corners);
    }
}
