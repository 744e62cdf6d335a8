using Gjk.Core.Tests.Support.Rays;

namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Rays against a reference that computes with 640 digits: outcome, distance and normal, on random and on hard
/// rays.</summary>
public class RayAccuracyTests
{
    private const int Count = 60;

    public static TheoryData<string> Kinds => [.. RayShapes.Kinds];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void RandomRaysAreExact(string kind) => Each(kind, 11, Vector3.One, (rng, s, pose) =>
        Aimed(rng, s, pose, rng.Range(0, 4)), 0.25);

    /// <summary>From up to a million sizes away: the ray is a line long before it is near.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void FarOriginsLoseNothing(string kind) => Each(kind, 2, Vector3.One, (rng, s, pose) =>
        Aimed(rng, s, pose, rng.LogFloat(10, 1e6)), 0.2);

    /// <summary>As far as 1e12 sizes; the direction's own rounding makes most of them miss.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void VeryFarOriginsLoseNothing(string kind) => Each(kind, 3, Vector3.One, (rng, s, pose) =>
        Axial(rng, s, rng.LogFloat(1e6, 1e12)), 0.2, still: true);

    /// <summary>Past the surface by 1e-3 to 1e-8 of the size, on either side.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void GrazingRaysAreExact(string kind) => Each(kind, 4, Vector3.One, Grazing, 0.2);

    [Theory]
    [MemberData(nameof(Kinds))]
    public void NeedlesAndPlatesAreExact(string kind)
    {
        // Few of these rays hit a hull: by 1e-3 of the length they pass far beside it.
        double least = kind is "hull" or "triangleHull" ? 0 : 0.1;
        Each(kind, 5, new Vector3(1e-3f, 1, 1e-3f), Grazing, least);
        Each(kind, 6, new Vector3(1, 1e-3f, 1), Grazing, least);
        Each(kind, 7, new Vector3(1e-3f, 1, 1e-3f), (rng, s, pose) => Aimed(rng, s, pose, 3), 0);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void UnevenAndNegativeScalesAreExact(string kind) => Each(kind, 8, Vector3.One, Grazing, 0.2, Factors);

    [Theory]
    [MemberData(nameof(Kinds))]
    public void AnySizeIsExact(string kind)
    {
        foreach (float size in new[] { 1e-30f, 1e-12f, 1e12f, 1e30f })
            Each(kind, 9, new Vector3(size), Grazing, 0.2);
    }

    /// <summary>Origins in the shape and just beside it.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void NearOriginsAreExact(string kind) => Each(kind, 10, Vector3.One, (rng, s, pose) =>
        Aimed(rng, s, pose, rng.Range(-0.3, 0.6)), 0.05);

    private delegate (Vector3 Origin, Vector3 Direction) RayMaker(Rng rng, RayShape shape, RigidPose pose);

    /// <param name="kind">Of the shapes.</param>
    /// <param name="family">A number for the seeds.</param>
    /// <param name="size">Of the shapes, by axis.</param>
    /// <param name="make">The rays.</param>
    /// <param name="least">The part of the rays that hit at least; they miss as often at least.</param>
    /// <param name="factors">The scale, if there is one.</param>
    /// <param name="still">Whether the shape is not moved.</param>
    private static void Each(
        string kind, int family, Vector3 size, RayMaker make, double least, Func<Rng, Vector3>? factors = null,
        bool still = false)
    {
        int hits = 0, misses = 0, count = Budget.Count(Count);
        for (int i = 0; i < count; i++)
        {
            ulong seed = (ulong)(1000 * family + i);
            var rng = new Rng(seed);
            RayShape shape = RayShapes.Make(rng, kind, size);
            if (factors is not null) shape = RayShapes.Scaled(shape, factors(rng));
            RigidPose pose = still
                ? RigidPose.Identity
                : Generators.Pose(rng, rng.Vector(-1, 1) * (float)shape.Scale);
            (Vector3 origin, Vector3 direction) = make(rng, shape, pose);
            CastStatus status = Check($"seed {seed}: {shape.Text}", shape, pose, origin, direction);
            if (status == CastStatus.Hit) hits++;
            if (status == CastStatus.Miss) misses++;
        }

        Assert.True(hits >= least * count && misses >= 0.02 * count, $"{kind}: {hits} hits, {misses} misses");
    }

    private static CastStatus Check(
        string name, RayShape shape, in RigidPose pose, Vector3 origin, Vector3 direction)
    {
        RayCastResult r = ConvexQuery.RayCast(shape.Shape, pose, origin, direction);
        TrueHit t = shape.Cast(pose, origin, direction, double.PositiveInfinity);
        string text = $"{name} at {TestShape.T(pose)} from {origin} along {direction}: {r}, truly {t}";
        if (IsFree(shape, t, r)) return CastStatus.None;
        Assert.True(r.Status == t.Status, text);
        CheckExit(text, shape, pose, origin, direction, t);
        if (r.Status != CastStatus.Hit) return r.Status;
        Assert.True(r.Iterations == 0, text);
        Assert.True(Math.Abs(r.Distance - t.Distance) <= 1e-7 * Math.Max(shape.Scale, t.Distance), text);
        if (t.IsNormalUnique) Assert.True(((Double3)r.Normal - t.Normal).Length <= 1e-6, text);
        return r.Status;
    }

    /// <summary>The ray leaves where the reference has the end of the chord, along the normal there.</summary>
    private static void CheckExit(
        string text, RayShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, in TrueHit t)
    {
        RayCastResult end = ConvexQuery.RayExit(shape.Shape, pose, origin, direction);
        text = $"{text}, left by {end}";
        Assert.True(end.Status == (t.Status == CastStatus.Miss ? CastStatus.Miss : CastStatus.Hit), text);
        if (end.Status == CastStatus.Miss) return;
        Assert.True(Math.Abs(end.Distance - t.Exit) <= 1e-7 * Math.Max(shape.Scale, t.Exit), text);
        Double3 along = direction;
        bool isChord = t.Exit - t.Distance > 1e-6 * shape.Scale;
        Assert.True(Double3.Dot(end.Normal, along) >= (isChord ? 0 : -1e-3) * along.Length, text);
        Assert.InRange(end.Normal.Length(), 1 - 1e-6f, 1 + 1e-6f);
    }

    /// <summary>Where either answer is right: the chord is one of a line within 1e-9 of the surface.</summary>
    private static bool IsFree(RayShape shape, in TrueHit t, in RayCastResult r)
    {
        if (r.Status == t.Status) return false;
        bool isSliver = t.Exit - t.Distance <= 1e-9 * shape.Scale;
        bool isAtStart = Math.Min(Math.Abs(t.Distance), Math.Abs(t.Exit)) <= 1e-9 * shape.Scale;
        return !double.IsNaN(t.Distance) && (isSliver || isAtStart);
    }

    /// <summary>At a point in or beside the shape's box, from a distance in its sizes.</summary>
    private static (Vector3 Origin, Vector3 Direction) Aimed(Rng rng, RayShape shape, RigidPose pose, double distance)
    {
        Vector3 direction = rng.UnitVector();
        Vector3 local = (Vector3)CoreMiddle(shape) + Inside(rng, shape);
        Double3 aim = new RotationD(pose.Rotation).Rotate(local) + pose.Position;
        return ((Vector3)(aim - (Double3)direction * (distance * shape.Scale)), direction * rng.LogFloat(1e-3, 1e3));
    }

    /// <summary>Along an axis, which the origin's float coordinates can hold from anywhere.</summary>
    private static (Vector3 Origin, Vector3 Direction) Axial(Rng rng, RayShape shape, float distance)
    {
        Vector3 aim = (Vector3)CoreMiddle(shape) + Inside(rng, shape);
        Vector3 axis = rng.Below(3) switch { 0 => Vector3.UnitX, 1 => -Vector3.UnitY, _ => Vector3.UnitZ };
        aim -= axis * Vector3.Dot(aim, axis);
        return (aim - axis * (distance * (float)shape.Scale), axis * rng.LogFloat(1e-30, 1e30));
    }

    /// <summary>Across the highest point in some direction, a little above or below it.</summary>
    private static (Vector3 Origin, Vector3 Direction) Grazing(Rng rng, RayShape shape, RigidPose pose)
    {
        var body = new RotationD(pose.Rotation);
        Double3 n = rng.UnitVector(), other = rng.UnitVector();
        n *= 1 / n.Length;
        Double3 along = Double3.Cross(n, other);
        along *= 1 / along.Length;
        shape.Shape.Support(body.InverseRotate(n), out Double3 local);
        Double3 top = body.Rotate(local + shape.Shape.Center) + pose.Position + n * shape.Shape.Margin;
        double depth = rng.LogFloat(1e-8, 1e-3) * shape.Scale * (rng.Below(3) == 0 ? 1 : -1);
        double away = rng.Range(0.1, 2) * shape.Scale;
        return ((Vector3)(top + n * depth - along * away), (Vector3)along * rng.LogFloat(1e-3, 1e3));
    }

    private static Vector3 Factors(Rng rng)
    {
        Vector3 factors = rng.Vector(0.2, 3);
        return new(
            rng.Below(2) == 0 ? factors.X : -factors.X, factors.Y, rng.Below(2) == 0 ? factors.Z : -factors.Z);
    }

    private static Double3 CoreMiddle(RayShape shape) => shape.Shape.Center;

    /// <summary>From the middle of the shape's box, in it or a little beside it; nearer where corners are
    /// cut.</summary>
    private static Vector3 Inside(Rng rng, RayShape shape)
    {
        double most = shape.Shape.Kind == ShapeKind.Mesh ? 0.3 : 0.75;
        var body = new Exact.Certificates.Body<ConvexShape>(shape.Shape, RigidPose.Identity);
        return rng.Vector(-most, most) * new Vector3(
            (float)(body.Height(new(1, 0, 0)) + body.Height(new(-1, 0, 0))),
            (float)(body.Height(new(0, 1, 0)) + body.Height(new(0, -1, 0))),
            (float)(body.Height(new(0, 0, 1)) + body.Height(new(0, 0, -1))));
    }
}
