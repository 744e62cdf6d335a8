namespace Gjk.Core;

/// <summary>
/// One body of a <see cref="PairMotion"/>: its rotation at any fraction, and how far it reaches from its pivot, the
/// point of it that moves along a straight line.
/// </summary>
/// <remarks>
/// The pivot is the body's position, or its centre where it does not turn: then its centre moves straight too, and the
/// body reaches less far from it.
/// </remarks>
internal struct TurningBody
{
    /// <summary>Radians per fraction 1, about the axes of the world.</summary>
    public Vector3D Turn;

    /// <summary>From the pivot to the centre, in the body's axes.</summary>
    public Vector3D Offset;

    /// <summary>Upper bound of the distance from the pivot to a point of the core.</summary>
    public double Reach;

    /// <summary>Upper bound of the distance from the axis to a point of the core.</summary>
    public double ReachAcross;

    /// <summary>2 / |q|² of the rotation.</summary>
    public double Scale;

    private QuaternionD _start;
    private Vector3D _axis;
    private double _rate;

    /// <summary>Whether it turns at all.</summary>
    public readonly bool IsTurning => _rate > 0;

    /// <summary>Radians per fraction 1.</summary>
    public readonly double Rate => _rate;

    public static void Begin(
        in RigidMotion motion, in Vector3D center, double coreRadius, out TurningBody body)
    {
        body._start = motion.Pose.Rotation;
        body.Scale = 2 / body._start.LengthSquared;
        body.Turn = motion.AngularVelocity;
        body._rate = body.Turn.Length;
        body._axis = body._rate > 0 ? body.Turn * (1 / body._rate) : default;
        body.Offset = body._rate > 0 ? center : default;
        body.Reach = body.ReachAcross = body.Offset.Length + coreRadius;
    }

    /// <summary>The rotation at a fraction, as long as the one at the start.</summary>
    public readonly QuaternionD At(double fraction) =>
        _rate > 0 ? QuaternionD.About(_axis, _rate * fraction) * _start : _start;

    /// <summary>Measures how far the core reaches from the axis, by its local bounding box.</summary>
    public void Measure<T>(ref T shape)
        where T : struct, ISupportMap
    {
        if (!IsTurning) return;
        CoreExtent.Box(ref shape, out Vector3D min, out Vector3D max);
        var rotation = default(RotationD);
        RotationD.Set(out rotation, _start.X, _start.Y, _start.Z, _start.W, Scale);
        Vector3D axis = rotation.InverseRotate(_axis);
        double squared = 0;
        for (int i = 0; i < 8; i++)
        {
            var corner = new Vector3D(
                (i & 1) == 0 ? min.X : max.X, (i & 2) == 0 ? min.Y : max.Y, (i & 4) == 0 ? min.Z : max.Z);
            squared = System.Math.Max(squared, Vector3D.Cross(axis, corner + Offset).LengthSquared);
        }

        ReachAcross = System.Math.Min(ReachAcross, System.Math.Sqrt(squared));
    }

    /// <summary>The same body in other units.</summary>
    public void Resize(double factor)
    {
        Offset *= factor;
        Reach *= factor;
        ReachAcross *= factor;
    }
}
