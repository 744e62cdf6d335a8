using System.Collections.Generic;

namespace UnityEngine
{
    public class Collider : Component
    {
        public bool enabled { get; set; } = true;

        public bool isTrigger { get; set; }
    }

    public class CharacterController : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        public float height { get; set; } = 2;

        public float skinWidth { get; set; } = 0.08f;
    }

    public class WheelCollider : Collider
    {
    }

    public class Rigidbody : Component
    {
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
        public TerrainData terrainData { get; set; }
    }

    public sealed class TerrainData : Object
    {
        private float[,] _heights = new float[2, 2];
        private bool[,] _holes;

        public int heightmapResolution => _heights.GetLength(0);

        public Vector3 size { get; set; } = Vector3.one;

        public float[,] GetHeights(int xBase, int yBase, int width, int height) => (float[,])_heights.Clone();

        public bool[,] GetHoles(int xBase, int yBase, int width, int height)
        {
            var all = new bool[height, width];
            for (int y = 0; y < height; y++)
            {
                for (int x = 0; x < width; x++) all[y, x] = _holes is null || _holes[y, x];
            }

            return all;
        }

        public void SetHeights(int xBase, int yBase, float[,] heights) => _heights = (float[,])heights.Clone();

        public void SetHoles(int xBase, int yBase, bool[,] holes) => _holes = (bool[,])holes.Clone();
    }

    public struct Bounds
    {
        public Bounds(Vector3 center, Vector3 size)
        {
            this.center = center;
            this.size = size;
        }

        public Vector3 center { get; set; }

        public Vector3 size { get; set; }
    }

    public sealed class Mesh : Object
    {
        private Vector3[] _vertices = new Vector3[0];
        private int[] _triangles = new int[0];

        public bool isReadable { get; private set; } = true;

        public int vertexCount => _vertices.Length;

        public int subMeshCount { get; set; } = 1;

        // As in the engine, they follow the vertices only when that is asked for.
        public Bounds bounds { get; set; }

        public uint GetIndexCount(int submesh) => (uint)_triangles.Length;

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
