using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// Where a shape is: world = Rotation * local + Position. Position is in world units; any finite float is accepted.
/// </summary>
/// <remarks>
/// Immutable. <c>default(RigidPose)</c> has no rotation at all (the zero quaternion) and a query on it returns
/// <see cref="GjkStatus.InvalidInput"/>; use <see cref="Identity"/>.
/// </remarks>
public readonly struct RigidPose : IEquatable<RigidPose>
{
    /// <summary>
    /// How far |q| may be from 1 (a pure number). It admits what a chain of float products drifts to and refuses what
    /// was never meant as a rotation. Pinned by RigidPoseTests.
    /// </summary>
    internal const double UnitTolerance = 1e-3;

    /// <summary>The squares of the shortest and the longest quaternion that is accepted.</summary>
    internal const double MinSquaredNorm = (1 - UnitTolerance) * (1 - UnitTolerance);

    /// <inheritdoc cref="MinSquaredNorm"/>
    internal const double MaxSquaredNorm = (1 + UnitTolerance) * (1 + UnitTolerance);

    /// <summary>
    /// The rotation, kept as given. It need not be of unit length to the last bit: every query divides by its squared
    /// length in double.
    /// </summary>
    public readonly Quaternion Rotation;

    /// <summary>The world position of the local origin.</summary>
    public readonly Vector3 Position;

    /// <summary>Makes a pose.</summary>
    /// <param name="rotation">A quaternion whose length is within 1e-3 of 1.</param>
    /// <param name="position">Finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A component is NaN or infinite, or the quaternion is not of unit length.
    /// </exception>
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

    /// <summary>Exact equality of all seven numbers (q and -q are the same rotation but not equal here).</summary>
    public static bool operator ==(in RigidPose a, in RigidPose b) =>
        a.Rotation == b.Rotation && a.Position == b.Position;

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
        string position = ((Vector3D)Position).ToString("G9");
        return Rotation == Quaternion.Identity
            ? position
            : FormattableString.Invariant(
                $"{position}, rotation ({Rotation.X:G9}, {Rotation.Y:G9}, {Rotation.Z:G9}, {Rotation.W:G9})");
    }

    /// <summary>
    /// False for what no constructor made: a <c>default</c> struct, or one whose bytes were overwritten.
    /// </summary>
    internal bool IsValid => IsRotation(Rotation) && Guard.IsFinite(Position);

    /// <summary>Whether a quaternion of this squared length counts as a rotation; false for NaN.</summary>
    internal static bool IsUnit(double squaredNorm) => squaredNorm >= MinSquaredNorm && squaredNorm <= MaxSquaredNorm;

    private static bool IsRotation(Quaternion q) =>
        IsUnit((double)q.X * q.X + (double)q.Y * q.Y + (double)q.Z * q.Z + (double)q.W * q.W);
}
