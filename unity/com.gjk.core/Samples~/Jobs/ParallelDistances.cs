using System.Runtime.InteropServices;
using Gjk.Core;
using Gjk.Unity;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.Rendering;

namespace Gjk.Samples
{
    /// <summary>The distances of all pairs of convex objects below this one, by Unity's job threads or by the library's
    /// own batch. Queries are thread-safe and shapes immutable; only reading the objects belongs to the main
    /// thread.</summary>
    public sealed class ParallelDistances : MonoBehaviour
    {
        /// <summary>Pairs that a thread takes at a time: a query lasts about a microsecond.</summary>
        private const int PairsPerTurn = 32;

        [SerializeField]
        [Tooltip("The library's PairBatch and Workers instead of Unity's jobs. On WebGL there are no threads.")]
        private bool _useLibrary;

        private MeshFilter[] _filters;
        private PosedShape[] _posed;
        private ConvexShape[] _shapes;
        private RigidPose[] _poses;
        private ObjectPair[] _pairs;
        private DistanceResult[] _results;
        private Workers _workers;

        /// <summary>The least distance of the last frame.</summary>
        public float Least { get; private set; }

        private void OnEnable()
        {
            // The scene names the built-in pipeline's material, which others show in pink.
            RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
            foreach (Renderer shown in GetComponentsInChildren<Renderer>(true))
            {
                if (pipeline == null) continue;
                Material material = pipeline.defaultMaterial;
                shown.sharedMaterial = material != null ? material : new Material(pipeline.defaultShader);
            }

            _filters = GetComponentsInChildren<MeshFilter>();
            int count = _filters.Length;
            _posed = new PosedShape[count];
            _shapes = new ConvexShape[count];
            _poses = new RigidPose[count];
            _pairs = new ObjectPair[count * (count - 1) / 2];
            _results = new DistanceResult[_pairs.Length];
            for (int i = 0, pair = 0; i < count; i++)
            {
                for (int j = i + 1; j < count; j++) _pairs[pair++] = new ObjectPair(i, j);
            }

            _workers = new Workers();
        }

        private void OnDisable() => _workers.Dispose();

        private void Update()
        {
            for (int i = 0; i < _posed.Length; i++)
            {
                _posed[i] = GjkShapes.From(_filters[i]);
                _shapes[i] = _posed[i].Shape;
                _poses[i] = _posed[i].Pose;
            }

            if (_useLibrary) PairBatch.Distance(_shapes, _poses, _pairs, _results, workers: _workers);
            else AskJobs();
            Least = float.PositiveInfinity;
            foreach (DistanceResult result in _results)
            {
                if (result.Distance < Least) Least = result.Distance;
            }
        }

        private void OnGUI() => GUI.Label(new Rect(10, 10, 400, 30), "least distance " + Least.ToString("F4"));

        private void AskJobs()
        {
            var job = new DistanceJob
            {
                Shapes = GCHandle.Alloc(_posed),
                Pairs = GCHandle.Alloc(_pairs),
                Results = GCHandle.Alloc(_results),
            };
            try
            {
                job.Schedule(_pairs.Length, PairsPerTurn).Complete();
            }
            finally
            {
                job.Shapes.Free();
                job.Pairs.Free();
                job.Results.Free();
            }
        }
    }
}
