using System;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>
    /// Reads colliders and mesh filters by the engine's own rules.
    /// </summary>
    /// <remarks>
    /// Box: the size times the absolute lossyScale. Sphere: the radius times the largest absolute scale. Capsule: the
    /// radius times the larger of the two absolute scales across, the height times the one along; a height below two
    /// radii is a sphere. Mesh: every vertex through the whole matrix, skew included. Centres go through the whole
    /// matrix. A scale of 0 flattens; the shape may become a polygon, a segment or a point.
    /// </remarks>
    internal static class ShapeReader
    {
        private static readonly double HalfRoot = Math.Sqrt(0.5);

        /// <summary>Null, or why there is no shape, in one sentence that names the object.</summary>
        public static string Read(Component source, in Stretch stretch, out LocalShape local)
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
                case MeshCollider collider:
                    return Read(collider, collider.sharedMesh, collider.convex, stretch, ref local);
                case MeshFilter filter:
                    return Read(filter, filter.sharedMesh, false, stretch, ref local);
                default:
                    return Text(source, "is a " + source.GetType().Name + ", which has no convex shape; box, sphere, "
                        + "capsule and mesh colliders have one.");
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

        private static string Read(
            Component source, Mesh mesh, bool isHullMeant, in Stretch stretch, ref LocalShape local)
        {
            if (mesh == null) return Text(source, "has no mesh.");
            string reason = MeshHulls.Find(mesh, out MeshHull entry);
            if (reason == null && !isHullMeant) reason = entry.WhyConcave(mesh);
            if (reason == null) reason = entry.TryStretch(stretch, out local.Shape) ? null : "is scaled beyond float.";
            return reason == null ? null : Text(source, "cannot be used: the mesh '" + mesh.name + "' " + reason);
        }

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
