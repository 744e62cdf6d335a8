namespace Gjk.Core.Tests.Contacts;

/// <summary>A level wheel that crosses a triangle's edge at a small angle rests on the face as far as that is under it,
/// and beyond on the edge.</summary>
public class WheelAlongEdgeTests
{
    private const float Reach = 0.01f, Radius = 0.3f;

    [Theory]
    [InlineData("cylinder")]
    [InlineData("capsule")]
    public void TheLineOfTouchHasBothEnds(string kind)
    {
        int over = 0, crossing = 0, renamed = 0, count = 4000;
        for (int seed = 0; seed < count; seed++)
        {
            var scene = new Crossing(seed, kind);
            if (scene.From >= scene.To) continue;
            over++;
            ContactManifold m = Ask(scene.Triangle, RigidPose.Identity, scene.Wheel, scene.Pose);
            ContactManifold swapped = Ask(scene.Wheel, scene.Pose, scene.Triangle, RigidPose.Identity);
            string record = $"{seed}, {scene}: {m}";
            Assert.True(m.Count == swapped.Count, $"{record}, but {swapped}");
            AssertTrue(scene, m, record);
            if (scene.IsCrossing) crossing++;
            AssertHasEnd(scene, m, scene.From, scene.BeyondFrom, record);
            AssertHasEnd(scene, m, scene.To, scene.BeyondTo, record);

            // A rounding moves no name, but where an end is as far from a corner as names reach.
            RigidPose near = new(scene.Pose.Rotation, scene.Pose.Position + new Vector3(1e-6f, 0, -1e-6f));
            if (!Names(m).SequenceEqual(Names(Ask(scene.Triangle, RigidPose.Identity, scene.Wheel, near)))) renamed++;
        }

        Assert.InRange(over, 0.5 * count, count);
        Assert.InRange(crossing, 0.5 * over, over);
        Assert.InRange(renamed, 0, 0.01 * over);
    }

    private static IEnumerable<long> Names(ContactManifold m) =>
        Enumerable.Range(0, m.Count).Select(i => m[i].FeatureId);

    private static ContactManifold Ask(ConvexShape a, RigidPose poseA, ConvexShape b, RigidPose poseB)
    {
        ConvexQuery.Contacts(a, poseA, b, poseB, Reach, out ContactManifold m);
        return m;
    }

    /// <summary>No point lies off the triangle, and each has the gap of the wheel over it.</summary>
    private static void AssertTrue(in Crossing scene, in ContactManifold m, string record)
    {
        Assert.True(m.Count > 0, record);
        for (int i = 0; i < m.Count; i++)
        {
            double off = Math.Max(0, Crossing.Outside(m[i].PointA)), across = scene.Across(m[i].PointA);
            double gap = Radius - Math.Sqrt(Radius * Radius - across * across) - scene.Depth;
            Assert.True(off < 2e-6 && Math.Abs(m[i].PointA.Y) < 1e-6, $"{record}: {i} is off the triangle");
            Assert.True(Math.Abs(m[i].Gap - gap) < 3e-6, $"{record}: {i} has a gap of {gap}");
        }
    }

    /// <summary>There is a point at an end of what is over the face; or, where the line leaves it over the edge, one as
    /// far as edge and wheel go on.</summary>
    private static void AssertHasEnd(
        in Crossing scene, in ContactManifold m, double end, double beyond, string record)
    {
        double within = 0.02 * scene.Length, most = double.PositiveInfinity, depth = 0;
        for (int i = 0; i < m.Count; i++)
        {
            double off = Math.Abs(scene.Along(m[i].PointA) - beyond);
            if (off >= most) continue;
            (most, depth) = (off, -m[i].Gap);
        }

        Assert.True(most <= within, $"{record}: nothing at {beyond}");
        if (end == beyond) Assert.True(Math.Abs(depth - scene.Depth) < 3e-6, $"{record}: {depth} deep at {end}");
    }

    /// <summary>A wheel over the triangle (0, 0), (0, -1), (1, -1) of x and z, whose axis is turned by 1e-7 to 0.05
    /// against the edge x = 0.</summary>
    private readonly struct Crossing
    {
        public readonly ConvexShape Triangle, Wheel;
        public readonly RigidPose Pose;
        public readonly double Depth, Half;

        /// <summary>Along the axis: what is over the face, and where edge and wheel end on that side.</summary>
        public readonly double From, To, BeyondFrom, BeyondTo;

        public readonly bool IsCrossing;
        private readonly Vector3 _axis;
        private readonly double _angle;

        public Crossing(int seed, string kind)
        {
            var random = new Rng((ulong)seed);
            this = default;
            Half = random.Float(0.05, 0.5);
            _angle = Math.Pow(10, random.Float(-7, -1.302)) * (random.OneIn(2) ? -1 : 1);
            Depth = random.Of(3e-4f, -1e-3f, 1e-5f);
            Triangle = ConvexShape.Triangle(Vector3.Zero, new Vector3(1, 0, -1), new Vector3(0, 0, -1));
            Wheel = kind == "capsule"
                ? ConvexShape.Capsule(Radius, (float)Half)
                : ConvexShape.Cylinder(Radius, (float)Half);
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, (float)_angle)
                * Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
            double z = random.Float(-1.2, 0.2), x = Math.Sin(_angle) * random.Float(-1.2, 1.2) * Half;
            Pose = new RigidPose(turn, new Vector3((float)x, (float)(Radius - Depth), (float)z));
            Depth = Radius - (double)Pose.Position.Y;
            _axis = Vector3.Transform(Vector3.UnitY, turn);

            // The line is cut by z = -1, by x + z = 0, and by x = 0, which it leaves over the edge.
            (double from, double to) = (-Half, Half);
            Cut(Pose.Position.Z + 1, _axis.Z, ref from, ref to);
            Cut(-Pose.Position.X - Pose.Position.Z, -_axis.X - _axis.Z, ref from, ref to);
            (From, To) = (from, to);
            Cut(Pose.Position.X, _axis.X, ref from, ref to);
            IsCrossing = to - from > 0.05 * Half && to - from < 0.95 * (To - From);
            double edgeFrom = -Half, edgeTo = Half;
            Cut(Pose.Position.Z + 1, _axis.Z, ref edgeFrom, ref edgeTo);
            Cut(-Pose.Position.Z, -_axis.Z, ref edgeFrom, ref edgeTo);
            BeyondFrom = from > From ? Math.Max(edgeFrom, From) : from;
            BeyondTo = to < To ? Math.Min(edgeTo, To) : to;
            (From, To) = to - from > 0.05 * Half ? (from, to) : (1, 0);
        }

        public double Length => Math.Max(To - From, BeyondTo - BeyondFrom);

        public double Along(Vector3 point) => Vector3.Dot(point - Pose.Position, _axis);

        public double Across(Vector3 point)
        {
            Vector3 from = point - Pose.Position;
            return (double)from.X * _axis.Z - (double)from.Z * _axis.X;
        }

        public static double Outside(Vector3 p) => Math.Max(-p.X, Math.Max(-1 - p.Z, (p.X + p.Z) / Math.Sqrt(2)));

        public override string ToString() => $"half {Half}, angle {_angle}, at {Pose.Position}, over {From} to {To}";

        /// <summary>Keeps of a line where something that changes along it is positive.</summary>
        private static void Cut(double start, double change, ref double from, ref double to)
        {
            double at = -start / change;
            if (change > 0) from = Math.Max(from, at);
            else if (change < 0) to = Math.Min(to, at);
            else if (start < 0) (from, to) = (1, 0);
        }
    }
}
