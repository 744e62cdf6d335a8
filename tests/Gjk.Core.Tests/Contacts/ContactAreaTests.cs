using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>The four points span most of the largest area that four points of the overlap can.</summary>
public class ContactAreaTests
{
    /// <summary>Ratio: an overlap that is narrower for its length is not counted.</summary>
    private const double Narrow = 1e-4;

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void FourPointsSpanFourFifthsOfTheLargestArea(int kind)
    {
        var rng = new Rng((ulong)kind);
        int count = 0;
        double sum = 0;
        for (int i = 0; i < Budget.Few(1500); i++)
        {
            (ConvexShape a, List<Vector2> faceA) = Face(kind, rng);
            (ConvexShape b, List<Vector2> faceB) = i % 6 == 0 ? (a, faceA) : Face(i % 4, rng);
            float turn = i % 4 == 0 ? 0 : rng.Float(0, 6.3), far = i % 3 == 0 ? 0.05f : 0.8f;
            var pose = new RigidPose(
                Quaternion.CreateFromAxisAngle(Vector3.UnitY, turn),
                new Vector3(rng.Float(-far, far), 0.99f, rng.Float(-far, far)));
            List<Vector2> placed =
            [
                .. faceB.Select(p => Vector3.Transform(new Vector3(p.X, 0, p.Y), pose.Rotation) + pose.Position)
                    .Select(p => new Vector2(p.X, p.Z)),
            ];
            List<Vector2> shared = Shared(faceA, placed);
            double length = shared.Count < 3 ? 0 : shared.Max(p => (double)Vector2.DistanceSquared(p, shared[0]));
            if (!(length > 0 && AreaOf(shared) > Narrow * length)) continue;
            ContactManifold m = Ask(a, RigidPose.Identity, b, pose, 0);
            if (m.Normal.Y < 0.999f) continue;
            count++;
            double area = m.Count < 3 ? 0 : Area(m), best = Largest(shared);
            sum += area / best;
            Assert.True(
                area >= 0.8 * best, $"{i}: {area / best:P1} by {m.Count}: {new QueryRecord(a, default, b, pose)}");
        }

        // 85 % at the worst, 99 % on the average.
        Assert.InRange(sum / count, 0.98, 1.0001);
        Assert.InRange(count, 300, int.MaxValue);
    }

    /// <summary>A corner where the edges of both, moved by more than the slack, cross beyond the end of one was left
    /// out, though the other's corner is shared there.</summary>
    [Fact]
    public void AStackOfEqualTrianglesKeepsItsCorners()
    {
        var rng = new Rng(21);
        for (int i = 0; i < Budget.Few(4000); i++)
        {
            Vector3 At() => new(rng.Float(-2, 2), 0, rng.Float(-2, 2));
            Vector3 a = At(), b = At(), c = At(), shift = new(rng.Float(-1e-5, 1e-5), 0, rng.Float(-1e-5, 1e-5));
            if (i == 0)
            {
                a = new Vector3(0.41097903f, 0, 0.39053097f);
                b = new Vector3(-1.3553146f, 0, 1.9364531f);
                c = new Vector3(-0.1687033f, 0, -1.4224898f);
                shift = new Vector3(2.9319588e-7f, 0, 5.7509537e-6f);
            }

            float whole = Vector3.Cross(b - a, c - a).Length() / 2;
            if (whole < 0.05f) continue;
            var triangle = ConvexShape.Triangle(a, b, c);
            ContactManifold m = Ask(triangle, RigidPose.Identity, triangle, new RigidPose(shift));
            Assert.True(m.Count == 3, $"{i}: {m.Count} points of {a}, {b}, {c} moved by {shift}");
            Assert.InRange(Area(m), 0.95f * whole, 1.05f * whole);
        }
    }

