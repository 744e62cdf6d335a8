namespace Gjk.Core.Diagnostics;

/// <summary>Two posed shapes as <see cref="AnswerCheck"/> sees them, with a composition of its own: in the world's
/// axes, B measured from A, in double, with a bound for all that rounding does to a support.</summary>
internal struct PosedPair
{
    /// <summary>Ratio to the shapes' sizes: 48 roundings. A matrix of quotients is off by 12 as a map, which counts
    /// once, since a direction goes in and a point comes out by the same one; the two ways through it cost 16 more, and
    /// the choice of the furthest point 8, of 36. Pinned by AnswerBoundTests.</summary>
    private const double TurnError = 48 * RoundOff.Unit;

    /// <summary>Ratio to the lengths that are added: 16 roundings, of which sums take 4, a dot product 3 and a weighted
    /// mean 6. Pinned by AnswerBoundTests.</summary>
    private const double SumError = 16 * RoundOff.Unit;

    /// <summary>Ratio of the centres' distances from their local origins to the sizes: beyond it the centres are placed
    /// in double-double, so that their offset is no part of the error. Pinned by AnswerBoundTests.</summary>
    private const double FarCenter = 4;

    /// <summary>Ratio to the offset of centres that were placed in double-double, which loses some 2^-100.</summary>
    private const double FarError = 1.0 / (1L << 45) / (1L << 45);

    private RowMatrix _a, _b;

    /// <summary>Lengths that are turned, and lengths that are added, of which nothing need be left.</summary>
    private double _turned, _added;

    /// <summary>From A's centre to B's.</summary>
    public Double3 Between;

    /// <summary>A way that B is swept along: the shape is all that it passes.</summary>
    public Double3 Sweep;

    /// <summary>Both margins.</summary>
    public double Margins;

    /// <summary>Both radii about the centres, margins included.</summary>
    public double Size;

    /// <summary>Whether a shape has no vertices.</summary>
    public bool IsCurved;

    /// <summary>What rounding can do to a point of B less one of A, and to its height along a direction.</summary>
    public double Noise;

    /// <summary>False for what no query accepts.</summary>
    public readonly bool IsValid => Noise >= 0 && Noise <= double.MaxValue && Margins >= 0 && Size >= 0;

