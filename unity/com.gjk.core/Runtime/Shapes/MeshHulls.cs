using System.Runtime.CompilerServices;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>The hulls of meshes, made once for each mesh, and again after it has changed. A mesh that is not used
    /// any more takes its hull with it.</summary>
    internal static class MeshHulls
    {
        private static ConditionalWeakTable<Mesh, MeshHull> _known = new ConditionalWeakTable<Mesh, MeshHull>();

        /// <summary>Null, or what is wrong with the mesh, as the end of a sentence.</summary>
        public static string Find(Mesh mesh, out MeshHull entry)
        {
            if (_known.TryGetValue(mesh, out entry))
            {
                // What cannot be read any more cannot change either.
                if (!mesh.isReadable || MeshPrint.Of(mesh).Equals(entry.Print)) return null;
                _known.Remove(mesh);
            }

            if (!mesh.isReadable) return "is not readable: tick Read/Write in its import settings.";
            Vector3[] vertices = mesh.vertices;
            var points = new Numerics.Vector3[vertices.Length];
            for (int i = 0; i < points.Length; i++) points[i] = vertices[i].ToNumerics();
            if (points.Length == 0) return "has no vertices.";
            if (!ConvexHull.TryCreate(points, out ConvexHull hull, out string reason)) return "is refused: " + reason;
            entry = new MeshHull(hull, MeshPrint.Of(mesh));
            _known.Add(mesh, entry);
            return null;
        }

        public static void Forget(Mesh mesh) => _known.Remove(mesh);

        /// <summary>A project can keep the domain when play begins; then statics must begin anew themselves.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void Reset() => _known = new ConditionalWeakTable<Mesh, MeshHull>();
    }
}
