using System.Collections.Generic;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>By what a changed mesh is known, since the engine counts no versions: the numbers of its vertices and
    /// indices, its bounds, and a hash over its vertices.</summary>
    internal readonly struct MeshPrint
    {
        /// <summary>Count of vertices that are hashed at most, evenly spread: so that a look at a mesh stays in
        /// microseconds. Of a smaller mesh all are. Pinned by MeshTests.AMovedVertexIsNoticed.</summary>
        private const int MostHashed = 1024;

        private static readonly List<Vector3> Vertices = new List<Vector3>();

        private readonly int _vertexCount;
        private readonly uint _hash;
        private readonly long _indexCount;
        private readonly Vector3 _center, _size;

        private MeshPrint(Mesh mesh)
        {
            _vertexCount = mesh.vertexCount;
            _indexCount = 0;
            for (int i = 0; i < mesh.subMeshCount; i++) _indexCount += mesh.GetIndexCount(i);
            _center = mesh.bounds.center;
            _size = mesh.bounds.size;
            mesh.GetVertices(Vertices);
            int step = (_vertexCount + MostHashed - 1) / MostHashed;
            uint hash = 0;
            for (int i = 0; i < Vertices.Count; i += step)
            {
                Vector3 v = Vertices[i];
                hash = Mixed(Mixed(Mixed(hash, v.x), v.y), v.z);
            }

            _hash = hash;
        }

        /// <summary>Of a mesh that is readable. For the main thread.</summary>
        public static MeshPrint Of(Mesh mesh) => new MeshPrint(mesh);

        /// <summary>Brings high bits down, too: coordinates that are all halved change no other ones.</summary>
        private static uint Mixed(uint hash, float x)
        {
            hash = (hash ^ (uint)x.GetHashCode()) * 0x9E3779B1;
            return hash ^ hash >> 15;
        }

        public bool Equals(in MeshPrint other) =>
            _vertexCount == other._vertexCount && _hash == other._hash && _indexCount == other._indexCount
            && _center.Equals(other._center) && _size.Equals(other._size);
    }
}
