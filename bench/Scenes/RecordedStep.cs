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

    public readonly Simplex Simplex;

    /// <summary>The feature that the last step found. For the boolean walk only its normal is set.</summary>
    public readonly ClosestFeature Feature;

    private RecordedStep(in Simplex simplex, in ClosestFeature feature)
    {
        Simplex = simplex;
        Feature = feature;
    }

    /// <summary>The steps of the distance walks of a scene of meshes.</summary>
    public static List<RecordedStep> OfDistance(BenchScene scene)
    {
        var steps = new List<RecordedStep>();
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            var walk = new Walk(scene, pair);
            for (int i = 0; i < MostSteps; i++)
            {
                double plane = walk.Push();
                if (i > 0 && walk.Feature.Height - plane <= LeastProgress * walk.Feature.Height) break;
                steps.Add(new RecordedStep(walk.Simplex, walk.Feature));
                if (!ClosestFeatureStep.Reduce(ref walk.Simplex, ref walk.Feature)) break;
            }
        }

        return steps;
    }

    /// <summary>The steps of the boolean walks of a scene of meshes.</summary>
    public static List<RecordedStep> OfOverlap(BenchScene scene)
    {
        var steps = new List<RecordedStep>();
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            var walk = new Walk(scene, pair);
            for (int i = 0; i < MostSteps; i++)
            {
                if (walk.Push() > 0) break;
                if (i == 0)
                {
                    walk.Feature.Normal = walk.Simplex.WA;
                    continue;
                }

                steps.Add(new RecordedStep(walk.Simplex, walk.Feature));
                if (Core.NextSimplex.Advance(ref walk.Simplex, ref walk.Feature.Normal)) break;
            }
        }

        return steps;
    }

    /// <summary>The simplex in the order of the report's step, with the newest vertex last.</summary>
    public MinkowskiPoint[] ForReport()
    {
        var points = new MinkowskiPoint[Simplex.Count];
        for (int i = 0; i < points.Length; i++)
        {
            int slot = Simplex[points.Length - 1 - i];
            Vector3D onA = Simplex.OnA(slot);
            points[i] = new MinkowskiPoint((Vector3)onA, (Vector3)(onA - Simplex.W(slot)));
        }

        return points;
    }

    /// <summary>The state of a query between two steps.</summary>
    private struct Walk
    {
        public Simplex Simplex;
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

        /// <summary>Adds the vertex that lies furthest against the normal.</summary>
        /// <returns>The value of the plane through it.</returns>
        public double Push()
        {
            MinkowskiDifference.Support(
                ref _a, ref _b, _frame, Feature.Normal, out int idA, out int idB, out Vector3D onA, out Vector3D onB,
                out Vector3D w);
            Simplex.Push(w, onA, onB, idA, idB);
            return Vector3D.Dot(Feature.Normal, w);
        }
    }
}
