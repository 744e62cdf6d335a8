using System.Collections.Generic;

namespace UnityEngine
{
    public class Collider : Component
    {
        public bool enabled { get; set; } = true;
    }

    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; }

        public Vector3 size { get; set; } = Vector3.one;
    }

    public class SphereCollider : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;
    }

    public class CapsuleCollider : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        public float height { get; set; } = 1;

        public int direction { get; set; } = 1;
    }

    public class MeshCollider : Collider
    {
        public Mesh sharedMesh { get; set; }

        public bool convex { get; set; }
    }

    public class TerrainCollider : Collider
    {
    }

    public sealed class Mesh : Object
    {
        private Vector3[] _vertices = new Vector3[0];
        private int[] _triangles = new int[0];

        public bool isReadable { get; private set; } = true;

        public int vertexCount => _vertices.Length;

        // As in the engine, reading and writing copies.
        public Vector3[] vertices
        {
            get => (Vector3[])_vertices.Clone();
            set => _vertices = (Vector3[])value.Clone();
        }

        public int[] triangles
        {
            get => (int[])_triangles.Clone();
            set => _triangles = (int[])value.Clone();
        }

        public void GetVertices(List<Vector3> vertices)
        {
            vertices.Clear();
            vertices.AddRange(_vertices);
        }

        public void UploadMeshData(bool markNoLongerReadable) => isReadable = !markNoLongerReadable;
    }

    public sealed class MeshFilter : Component
    {
        public Mesh sharedMesh { get; set; }
    }
}