    /// <summary>Composes a pair.</summary>
    public static void Of<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out PosedPair pair)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 centerA = a.Center, centerB = b.Center;
        pair = default;
        pair.Noise = double.NaN;
        pair._a = new RowMatrix(poseA.Rotation);
        pair._b = new RowMatrix(poseB.Rotation);
        pair.Size = Radius(ref a) + Radius(ref b);
        pair.Margins = a.Margin + b.Margin;
        if (!(pair.Size >= 0 && poseA.IsValid && poseB.IsValid)) return;
        pair.IsCurved = !a.TryGetVertex(0, out _) || !b.TryGetVertex(0, out _);
        double offset = centerA.SumOfMagnitudes + centerB.SumOfMagnitudes;
        bool isFar = offset > FarCenter * pair.Size;
        pair._turned = pair.Size + (isFar ? FarError / TurnError * offset : offset);
        pair.Between = isFar
            ? (Double3)(VectorDD.ToWorld(poseB, centerB) - VectorDD.ToWorld(poseA, centerA))
            : (Double3)poseB.Position - poseA.Position + pair._b.Out(centerB) - pair._a.Out(centerA);
        pair.Measure();
    }

    /// <summary>A shape and a point in its local frame.</summary>
    public static void OfPoint<T>(ref T shape, in Double3 local, out PosedPair pair)
        where T : struct, ISupportMap
    {
        pair = default;
        pair._a = pair._b = new RowMatrix(Quaternion.Identity);
        pair.Size = pair._turned = Radius(ref shape);
        pair.Margins = shape.Margin;
        pair.Between = local - shape.Center;
        pair.Measure();
    }

    /// <summary>The same with B moved, and swept along a way from there on.</summary>
    public readonly PosedPair Moved(in Double3 by, in Double3 sweep = default)
    {
        PosedPair moved = this;
        moved._added += Between.SumOfMagnitudes + by.SumOfMagnitudes;
        moved.Between += by;
        moved.Sweep = sweep;
        moved.Measure();
        return moved;
    }

    /// <summary>The direction of a vector; false where it has none.</summary>
    public static bool TryUnit(in Double3 vector, out Double3 unit)
    {
        double one = 1 / vector.Length;
        unit = vector * one;
        return one > 0 && one <= double.MaxValue;
    }

    /// <summary>How far apart the planes across a unit direction stand that touch A and B; negative where they reach
    /// past each other.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="unit">From A to B.</param>
    /// <param name="vertex">The point of B less that of A, both without margins, that lie in the planes.</param>
    public readonly double Gap<TA, TB>(ref TA a, ref TB b, in Double3 unit, out Double3 vertex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        a.Support(_a.In(unit), out Double3 onA);
        b.Support(_b.In(-unit), out Double3 onB);
        vertex = Between + (_b.Out(onB) - _a.Out(onA));
        if (Double3.Dot(unit, Sweep) < 0) vertex += Sweep;
        return Double3.Dot(unit, vertex) - Margins;
    }

    /// <summary>From a local point of A to one of B.</summary>
    public readonly Double3 Way<TA, TB>(ref TA a, in Double3 localA, ref TB b, in Double3 localB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Between + (_b.Out(localB - b.Center) - _a.Out(localA - a.Center));

    /// <summary>A local point of A in the world.</summary>
    public readonly Double3 WorldOfA(in Double3 local, in RigidPose poseA) => _a.Out(local) + poseA.Position;

    /// <summary>A local point of B in the world.</summary>
    public readonly Double3 WorldOfB(in Double3 local, in RigidPose poseB) => _b.Out(local) + poseB.Position;

    /// <summary>A point of the world in A's local frame.</summary>
    public readonly Double3 LocalToA(in Double3 world, in RigidPose poseA) => _a.In(world - poseA.Position);

    /// <summary>The same for B.</summary>
    public readonly Double3 LocalToB(in Double3 world, in RigidPose poseB) => _b.In(world - poseB.Position);

    private void Measure() => Noise = TurnError * _turned
        + SumError * (_added + Size + Between.SumOfMagnitudes + Sweep.SumOfMagnitudes);

    /// <summary>A user's bounding radius may be generous, and is measured.</summary>
    private static double Radius<T>(ref T shape)
        where T : struct, ISupportMap =>
        ShapeTraits<T>.AreTight || !(shape.BoundingRadius >= 0)
            ? shape.BoundingRadius
            : Math.Min(shape.BoundingRadius, CoreExtent.Radius(ref shape) + shape.Margin);

    /// <summary>A rotation matrix by its rows: quotients of sums of exact products.</summary>
    private readonly struct RowMatrix
    {
        private readonly Double3 _x, _y, _z;

        public RowMatrix(Quaternion q)
        {
            double x = q.X, y = q.Y, z = q.Z, w = q.W, xx = x * x, yy = y * y, zz = z * z, ww = w * w;
            double s = 1 / (xx + yy + zz + ww), t = 2 * s;
            _x = new Double3((ww + xx - (yy + zz)) * s, (x * y - w * z) * t, (x * z + w * y) * t);
            _y = new Double3((x * y + w * z) * t, (ww + yy - (xx + zz)) * s, (y * z - w * x) * t);
            _z = new Double3((x * z - w * y) * t, (y * z + w * x) * t, (ww + zz - (xx + yy)) * s);
        }

        public Double3 Out(in Double3 v) => new(Double3.Dot(_x, v), Double3.Dot(_y, v), Double3.Dot(_z, v));

        public Double3 In(in Double3 v) => _x * v.X + _y * v.Y + _z * v.Z;
    }
}
