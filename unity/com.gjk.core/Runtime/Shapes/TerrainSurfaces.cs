#if GJK_TERRAIN
using System.Runtime.CompilerServices;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>The surfaces of terrains, made once for each: two triangles between four heights, none where there is a
    /// hole.</summary>
    internal static class TerrainSurfaces
    {
        private static ConditionalWeakTable<TerrainData, TriangleMesh> _known =
            new ConditionalWeakTable<TerrainData, TriangleMesh>();

        /// <summary>The surface in the terrain's frame, or null where it has no triangle.</summary>
        public static TriangleMesh Find(TerrainData data)
        {
            if (_known.TryGetValue(data, out TriangleMesh known)) return known;
            int side = data.heightmapResolution;
            if (side < 2) return null;
            float[,] heights = data.GetHeights(0, 0, side, side);
            bool[,] isGround = data.GetHoles(0, 0, side - 1, side - 1);
            Vector3 size = data.size;
            var points = new Numerics.Vector3[side * side];
            for (int i = 0; i < points.Length; i++)
            {
                int x = i % side, z = i / side;
                points[i] = new Numerics.Vector3(
                    x * size.x / (side - 1), heights[z, x] * size.y, z * size.z / (side - 1));
            }

            if (!TriangleMesh.TryCreate(points, Triangles(isGround, side), out TriangleMesh made, out _)) return null;
            _known.Add(data, made);
            return made;
        }

        public static void Forget(TerrainData data) => _known.Remove(data);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Reset() => _known = new ConditionalWeakTable<TerrainData, TriangleMesh>();

        private static int[] Triangles(bool[,] isGround, int side)
        {
            int count = 0;
            foreach (bool isSolid in isGround) count += isSolid ? 6 : 0;
            var triangles = new int[count];
            for (int z = 0, next = 0; z < side - 1; z++)
            {
                for (int x = 0; x < side - 1; x++)
                {
                    if (!isGround[z, x]) continue;
                    int corner = z * side + x;
                    triangles[next++] = corner;
                    triangles[next++] = corner + side;
                    triangles[next++] = corner + side + 1;
                    triangles[next++] = corner;
                    triangles[next++] = corner + side + 1;
                    triangles[next++] = corner + 1;
                }
            }

            return triangles;
        }
    }
}
#endif
