using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Colliders and meshes as shapes of the library, where their transforms put them.</summary>
    /// <remarks>For the main thread only, as all of the engine's objects are. Box, sphere and capsule take no memory; a
    /// mesh builds its hull the first time, or the tree of its triangles where it is not convex, and keeps it as long
    /// as the mesh lives and stays as it is. Skew, negative, uneven and zero scales are honoured as the engine does: a
    /// mesh goes through the whole matrix, the others follow lossyScale.</remarks>
    public static class GjkShapes
    {
        /// <summary>The shape of a collider: box, sphere, capsule, mesh, terrain or character controller.</summary>
        /// <param name="collider">It may be disabled. A mesh must be readable. With Convex ticked, its convex hull is
        /// meant; without, a mesh that is not convex is the surface of its triangles.</param>
        /// <param name="isSolid">Whether closed meshes are meant with what they enclose.</param>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        /// <exception cref="ArgumentException">It has no shape; the message names the object and says why.</exception>
        public static PosedShape From(Collider collider, bool isSolid = false) =>
            From((Component)collider, isSolid);

        /// <summary>The shape of a mesh that is shown.</summary>
        /// <param name="filter">Its mesh must be readable.</param>
        /// <param name="isSolid">Whether closed meshes are meant with what they enclose.</param>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        /// <exception cref="ArgumentException">It has no shape; the message names the object and says why.</exception>
        public static PosedShape From(MeshFilter filter, bool isSolid = false) =>
            From((Component)filter, isSolid);

        /// <summary>The shape of a collider or mesh filter.</summary>
        /// <param name="source">The collider or mesh filter.</param>
        /// <param name="isSolid">Whether closed meshes are meant with what they enclose.</param>
        /// <inheritdoc cref="From(Collider, bool)" path="/exception"/>
        public static PosedShape From(Component source, bool isSolid = false)
        {
            if (TryFrom(source, out PosedShape posed, out string reason, isSolid)) return posed;
            throw Refused(source, reason, nameof(source));
        }

        /// <summary>The shape of a collider or mesh filter as if its transform were somewhere else in the world; the
        /// scale stays.</summary>
        /// <param name="source">The collider or mesh filter.</param>
        /// <param name="position">Instead of the transform's position.</param>
        /// <param name="rotation">Instead of the transform's rotation; of unit length.</param>
        /// <param name="isSolid">Whether closed meshes are meant with what they enclose.</param>
        /// <inheritdoc cref="From(Collider, bool)" path="/exception"/>
        public static PosedShape From(
            Component source, Vector3 position, Quaternion rotation, bool isSolid = false)
        {
            if (source == null) throw new ArgumentNullException(nameof(source));
            TransformFrame.Of(source.transform, out TransformFrame frame);
            frame.Turn = new Turn(rotation);
            frame.Position = new Double3(position.x, position.y, position.z);
            if (TryFrom(source, frame, isSolid, out PosedShape posed, out string reason)) return posed;
            throw Refused(source, reason, nameof(source));
        }

        /// <summary>The shape of a collider or mesh filter, or why there is none.</summary>
        /// <param name="source">The collider or mesh filter.</param>
        /// <param name="posed">The shape and its pose.</param>
        /// <param name="reason">Null, or one sentence that names the object.</param>
        /// <param name="isSolid">Whether closed meshes are meant with what they enclose.</param>
        public static bool TryFrom(
            Component source, out PosedShape posed, out string reason, bool isSolid = false)
        {
            if (source == null)
            {
                posed = default;
                reason = "There is no collider, or it was destroyed.";
                return false;
            }

            TransformFrame.Of(source.transform, out TransformFrame frame);
            return TryFrom(source, frame, isSolid, out posed, out reason);
        }

        /// <summary>Forgets the hull of a mesh. Changed vertices are noticed without, but for few of many: of a mesh of
        /// more than 1,024 vertices every n-th is compared. So is a change of the number of indices, but not of their
        /// order.</summary>
        public static void Forget(Mesh mesh) => MeshHulls.Forget(mesh);

#if GJK_TERRAIN
        /// <summary>Forgets the surface of a terrain. Call it after changing its heights or holes.</summary>
        public static void Forget(TerrainData terrain) => TerrainSurfaces.Forget(terrain);
#endif

        private static bool TryFrom(
            Component source, in TransformFrame frame, bool isSolid, out PosedShape posed, out string reason)
        {
            posed = default;
            reason = ShapeReader.Read(source, frame.Stretch, isSolid, out LocalShape local);
            if (reason != null) return false;
            if (!frame.TryPose(local, out RigidPose pose))
            {
                reason = "'" + source.name + "' is not at a finite position.";
                return false;
            }

            posed = local.At(pose);
            return true;
        }

        private static ArgumentException Refused(Component source, string reason, string name) =>
            source == null ? new ArgumentNullException(name, reason) : new ArgumentException(reason, name);
    }
}
