namespace Gjk.Core;

/// <summary>Where a shape's core is in the shape's frame: the poses that it was placed at, one after the other,
/// composed in double. Queries add it to the pair's poses, and ask the core in its own axes. Immutable.</summary>
/// <remarks>The core's centre is placed in double-double and its rounding error is kept, so a shape placed far from the
/// local origin loses no accuracy.</remarks>
internal sealed class Placement
{
    /// <summary>Ratio: 32 u, more than a rotation in double can lengthen a vector by: 26 u at most
    /// (proofs/placed.g).</summary>
    private const double RoundingUp = 1 + 32 * RoundOff.Unit;

    /// <summary>Of a shape that is asked in the axes of its core.</summary>
    public static readonly Placement None = new(RigidPose.Identity, null, default);

    /// <summary>The pose that the shape was placed at last.</summary>
    public readonly RigidPose Pose;

    /// <summary>The poses before that one.</summary>
    public readonly Placement? Before;

    /// <summary>The rotation of the core: as exact as it was given, and of unit length.</summary>
    public readonly QuaternionD Rotation, UnitRotation;

    /// <summary>The core's centre in the shape's frame, and in the core's axes.</summary>
    public readonly Double3 Center, CenterInCore;

    private readonly RotationD _matrix;
    private readonly Double3 _centerError;
    private readonly double _errorLength;

    public Placement(in RigidPose pose, Placement? before, in Double3 coreCenter)
    {
        Pose = pose;
        Before = before;
        Rotation = before is null ? pose.Rotation : pose.Rotation * before.UnitRotation;
        UnitRotation = Rotation * (1 / Math.Sqrt(Rotation.LengthSquared));
        _matrix = new RotationD(Rotation);
        VectorDD center = VectorDD.ToWorld(pose, before is null ? coreCenter : before.ExactCenter);
        Center = (Double3)center;
        _centerError = (Double3)(center - Center);
        _errorLength = _centerError.Length;
        CenterInCore = (Double3)VectorDD.Rotate(Rotation.Conjugate, center);
    }

    /// <summary>The core's centre in the shape's frame.</summary>
    public VectorDD ExactCenter => (VectorDD)Center + _centerError;

    /// <summary>The bounding radius of the placed shape.</summary>
    public double Radius(double coreRadius, double margin) =>
        (coreRadius == margin ? coreRadius : coreRadius * RoundingUp) + _errorLength;

    /// <summary>A direction of the shape's frame, in the core's axes.</summary>
    public Double3 Inward(in Double3 direction) => _matrix.InverseRotate(DirectionRange.ToSafe(direction));

    /// <summary>A point of the core, measured from <see cref="Center"/> in the shape's frame.</summary>
    public Double3 Outward(in Double3 point) => _matrix.Rotate(point) + _centerError;

    /// <summary>The face of a core, asked in its own axes.</summary>
    public unsafe void GetFace<T>(in T core, in Double3 direction, ref FaceCorners corners)
        where T : struct, ISupportMap
    {
        OuterFrame turned = default;
        OuterFrame* around = corners.Outer;
        if (around != null)
        {
            turned = around->Turned(_matrix);
            corners.Outer = &turned;
        }

        core.GetFace(Inward(direction), ref corners);
        corners.Outer = around;
        for (int i = 0; i < corners.Count; i++) corners[i] = Outward(corners[i]);
    }

    /// <summary>What a ray sees of a core, moved to where it is in the shape's frame.</summary>
    /// <returns>False where it is turned already.</returns>
    public bool TryPlace(ref ShapeForm form)
    {
        form.Center = Center;
        form.CenterError = _matrix.Rotate(form.CenterError) + _centerError;
        return form.Rotate(Rotation);
    }

    /// <summary>Whether both place equal cores at the same poses.</summary>
    public static bool AreEqual(Placement? a, Placement? b) =>
        ReferenceEquals(a, b)
        || (a is not null && b is not null && a.Pose == b.Pose && AreEqual(a.Before, b.Before));
}
