using Gjk.Core;

namespace Gjk.Unity
{
    /// <summary>
    /// A shape and where it is: what <see cref="ConvexQuery"/> takes for one of its two sides. Immutable.
    /// </summary>
    public readonly struct PosedShape
    {
        /// <summary>The shape in its own frame. Every scale is in it.</summary>
        public readonly ConvexShape Shape;

        /// <summary>The frame in the world: a rotation and a position.</summary>
        public readonly RigidPose Pose;

        /// <summary>Puts a shape somewhere.</summary>
        public PosedShape(in ConvexShape shape, in RigidPose pose)
        {
            Shape = shape;
            Pose = pose;
        }
    }
}
