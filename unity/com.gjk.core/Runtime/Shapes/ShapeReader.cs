using System;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>Reads colliders and mesh filters by the engine's own rules.</summary>
    /// <remarks>Box: the size times the absolute lossyScale. Sphere: the radius times the largest absolute scale.
    /// Capsule: the radius times the larger of the two absolute scales across, the height times the one along; a height
    /// below two radii is a sphere. Mesh: every vertex through the whole matrix, skew included. Centres go through the
    /// whole matrix. A scale of 0 flattens; the shape may become a polygon, a segment or a point. CharacterController:
    /// a capsule along the world's y, its radius times the larger of the absolute scales along x and z, its height
    /// times that along y; its skin is no part of it. Terrain: its heights, where they are in the world; it neither
    /// turns nor scales. GjkHalfSpace: it turns, and does not scale.</remarks>
    internal static class ShapeReader
    {
        private static readonly double HalfRoot = Math.Sqrt(0.5);

        /// <summary>Whether components of its kind can have a shape.</summary>
        public static bool IsKnown(Component source) =>
            source is BoxCollider || source is SphereCollider || source is CapsuleCollider || source is MeshCollider
#if GJK_TERRAIN
            || source is TerrainCollider
#endif
            || source is CharacterController || source is MeshFilter || source is GjkHalfSpace;

        /// <summary>Null, or why there is no shape, in one sentence that names the object.</summary>
        public static string Read(Component source, in Stretch stretch, bool isSolid, out LocalShape local)
        {
            local = default;
            local.Turn = Turn.None;
            switch (source)
            {
                case BoxCollider box:
                    return Read(box, stretch, ref local);
                case SphereCollider sphere:
                    return Read(sphere, stretch, ref local);
                case CapsuleCollider capsule:
                    return Read(capsule, stretch, ref local);
                case CharacterController character:
                    return Read(character, stretch, ref local);
                case MeshCollider collider:
                    return Read(collider, collider.sharedMesh, collider.convex, isSolid, stretch, ref local);
                case MeshFilter filter:
                    return Read(filter, filter.sharedMesh, false, isSolid, stretch, ref local);
                case GjkHalfSpace _:
                    local.Shape = ConvexShape.HalfSpace(Numerics.Vector3.UnitY, 0);
                    return null;
#if GJK_TERRAIN
                case TerrainCollider terrain:
                    return Read(terrain, ref local);
#endif
                default:
                    return Text(source, "is a " + source.GetType().Name + ", which has no shape here; box, sphere, "
                        + "capsule, mesh and terrain colliders, character controllers and half-spaces have one.");
            }
        }

        private static string Read(BoxCollider box, in Stretch stretch, ref LocalShape local)
        {
            Vector3 size = box.size;
            var half = new Numerics.Vector3(
                (float)(Math.Abs(size.x) * stretch.Along(0) * 0.5), (float)(Math.Abs(size.y) * stretch.Along(1) * 0.5),
                (float)(Math.Abs(size.z) * stretch.Along(2) * 0.5));
            if (!IsFinite(half)) return NotFinite(box);
            local.Shape = ConvexShape.Box(half);
            return Place(box, box.center, stretch, ref local);
        }

        private static string Read(SphereCollider sphere, in Stretch stretch, ref LocalShape local)
        {
            double scale = Math.Max(stretch.Along(0), Math.Max(stretch.Along(1), stretch.Along(2)));
            var radius = (float)(Math.Abs(sphere.radius) * scale);
            if (!IsFinite(radius)) return NotFinite(sphere);
            local.Shape = ConvexShape.Sphere(radius);
            return Place(sphere, sphere.center, stretch, ref local);
        }

        private static string Read(CapsuleCollider capsule, in Stretch stretch, ref LocalShape local)
        {
            int axis = capsule.direction;
            double across = Math.Max(stretch.Along((axis + 1) % 3), stretch.Along((axis + 2) % 3));
            double radius = Math.Abs(capsule.radius) * across;
            double half = Math.Max(Math.Abs(capsule.height) * stretch.Along(axis) * 0.5 - radius, 0);
            if (!IsFinite((float)radius) || !IsFinite((float)half)) return NotFinite(capsule);
            if ((float)half > 0)
            {
                local.Shape = ConvexShape.Capsule((float)radius, (float)half);

                // The library's capsule lies along y: a quarter turn about z brings it to x, one about x to z.
                if (axis == 0) local.Turn = new Turn(0, 0, -HalfRoot, HalfRoot);
                if (axis == 2) local.Turn = new Turn(HalfRoot, 0, 0, HalfRoot);
            }
            else
            {
                local.Shape = ConvexShape.Sphere((float)radius);
            }

            return Place(capsule, capsule.center, stretch, ref local);
        }

        private static string Read(CharacterController character, in Stretch stretch, ref LocalShape local)
        {
            double radius = Math.Abs(character.radius) * Math.Max(stretch.Along(0), stretch.Along(2));
            double half = Math.Max(Math.Abs(character.height) * stretch.Along(1) * 0.5 - radius, 0);
            if (!IsFinite((float)radius) || !IsFinite((float)half)) return NotFinite(character);
            local.Shape = (float)half > 0
                ? ConvexShape.Capsule((float)radius, (float)half) : ConvexShape.Sphere((float)radius);
            local.IsUpright = true;
            return Place(character, character.center, stretch, ref local);
        }

        private static string Read(
            Component source, Mesh mesh, bool isHullMeant, bool isSolid, in Stretch stretch, ref LocalShape local)
        {
            if (mesh == null) return Text(source, "has no mesh.");
            string reason = MeshHulls.Find(mesh, out MeshHull entry);
            if (reason == null && (isHullMeant || entry.IsConvex(mesh)))
                reason = entry.TryStretch(stretch, out local.Shape) ? null : "is scaled beyond float.";
            else if (reason == null)
                reason = entry.TryStretch(mesh, stretch, out local.Mesh) ? null : "is scaled beyond float.";
            local.IsSolid = isSolid && local.Mesh != null && local.Mesh.HasInside;
            return reason == null ? null : Text(source, "cannot be used: the mesh '" + mesh.name + "' " + reason);
        }

#if GJK_TERRAIN
        private static string Read(TerrainCollider terrain, ref LocalShape local)
        {
            if (terrain.terrainData == null) return Text(terrain, "has no terrain data.");
            local.Mesh = TerrainSurfaces.Find(terrain.terrainData);
            local.IsUpright = true;
            return local.Mesh != null ? null : Text(terrain, "has no heights, or only holes.");
        }
#endif

        private static string Place(Component source, Vector3 center, in Stretch stretch, ref LocalShape local)
        {
            local.Offset = stretch.Apply(new Double3(center.x, center.y, center.z));
            return local.Offset.IsFinite ? null : NotFinite(source);
        }

        private static string NotFinite(Component source) => Text(source, "has a size that is not finite.");

        private static string Text(Component source, string fault) =>
            "'" + source.name + "' (" + source.GetType().Name + ") " + fault;

        private static bool IsFinite(float x) => x - x == 0;

        private static bool IsFinite(Numerics.Vector3 v) => IsFinite(v.X) && IsFinite(v.Y) && IsFinite(v.Z);
    }
}
