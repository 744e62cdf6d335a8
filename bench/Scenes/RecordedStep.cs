using System.Collections.Generic;
using System.Numerics;
using Gjk.Bench.Baseline;
using Gjk.Core;

namespace Gjk.Bench.Scenes;

/// <summary>
/// A simplex as the step of a query receives it: what the last step left, and the vertex that was found beyond it.
/// </summary>
internal readonly struct RecordedStep
{
    /// <summary>The most steps of a walk. A pair that touches may need many.</summary>
    private const int MostSteps = 32;

    /// <summary>
    /// A walk ends when a vertex is not nearer the origin by at least this share of the feature's height.
    /// </summary>
    private const double LeastProgress = 1e-10;

    /// <summary>What the last step left.</summary>
    public readonly FeatureVertices Vertices;

    /// <summary>The vertex found beyond it.</summary>
    public readonly MinkowskiVertex Newest;

    private readonly Simplex _points;

    private RecordedStep(in Walk walk)
    {
        Vertices = walk.Vertices;
        Newest = walk.Newest;
        _points = walk.Points;
    }

    /// <summary>How many vertices the step begins with.</summary>
    public int Count => Vertices.Count + 1;

    /// <summary>The steps of the walks of a scene of meshes.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="nearest">The distance's walk; otherwise the boolean's.</param>
    public static List<RecordedStep> Of(BenchScene scene, bool nearest)
    {
        var steps = new List<RecordedStep>();
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            var walk = new Walk(scene, pair);
            for (int i = 0; i < MostSteps; i++)
            {
                double plane = walk.Ask();
                if (nearest && i > 0 && walk.Feature.Height - plane <= LeastProgress * walk.Feature.Height) break;
                if (!nearest && plane > 0) break;
                steps.Add(new RecordedStep(walk));
                if (!Core.NextSimplex.TryAdvance(ref walk.Vertices, walk.Newest, ref walk.Feature, nearest)) break;
            }
        }

        return steps;
    }

    /// <summary>The simplex in the order of the report's step, with the newest vertex last.</summary>
    public MinkowskiPoint[] ForReport()
    {
        var points = new MinkowskiPoint[Count];
        for (int i = 0; i < points.Length; i++)
        {
            int place = points.Length - 1 - i;
            MinkowskiVertex vertex = place == 0 ? Newest
                : place == 1 ? Vertices.A : place == 2 ? Vertices.B : Vertices.C;
            Vector3D onA = _points.OnA((int)vertex.Slot);
            points[i] = new MinkowskiPoint((Vector3)onA, (Vector3)(onA - vertex.W));
        }

        return points;
    }

    /// <summary>The state of a query between two steps.</summary>
    private struct Walk
    {
        public Simplex Points;
        public FeatureVertices Vertices;
        public MinkowskiVertex Newest;
        public ClosestFeature Feature;
        private readonly PairFrame _frame;
        private ConvexMesh _a, _b;

        public Walk(BenchScene scene, BenchScene.Pair pair)
        {
            _a = new ConvexMesh(scene.Shapes[pair.A].Hull!);
            _b = new ConvexMesh(scene.Shapes[pair.B].Hull!);
            PairFrame.Compose(ref _a, scene.Poses[pair.A], ref _b, scene.Poses[pair.B], out _frame);
            Feature.Normal = -_frame.Translation;
        }

        /// <summary>Asks for the vertex that lies furthest against the normal.</summary>
        /// <returns>The value of the plane through it.</returns>
        public double Ask()
        {
            int slot = Vertices.FreeSlot;
            Vector3D w = MinkowskiDifference.Support(ref _a, ref _b, _frame, Feature.Normal, ref Points, slot, out _);
            Newest = new MinkowskiVertex(w, slot);
            return Vector3D.Dot(Feature.Normal, w);
        }
    }
}
