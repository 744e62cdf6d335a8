namespace Gjk.Core;

/// <summary>How a shape moves over the fractions from 0 to 1: its position along a straight line, its rotation at a
/// constant rate about that position.</summary>
/// <remarks>At the fraction f the position is Pose.Position + f * Velocity, and the rotation that of the pose, followed
/// by a turn about the world axis AngularVelocity by f * |AngularVelocity| radians. Immutable.
/// <c>default(RigidMotion)</c> has no pose, and a query on it returns <see cref="CastStatus.InvalidInput"/>.</remarks>
public readonly struct RigidMotion
{
    /// <summary>Where the shape is at the fraction 0.</summary>
    public readonly RigidPose Pose;

    /// <summary>World units per fraction 1.</summary>
    public readonly Vector3 Velocity;

    /// <summary>Radians per fraction 1, about the axis through the shape's position; any number of turns.</summary>
    public readonly Vector3 AngularVelocity;

    /// <summary>Makes a motion.</summary>
    /// <param name="pose">Where the shape begins.</param>
    /// <param name="velocity">World units per fraction 1; finite.</param>
    /// <param name="angularVelocity">Radians per fraction 1, in the world's axes; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is NaN or infinite.</exception>
    public RigidMotion(in RigidPose pose, Vector3 velocity, Vector3 angularVelocity = default)
    {
        Pose = pose;
        Velocity = Guard.Finite(velocity, nameof(velocity));
        AngularVelocity = Guard.Finite(angularVelocity, nameof(angularVelocity));
    }

    /// <summary>World units per fraction 1: how a point of the shape moves that is somewhere at a fraction.</summary>
    internal Double3 VelocityOf(in Double3 point, float fraction) => (Double3)Velocity
        + Double3.Cross(AngularVelocity, point - ((Double3)Pose.Position + (Double3)Velocity * fraction));

    internal bool IsValid => Pose.IsValid && Guard.IsFinite(Velocity) && Guard.IsFinite(AngularVelocity);
}
