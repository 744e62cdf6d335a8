using System;
using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>What is kept of a mesh: its hull, whether that is the mesh, its triangles, each stretched.</summary>
    internal sealed class MeshHull
    {
        /// <summary>Ratio to the longest side of the hull: a mesh is concave where its hull reaches further than this
        /// beyond a face. Modelled meshes leave quads a little bent; a thousandth is less than one sees. Pinned by
        /// MeshTests.ASmallDentIsNoConcavity.</summary>
        private const double DentTolerance = 1e-3;

        /// <summary>Count of skewed or flattened copies that are kept of one mesh; when there are more, all are made
        /// anew. Only an uneven scale that is animated above a rotation makes many.</summary>
        private const int MostCopies = 64;

        private readonly ConvexHull _hull;
        private readonly Dictionary<Stretch, ConvexHull> _copies = new Dictionary<Stretch, ConvexHull>();
        private readonly Dictionary<Stretch, TriangleMesh> _surfaces = new Dictionary<Stretch, TriangleMesh>();
        private bool _isConvexityKnown, _isConvex;

        public MeshHull(ConvexHull hull, in MeshPrint print)
        {
            _hull = hull;
            Print = print;
        }

        public ConvexHull Hull => _hull;

        /// <summary>What the mesh was like when the hull was made.</summary>
        public MeshPrint Print { get; }

        /// <summary>Whether the mesh is its hull.</summary>
        public bool IsConvex(Mesh mesh)
        {
            if (!_isConvexityKnown) _isConvex = DeepestDent(mesh) <= DentTolerance * _hull.Bounds.LongestSide;
            _isConvexityKnown = true;
            return _isConvex;
        }

        /// <summary>The triangles under a stretch; false where it leaves float's range.</summary>
        public bool TryStretch(Mesh mesh, in Stretch stretch, out TriangleMesh surface)
        {
            if (_surfaces.TryGetValue(stretch, out surface)) return true;
            var scale = (Numerics.Vector3)stretch.Scale;
            if (TryScale(stretch, out ConvexShape _) && scale != Numerics.Vector3.One)
            {
                if (!TryStretch(mesh, Stretch.None, out surface)) return false;
                surface = surface.Scaled(scale);
            }
            else
            {
                Vector3[] vertices = mesh.vertices;
                var points = new Numerics.Vector3[vertices.Length];
                for (int i = 0; i < points.Length; i++) points[i] = stretch.Apply(vertices[i].ToNumerics());
                if (!TriangleMesh.TryCreate(points, mesh.triangles, out surface, out _)) return false;
            }

            if (_surfaces.Count >= MostCopies) _surfaces.Clear();
            _surfaces.Add(stretch, surface);
            return true;
        }

        /// <summary>The hull under a stretch; false where it leaves float's range.</summary>
        public bool TryStretch(in Stretch stretch, out ConvexShape shape)
        {
            if (TryScale(stretch, out shape)) return true;
            if (!_copies.TryGetValue(stretch, out ConvexHull hull))
            {
                var points = new Numerics.Vector3[_hull.VertexCount];
                for (int i = 0; i < points.Length; i++) points[i] = stretch.Apply(_hull.GetVertex(i));
                if (!ConvexHull.TryCreate(points, out hull, out _)) return false;
                if (_copies.Count >= MostCopies) _copies.Clear();
                _copies.Add(stretch, hull);
            }

            shape = ConvexShape.Mesh(hull);
            return true;
        }

        /// <summary>Scales the shape where the stretch has neither skew nor zeros: the hull stays the same.</summary>
        private bool TryScale(in Stretch stretch, out ConvexShape shape)
        {
            shape = default;
            if (!stretch.IsDiagonal) return false;
            var scale = (Numerics.Vector3)stretch.Scale;
            if (!(IsFactor(scale.X) && IsFactor(scale.Y) && IsFactor(scale.Z))) return false;
            shape = ConvexShape.Mesh(_hull);
            if (scale != Numerics.Vector3.One) shape = shape.Scaled(scale);
            return true;
        }

        private static bool IsFactor(float x) => x != 0 && x - x == 0;

        /// <summary>A mesh is its hull where all its faces are the hull's: on one side of a face's plane there is
        /// nothing. The face that has most on both sides decides. Faces may be wound either way.</summary>
        private double DeepestDent(Mesh mesh)
        {
            Vector3[] vertices = mesh.vertices;
            int[] triangles = mesh.triangles;
            var support = new ConvexMesh(_hull);
            double deepest = 0;
            for (int i = 0; i + 2 < triangles.Length; i += 3)
            {
                Double3 a = At(vertices[triangles[i]]), b = At(vertices[triangles[i + 1]]);
                Double3 normal = Double3.Cross(b - a, At(vertices[triangles[i + 2]]) - a);
                double length = normal.Length;
                if (!(length > 0)) continue;
                normal *= 1 / length;
                double inside = Math.Min(Beyond(support, normal, a), Beyond(support, -normal, a));
                deepest = Math.Max(deepest, inside);
            }

            return deepest;
        }

        /// <summary>How far the hull reaches beyond a plane through a point.</summary>
        private static double Beyond(in ConvexMesh hull, in Double3 normal, in Double3 point)
        {
            hull.Support(normal, out Double3 furthest);
            return Double3.Dot(normal, furthest + hull.Center - point);
        }

        private static Double3 At(Vector3 v) => new Double3(v.x, v.y, v.z);
    }
}