    /// <summary>Where the polygon that a disc is shown by shares nothing, one with more corners may.</summary>
    [Fact]
    public void ASmallFaceNearARimHasItsFourCorners()
    {
        ConvexShape disc = ConvexShape.Cylinder(1, 0.5f), box = ConvexShape.Box(new Vector3(0.005f, 0.1f, 0.005f));
        for (int i = 0; i < 64; i++)
        {
            float angle = i == 0 ? MathF.Atan2(0.0975f, 0.9891f) : i * (2 * MathF.PI / 64);
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i == 0 ? 0 : -angle);
            var pose = new RigidPose(turn, new Vector3(0.9937f * MathF.Cos(angle), 0.6f, 0.9937f * MathF.Sin(angle)));
            ContactManifold m = Ask(disc, RigidPose.Identity, box, pose);
            Assert.True(m.Count == 4, $"{i}: {m.Count} points");
            Assert.InRange(Area(m), 0.95e-4f, 1.01e-4f);
        }
    }

    private static (ConvexShape Shape, List<Vector2> Face) Face(int kind, Rng rng)
    {
        float radius = rng.Float(0.1, 1);
        if (kind == 0)
        {
            float x = rng.Float(0.05, 1), z = rng.Float(0.05, 1);
            return (ConvexShape.Box(new Vector3(x, 0.5f, z)), [new(x, z), new(-x, z), new(-x, -z), new(x, -z)]);
        }

        if (kind == 1) return (ConvexShape.Cylinder(radius, 0.5f), Regular(96, radius));
        List<Vector2> face = Regular(3 + rng.Below(60), radius);
        if (kind == 3)
        {
            float width = rng.Float(0.1, 1);
            face = [.. Enumerable.Range(0, 12).Select(_ => rng.Float(0, 6.28)).Order().Select(
                angle => new Vector2(radius * MathF.Cos(angle), width * radius * MathF.Sin(angle)))];
        }

        return (ConvexShape.Mesh(
            [.. face.SelectMany(p => new Vector3[] { new(p.X, 0.5f, p.Y), new(p.X, -0.5f, p.Y) })]), face);
    }

    private static List<Vector2> Regular(int count, float radius) =>
    [
        .. Enumerable.Range(0, count).Select(i => 2 * MathF.PI * i / count)
            .Select(angle => new Vector2(radius * MathF.Cos(angle), radius * MathF.Sin(angle))),
    ];

    /// <summary>Cuts the one by the sides of the other; both run counter-clockwise.</summary>
    private static List<Vector2> Shared(List<Vector2> polygon, List<Vector2> other)
    {
        if (AreaOf(other) < 0) other.Reverse();
        for (int e = 0; e < other.Count && polygon.Count > 0; e++)
        {
            Vector2 from = other[e], to = other[(e + 1) % other.Count];
            List<Vector2> cut = [];
            for (int i = 0; i < polygon.Count; i++)
            {
                Vector2 p = polygon[i], q = polygon[(i + 1) % polygon.Count];
                double inP = Cross(from, to, p), inQ = Cross(from, to, q);
                if (inP >= 0) cut.Add(p);
                if (inP >= 0 != inQ >= 0) cut.Add(p + (q - p) * (float)(inP / (inP - inQ)));
            }

            polygon = cut;
        }

        return polygon;
    }

    /// <summary>Of all four corners, by trying all diagonals.</summary>
    private static double Largest(List<Vector2> p)
    {
        double largest = p.Count == 3 ? AreaOf(p) : 0;
        for (int i = 0; i < p.Count; i++)
        {
            for (int k = i + 2; k < p.Count; k++)
            {
                IEnumerable<double> sides = p.Select(c => Cross(p[i], p[k], c));
                largest = Math.Max(largest, (sides.Max() - sides.Min()) / 2);
            }
        }

        return largest;
    }

    private static double AreaOf(List<Vector2> p) =>
        p.Select((c, i) => Cross(p[0], c, p[(i + 1) % p.Count])).Sum() / 2;

    private static double Cross(Vector2 p, Vector2 q, Vector2 r) =>
        ((double)q.X - p.X) * ((double)r.Y - p.Y) - ((double)q.Y - p.Y) * ((double)r.X - p.X);
}
