using Gjk.Core;

namespace Gjk.Unity
{
    /// <summary>A shape with its scale, and its place in the rigid frame of its transform.</summary>
    internal struct LocalShape
    {
        public ConvexShape Shape;

        /// <summary>The triangles of a shape that is not convex, else null.</summary>
        public TriangleMesh Mesh;

        public bool IsSolid;
        public Double3 Offset;
        public Turn Turn;

        /// <summary>Whether it keeps the axes of the world, however its transform is turned.</summary>
        public bool IsUpright;

        public readonly PosedShape At(in RigidPose pose) =>
            Mesh is null ? new PosedShape(Shape, pose) : new PosedShape(Mesh, IsSolid, pose);
    }
}
