using System;
using Gjk.Core;

namespace Gjk.Unity
{
    /// <summary>A shape and where it is: what <see cref="ConvexQuery"/> or <see cref="ConcaveQuery"/> takes for one of
    /// its two sides. Immutable.</summary>
    public readonly struct PosedShape
    {
        /// <summary>The shape in its own frame, every scale in it; a <c>default</c> struct where it is not
        /// convex.</summary>
        public readonly ConvexShape Shape;

        /// <summary>The frame in the world: a rotation and a position.</summary>
        public readonly RigidPose Pose;

        /// <summary>The triangles of a shape that is not convex, every scale in them, else null.</summary>
        public readonly TriangleMesh Mesh;

        private readonly bool _isSolid;

        /// <summary>Puts a shape somewhere.</summary>
        public PosedShape(in ConvexShape shape, in RigidPose pose)
        {
            Shape = shape;
            Pose = pose;
            Mesh = null;
            _isSolid = false;
        }

        /// <summary>Puts triangles somewhere.</summary>
        /// <param name="mesh">The triangles.</param>
        /// <param name="isSolid">Whether what they enclose belongs to the shape; they must be closed then.</param>
        /// <param name="pose">Where they are.</param>
        /// <exception cref="ArgumentException">There are none, or they are asked to be solid and are open.</exception>
        public PosedShape(TriangleMesh mesh, bool isSolid, in RigidPose pose)
        {
            if (mesh is null) throw new ArgumentNullException(nameof(mesh));
            if (isSolid && !mesh.HasInside) throw new ArgumentException(mesh.WhyNoInside, nameof(mesh));
            Shape = default;
            Pose = pose;
            Mesh = mesh;
            _isSolid = isSolid;
        }

        /// <summary>Whether <see cref="Shape"/> is all of it.</summary>
        public bool IsConvex => Mesh is null;

        /// <summary>The shape, convex or not.</summary>
        public AnyShape Any =>
            Mesh is null ? AnyShape.Of(Shape) : _isSolid ? AnyShape.Solid(Mesh) : AnyShape.Surface(Mesh);

        /// <summary>The same shape somewhere else.</summary>
        public PosedShape At(in RigidPose pose) =>
            Mesh is null ? new PosedShape(Shape, pose) : new PosedShape(Mesh, _isSolid, pose);

        /// <summary>Whether the other has the same shape, wherever it is.</summary>
        internal bool HasShapeOf(in PosedShape other) =>
            Mesh is null ? other.Mesh is null && Shape == other.Shape
                : ReferenceEquals(Mesh, other.Mesh) && _isSolid == other._isSolid;
    }
}
