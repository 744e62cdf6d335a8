namespace Gjk.Core;

/// <summary>One body of a <see cref="PairMotion"/>: its rotation at any fraction, and how far it reaches from its
/// pivot, the point of it that moves along a straight line.</summary>
/// <remarks>The pivot is the body's position, or its centre where it does not turn: then its centre moves straight too,
/// and the body reaches less far from it.</remarks>
internal struct TurningBody
{
    /// <summary>Radians per fraction 1, about the axes of the world.</summary>
    public Double3 AngularVelocity;

    /// <summary>From the pivot to the centre, in the body's axes.</summary>
    public Double3 Offset;

    /// <summary>Upper bound of the distance from the pivot to a point of the core.</summary>
    public double Reach;

    /// <summary>Upper bound of the distance from the axis to a point of the core.</summary>
    public double ReachAcross;

    /// <summary>2 / |q|² of the rotation.</summary>
    public double Scale;

    private QuaternionD _start;
    private Double3 _axis;
    private double _rate;

    /// <summary>Upper bounds of how far the core reaches from the pivot along the axis and against it.</summary>
    private double _most, _least;

    /// <summary>Whether it turns at all.</summary>
    public readonly bool IsTurning => _rate > 0;

    /// <summary>Radians per fraction 1.</summary>
    public readonly double Rate => _rate;

    public static void Make(
        in RigidMotion motion, in QuaternionD? core, in Double3 center, double coreRadius, out TurningBody body)
    {
        body._start = core is null ? motion.Pose.Rotation : motion.Pose.Rotation * core.Value;
        body.Scale = 2 / body._start.LengthSquared;
        body.AngularVelocity = motion.AngularVelocity;
        body._rate = body.AngularVelocity.Length;
        body._axis = body._rate > 0 ? body.AngularVelocity * (1 / body._rate) : default;
        body.Offset = body._rate > 0 ? center : default;
        body.Reach = body.ReachAcross = body._most = body._least = body.Offset.Length + coreRadius;
    }

    /// <summary>The rotation at a fraction, as long as the one at the start.</summary>
    public readonly QuaternionD At(double fraction) =>
        _rate > 0 ? QuaternionD.About(_axis, _rate * fraction) * _start : _start;

    /// <summary>Upper bound of how far the core reaches from the pivot in a direction, however it has turned.</summary>
    /// <param name="direction">In the world's axes, of unit length.</param>
    public readonly double SweptReach(in Double3 direction)
    {
        double along = Double3.Dot(direction, _axis);
        double across = Math.Sqrt(Math.Max(direction.LengthSquared - along * along, 0));
        return across * ReachAcross + (along > 0 ? along * _most : -along * _least);
    }

    /// <summary>Measures how far the core reaches from the axis and along it.</summary>
    /// <param name="shape">The body's.</param>
    /// <param name="directions">How many supports are asked for around the axis: the reach is up to 2% too large for
    /// 16, 0.1% for 64.</param>
    public void Measure<T>(ref T shape, int directions)
        where T : struct, ISupportMap
    {
        if (!IsTurning) return;
        RotationD.Set(out RotationD rotation, _start.X, _start.Y, _start.Z, _start.W, Scale);
        Double3 axis = rotation.InverseRotate(_axis);
        _most = Math.Min(_most, Along(ref shape, axis));
        _least = Math.Min(_least, Along(ref shape, -axis));
        var across = new PlaneBasis(axis);
        double furthest = 0, half = Math.PI / directions;
        for (int i = 0; i < directions; i++)
        {
            SineCosine.Compute(2 * half * i, out double sine, out double cosine);
            furthest = Math.Max(furthest, Along(ref shape, across.U * cosine + across.V * sine));
        }

        // No point is more than half of the angle between two directions away from one of them.
        SineCosine.Compute(half, out _, out double nearest);
        ReachAcross = Math.Min(ReachAcross, furthest / nearest);
    }

    /// <summary>The same body in other units.</summary>
    public void Resize(double factor)
    {
        Offset *= factor;
        Reach *= factor;
        ReachAcross *= factor;
        _most *= factor;
        _least *= factor;
    }

    /// <summary>How far the core reaches from the pivot in a direction of its own axes.</summary>
    private readonly double Along<T>(ref T shape, in Double3 direction)
        where T : struct, ISupportMap
    {
        shape.Support(direction, out Double3 point);
        return Double3.Dot(direction, point + Offset);
    }
}
