namespace Gjk.Core;

/// <summary>What is asked of a pair of shapes, or of the cores that they are unwrapped to.</summary>
internal interface IPairQuestion
{
    /// <summary>Asks, and keeps the answer.</summary>
    void Ask<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;
}
