using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>Meshes as a modelling program makes them: corners repeated for each face.</summary>
    public static class TestMeshes
    {
        private static readonly int[] Quad = { 0, 1, 2, 0, 2, 3 };

        /// <summary>A leaning block with a smaller top, off its origin: no symmetry hides a fault.</summary>
        public static Mesh Block() => Cuboid(new Vector3(0.3f, -0.2f, 0.1f), new Vector3(0.15f, 0, -0.05f), 0.5f);

        public static Mesh Cube() => Cuboid(Vector3.zero, Vector3.zero, 1);

        /// <summary>A cube with a five-sided top: its middle is lifted by a height, which is negative in a dented
        /// one.</summary>
        public static Mesh Roof(float height)
        {
            Mesh mesh = Cube();
            Vector3[] vertices = new Vector3[mesh.vertexCount + 12];
            mesh.vertices.CopyTo(vertices, 0);
            int[] triangles = new int[30 + 12];
            int at = 0, next = mesh.vertexCount;
            int[] all = mesh.triangles;
            for (int i = 0; i < all.Length; i += 3)
            {
                Vector3 a = vertices[all[i]], b = vertices[all[i + 1]], c = vertices[all[i + 2]];
                if (a.y > 0 && b.y > 0 && c.y > 0) continue;
                for (int k = 0; k < 3; k++) triangles[at++] = all[i + k];
            }

            var top = new Vector3(0, 0.5f + height, 0);
            for (int side = 0; side < 4; side++)
            {
                vertices[next] = top;
                vertices[next + 1] = Corner(side);
                vertices[next + 2] = Corner(side + 1);
                for (int k = 0; k < 3; k++) triangles[at++] = next++;
            }

            mesh.vertices = vertices;
            mesh.triangles = Outward(vertices, triangles, Vector3.zero);
            return mesh;
        }

        /// <summary>All wound so that their normals lead away from a point inside, as modelling programs do.</summary>
        private static int[] Outward(Vector3[] vertices, int[] triangles, Vector3 inside)
        {
            for (int i = 0; i < triangles.Length; i += 3)
            {
                Vector3 a = vertices[triangles[i]];
                Vector3 u = vertices[triangles[i + 1]] - a, v = vertices[triangles[i + 2]] - a;
                var normal = new Vector3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
                if (Vector3.Dot(normal, a - inside) < 0)
                    (triangles[i], triangles[i + 1]) = (triangles[i + 1], triangles[i]);
            }

            return triangles;
        }

        private static Vector3 Corner(int side)
        {
            int k = side % 4;
            return new Vector3(k == 0 || k == 3 ? 0.5f : -0.5f, 0.5f, k < 2 ? 0.5f : -0.5f);
        }

        /// <summary>The top is scaled and shifted, which leaves all faces flat.</summary>
        private static Mesh Cuboid(Vector3 center, Vector3 shift, float top)
        {
            var vertices = new Vector3[24];
            var triangles = new int[36];
            for (int face = 0; face < 6; face++)
            {
                int axis = face / 2, sign = face % 2 == 0 ? 1 : -1;
                for (int k = 0; k < 4; k++)
                {
                    float u = k == 0 || k == 3 ? 0.5f : -0.5f, v = k < 2 ? 0.5f : -0.5f;
                    Vector3 p = axis == 0 ? new Vector3(0.5f * sign, u, v)
                        : axis == 1 ? new Vector3(u, 0.5f * sign, v) : new Vector3(u, v, 0.5f * sign);
                    if (p.y > 0) p = new Vector3(p.x * top, p.y, p.z * top) + shift;
                    vertices[4 * face + k] = p + center;
                }

                for (int k = 0; k < 6; k++) triangles[6 * face + k] = 4 * face + Quad[k];
            }

            triangles = Outward(vertices, triangles, center);
            return new Mesh { name = "test mesh", vertices = vertices, triangles = triangles };
        }
    }
}
