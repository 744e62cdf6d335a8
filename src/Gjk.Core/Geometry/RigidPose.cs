namespace Gjk.Core;

/// <summary>Where a shape is: world = Rotation * local + Position. Position is in world units; any finite float is
/// accepted.</summary>
/// <remarks>Immutable. <c>default(RigidPose)</c> has no rotation at all (the zero quaternion) and a query on it returns
/// <see cref="GjkStatus.InvalidInput"/>; use <see cref="Identity"/>.</remarks>
public readonly struct RigidPose : IEquatable<RigidPose>
{
    /// <summary>How far |q| may be from 1 (a pure number). It admits what a chain of float products drifts to and
    /// refuses what was never meant as a rotation. Pinned by RigidPoseTests.</summary>
    internal const double UnitTolerance = 1e-3;

    /// <summary>The squares of the shortest and the longest quaternion that is accepted.</summary>
    internal const double MinSquaredNorm = (1 - UnitTolerance) * (1 - UnitTolerance);

    /// <inheritdoc cref="MinSquaredNorm"/>
    internal const double MaxSquaredNorm = (1 + UnitTolerance) * (1 + UnitTolerance);

    /// <summary>The rotation, kept as given. It need not be of unit length to the last bit: every query divides by its
    /// squared length in double.</summary>
    public readonly Quaternion Rotation;

    /// <summary>The world position of the local origin.</summary>
    public readonly Vector3 Position;

    /// <summary>Makes a pose.</summary>
    /// <param name="rotation">A quaternion whose length is within 1e-3 of 1.</param>
    /// <param name="position">Finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is NaN or infinite, or the quaternion is not of unit
    /// length.</exception>
    public RigidPose(Quaternion rotation, Vector3 position)
    {
        if (!IsRotation(rotation))
            throw new ArgumentOutOfRangeException(
                nameof(rotation), rotation, "The quaternion's length must be within 1e-3 of 1.");
        Rotation = rotation;
        Position = Guard.Finite(position, nameof(position));
    }

    /// <summary>Makes a pose without rotation.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A component is NaN or infinite.</exception>
    public RigidPose(Vector3 position)
        : this(Quaternion.Identity, position)
    {
    }

    /// <summary>No rotation, at the origin.</summary>
    public static RigidPose Identity => new(Quaternion.Identity, Vector3.Zero);

    /// <summary>The world point of a local one, computed in double and rounded to float.</summary>
    public Vector3 TransformPoint(Vector3 local) => (Vector3)(new RotationD(Rotation).Rotate(local) + Position);

    /// <summary>The local point of a world one, computed in double and rounded to float.</summary>
    public Vector3 InverseTransformPoint(Vector3 world) =>
        (Vector3)new RotationD(Rotation).InverseRotate((Double3)world - Position);

    /// <summary>The direction in the world of a local one: turned, not moved, of the same length.</summary>
    public Vector3 TransformDirection(Vector3 local) => (Vector3)new RotationD(Rotation).Rotate(local);

    /// <summary>The local direction of one in the world.</summary>
    public Vector3 InverseTransformDirection(Vector3 world) => (Vector3)new RotationD(Rotation).InverseRotate(world);

    /// <summary>The pose of the world in the local frame. Its rotation is exact, its position rounded to float; one
    /// after the other leaves a point where it is but for rounding.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The position is beyond the range of float.</exception>
    public RigidPose Inverse() => new(
        Quaternion.Conjugate(Rotation), (Vector3)new RotationD(Rotation).InverseRotate(-(Double3)Position));

    /// <summary>Where a child is in the world: its pose in its parent's frame, followed by the parent's; computed in
    /// double and rounded to float.</summary>
    /// <param name="parent">Pose of the parent in the world.</param>
    /// <param name="child">Pose of the child in the parent's frame.</param>
    /// <exception cref="ArgumentOutOfRangeException">The position is beyond the range of float, or one of the poses is
    /// a <c>default</c> struct.</exception>
    public static RigidPose operator *(in RigidPose parent, in RigidPose child)
    {
        QuaternionD q = (QuaternionD)parent.Rotation * child.Rotation;
        double scale = 1 / Math.Sqrt(q.LengthSquared);
        return new RigidPose(
            new Quaternion((float)(q.X * scale), (float)(q.Y * scale), (float)(q.Z * scale), (float)(q.W * scale)),
            parent.TransformPoint(child.Position));
    }

    /// <summary>The pose of a matrix in the order of System.Numerics: row vectors, the position last.</summary>
    /// <param name="matrix">A rotation and a translation, without scale, mirror, shear or projection.</param>
    /// <exception cref="ArgumentException">It is something else: a row is further from unit length, or from a right
    /// angle to the others, than 1e-3, or it is NaN, mirrors or projects.</exception>
    public static RigidPose FromMatrix(in Matrix4x4 matrix)
    {
        var x = new Vector3(matrix.M11, matrix.M12, matrix.M13);
        var y = new Vector3(matrix.M21, matrix.M22, matrix.M23);
        var z = new Vector3(matrix.M31, matrix.M32, matrix.M33);
        float off = Math.Max(Math.Max(Off(x, y, z), Off(y, z, x)), Off(z, x, y));
        bool isAffine = matrix.M14 == 0 && matrix.M24 == 0 && matrix.M34 == 0 && matrix.M44 == 1;
        if (!(off <= UnitTolerance) || !(Math.Abs(x.Length() - 1) <= UnitTolerance) || !isAffine)
            throw new ArgumentException("Must be a rotation and a translation, and nothing else.", nameof(matrix));
        return new RigidPose(Quaternion.Normalize(Quaternion.CreateFromRotationMatrix(matrix)), matrix.Translation);
    }

    /// <summary>Exact equality of all seven numbers (q and -q are the same rotation but not equal here).</summary>
    public static bool operator ==(in RigidPose a, in RigidPose b) =>
        a.Position.X == b.Position.X && a.Position.Y == b.Position.Y && a.Position.Z == b.Position.Z
        && a.Rotation.X == b.Rotation.X && a.Rotation.Y == b.Rotation.Y && a.Rotation.Z == b.Rotation.Z
        && a.Rotation.W == b.Rotation.W;

    /// <summary>The opposite of equality.</summary>
    public static bool operator !=(in RigidPose a, in RigidPose b) => !(a == b);

    /// <inheritdoc/>
    public bool Equals(RigidPose other) => Rotation.Equals(other.Rotation) && Position.Equals(other.Position);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is RigidPose other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Rotation.GetHashCode() * 397 ^ Position.GetHashCode();

    /// <summary>The position, and the rotation (x, y, z, w) where there is one, for people to read.</summary>
    public override string ToString()
    {
        string position = ((Double3)Position).ToText();
        return Rotation == Quaternion.Identity
            ? position
            : FormattableString.Invariant(
                $"{position}, rotation ({Rotation.X:G9}, {Rotation.Y:G9}, {Rotation.Z:G9}, {Rotation.W:G9})");
    }

    /// <summary>False for what no constructor made: a <c>default</c> struct, or one whose bytes were
    /// overwritten.</summary>
    internal bool IsValid => IsRotation(Rotation) && Guard.IsFinite(Position);

    /// <summary>Whether a quaternion of this squared length counts as a rotation; false for NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool IsUnit(double squaredNorm) => squaredNorm >= MinSquaredNorm && squaredNorm <= MaxSquaredNorm;

    /// <summary>How far a row of a matrix is from the cross product of the next two; NaN where one is.</summary>
    private static float Off(Vector3 row, Vector3 next, Vector3 last) => (row - Vector3.Cross(next, last)).Length();

    private static bool IsRotation(in Quaternion q) =>
        IsUnit((double)q.X * q.X + (double)q.Y * q.Y + (double)q.Z * q.Z + (double)q.W * q.W);
}
