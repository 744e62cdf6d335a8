namespace Gjk.Core.Tests.Support;

/// <summary>How far apart two moving shapes are at a fraction, by a plain GJK in double over all parts of each simplex,
/// with poses from a matrix of the axis and the angle: written apart from the library, and slow.</summary>
internal sealed class MotionOracle
{
    private const int MaxRounds = 200;

    private readonly MotionPair _pair;
    private readonly Double3[] _w = new Double3[4];
    private Frame _a, _b;

    public MotionOracle(MotionPair pair) => _pair = pair;

    /// <summary>The distance's bounds: a plane's gap, and the nearest points found; both 0 or less in
    /// contact.</summary>
    public (double Least, double Most) At(double fraction)
    {
        _a = new Frame(_pair.A, _pair.MotionA, default, fraction);
        Double3 between = (Double3)_pair.MotionB.Pose.Position - _pair.MotionA.Pose.Position;
        between += ((Double3)_pair.MotionB.Velocity - _pair.MotionA.Velocity) * fraction;
        _b = new Frame(_pair.B, _pair.MotionB, between, fraction);
        double margins = _a.Margin + _b.Margin, size = _pair.Scale, least = double.NegativeInfinity;
        int count = 0;
        Double3 v = Difference(new Double3(1, 0.3, -0.2));
        double most = v.Length;
        for (int round = 0; round < MaxRounds; round++)
        {
            double length = v.Length;
            if (length <= 1e-13 * size) return (-margins, -margins);
            Double3 w = Difference(-v);
            least = Math.Max(least, Double3.Dot(v, w) / length);
            if (most - least <= 1e-11 * (most + size)) break;
            if (count == 4) break;
            _w[count++] = w;
            if (!Reduce(ref count, out v)) return (-margins, -margins);
            if (v.Length >= most && round > 3) break;
            most = Math.Min(most, v.Length);
        }

        return (least - margins, most - margins);
    }

    /// <summary>The furthest point of A - B in a direction.</summary>
    private Double3 Difference(in Double3 direction) => _a.Support(direction) - _b.Support(-direction);

    /// <summary>Keeps the part of the simplex whose nearest point to the origin is inside it and nearest of all; false
    /// where the whole tetrahedron holds the origin.</summary>
    private bool Reduce(ref int count, out Double3 nearest)
    {
        double best = double.PositiveInfinity;
        int kept = 0;
        nearest = default;
        for (int part = 1; part < 1 << count; part++)
        {
            if (!TryNearest(part, out Double3 p)) continue;
            double squared = p.LengthSquared;
            if (!(squared < best)) continue;
            (best, kept, nearest) = (squared, part, p);
        }

        if (kept == 15) return false;
        int next = 0;
        for (int i = 0; i < count; i++)
        {
            if ((kept & 1 << i) != 0) _w[next++] = _w[i];
        }

        count = next;
        return true;
    }

    private bool TryNearest(int part, out Double3 nearest)
    {
        Span<int> index = stackalloc int[4];
        int n = 0;
        for (int i = 0; i < 4; i++)
        {
            if ((part & 1 << i) != 0) index[n++] = i;
        }

        Double3 o = _w[index[0]];
        nearest = o;
        if (n == 1) return true;
        Double3 e = _w[index[1]] - o;
        if (n == 2)
        {
            double t = -Double3.Dot(o, e) / e.LengthSquared;
            nearest = o + e * t;
            return t >= 0 && t <= 1;
        }

        Double3 f = _w[index[2]] - o, normal = Double3.Cross(e, f);
        if (n == 3)
        {
            double squared = normal.LengthSquared;
            double s = Double3.Dot(Double3.Cross(-o, f), normal) / squared;
            double t = Double3.Dot(Double3.Cross(e, -o), normal) / squared;
            nearest = normal * (Double3.Dot(o, normal) / squared);
            return s >= 0 && t >= 0 && s + t <= 1;
        }

        Double3 g = _w[index[3]] - o;
        double volume = Double3.Dot(normal, g);
        double x = Double3.Dot(Double3.Cross(f, g), -o) / volume;
        double y = Double3.Dot(Double3.Cross(g, e), -o) / volume;
        double z = Double3.Dot(normal, -o) / volume;
        nearest = default;
        return x >= 0 && y >= 0 && z >= 0 && x + y + z <= 1;
    }

    /// <summary>A shape where it is at a fraction, measured from A's position.</summary>
    private readonly struct Frame
    {
        private readonly Double3[]? _points;
        private readonly Double3 _x, _y, _z, _position;
        private readonly TestShape _shape;

        public Frame(TestShape shape, in RigidMotion motion, in Double3 position, double fraction)
        {
            _shape = shape;
            _position = position;
            Quaternion q = motion.Pose.Rotation;
            Double3 omega = motion.AngularVelocity;
            double angle = omega.Length * fraction;
            _x = Turned(Start(q, new Double3(1, 0, 0)), omega, angle);
            _y = Turned(Start(q, new Double3(0, 1, 0)), omega, angle);
            _z = Turned(Start(q, new Double3(0, 0, 1)), omega, angle);
            _points = null;
            Margin = shape.Vertices is null ? shape.Shape.Margin : shape.Margin;
            if (shape.Vertices is { } vertices)
            {
                _points = new Double3[vertices.Length];
                for (int i = 0; i < vertices.Length; i++) _points[i] = Place(vertices[i]);
            }
        }

        public double Margin { get; }

        public Double3 Support(in Double3 direction)
        {
            if (_points is null)
            {
                var local = new Double3(
                    Double3.Dot(direction, _x), Double3.Dot(direction, _y), Double3.Dot(direction, _z));
                _shape.Shape.Support(local, out Double3 point);
                return Place(point + _shape.Shape.Center);
            }

            Double3 best = default;
            double most = double.NegativeInfinity;
            foreach (Double3 p in _points)
            {
                double height = Double3.Dot(p, direction);
                if (height > most) (most, best) = (height, p);
            }

            return best;
        }

        private Double3 Place(in Double3 p) => _position + _x * p.X + _y * p.Y + _z * p.Z;

        /// <summary>q v q* / |q|².</summary>
        private static Double3 Start(Quaternion q, in Double3 v)
        {
            var u = new Double3(q.X, q.Y, q.Z);
            double norm = u.LengthSquared + (double)q.W * q.W;
            return (u * (2 * Double3.Dot(u, v)) + v * ((double)q.W * q.W - u.LengthSquared)
                + Double3.Cross(u, v) * (2.0 * q.W)) * (1 / norm);
        }

        /// <summary>Rodrigues' formula.</summary>
        private static Double3 Turned(in Double3 v, in Double3 omega, double angle)
        {
            double rate = omega.Length;
            if (!(rate > 0)) return v;
            Double3 k = omega * (1 / rate);
            return v * Math.Cos(angle) + Double3.Cross(k, v) * Math.Sin(angle)
                + k * (Double3.Dot(k, v) * (1 - Math.Cos(angle)));
        }
    }
}
