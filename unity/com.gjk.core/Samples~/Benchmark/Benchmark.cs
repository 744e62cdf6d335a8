using System.Diagnostics;
using System.Reflection;
using Gjk.Core;
using Gjk.Unity;
using UnityEngine;
using UnityEngine.Rendering;
using Debug = UnityEngine.Debug;

namespace Gjk.Samples
{
    /// <summary>A stopwatch on screen: nanoseconds per query of five kinds, over all pairs of the convex objects below
    /// this one, with the versions that a report needs. The figures are the fastest pass so far; they settle after some
    /// seconds. Measure in a release build: the Editor and development builds are slower.</summary>
    public sealed class Benchmark : MonoBehaviour
    {
        /// <summary>Milliseconds of each frame that are spent on measuring.</summary>
        private const double MillisecondsPerFrame = 5;

        /// <summary>World units: up to which gap contact points are asked for.</summary>
        private const float MostGap = 0.02f;

        private static readonly string[] Kinds = { "distance", "distance, warm", "depth", "overlaps", "contacts" };

        private readonly Stopwatch _clock = new Stopwatch();
        private readonly double[] _nanoseconds = new double[Kinds.Length];
        private PosedShape[] _shapes;
        private WarmStart[] _warmStarts;
        private int _kind;
        private string _text = "";

        /// <summary>How many pairs a pass asks about.</summary>
        public int Pairs => _warmStarts.Length;

        /// <summary>The fastest pass of a kind, per query.</summary>
        public double Nanoseconds(int kind) => _nanoseconds[kind];

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

            MeshFilter[] filters = GetComponentsInChildren<MeshFilter>();
            _shapes = new PosedShape[filters.Length];
            for (int i = 0; i < filters.Length; i++) _shapes[i] = GjkShapes.From(filters[i]);
            _warmStarts = new WarmStart[filters.Length * (filters.Length - 1) / 2];
            for (int i = 0; i < Kinds.Length; i++) _nanoseconds[i] = double.PositiveInfinity;
        }

        private void Update()
        {
            if (Pairs == 0) return;
            Stopwatch frame = Stopwatch.StartNew();
            do
            {
                _clock.Restart();
                Pass(_kind);
                double pass = _clock.Elapsed.TotalMilliseconds * 1e6 / Pairs;
                if (pass < _nanoseconds[_kind]) _nanoseconds[_kind] = pass;
            }
            while (frame.Elapsed.TotalMilliseconds < MillisecondsPerFrame);
            _kind = (_kind + 1) % Kinds.Length;
            if (_kind == 0) _text = Text();
        }

        // Only shows: with the Input System alone it gets no clicks and no keys.
        private void OnGUI() => GUI.Label(new Rect(10, 10, 500, 160), _text);

        private static string Library() => typeof(ConvexQuery).Assembly
            .GetCustomAttribute<AssemblyInformationalVersionAttribute>().InformationalVersion.Split('+')[0];

        private static string Runtime() =>
#if ENABLE_IL2CPP
            "IL2CPP";
#elif ENABLE_CORECLR
            "CoreCLR";
#else
            "Mono";
#endif

        private string Text()
        {
            string text = "Gjk " + Library() + ", Unity " + Application.unityVersion + ", " + Runtime()
                + (Application.isEditor ? ", in the Editor" : Debug.isDebugBuild ? ", development build" : "")
                + "\n" + Pairs + " pairs, ns per query:";
            for (int i = 0; i < Kinds.Length; i++) text += "\n" + _nanoseconds[i].ToString("F0") + "  " + Kinds[i];
            return text;
        }

        /// <summary>A question about every pair. The warm one keeps its starts from pass to pass.</summary>
        private void Pass(int kind)
        {
            for (int i = 0, pair = 0; i < _shapes.Length; i++)
            {
                for (int j = i + 1; j < _shapes.Length; j++) Ask(kind, _shapes[i], _shapes[j], ref _warmStarts[pair++]);
            }
        }

        private static void Ask(int kind, in PosedShape a, in PosedShape b, ref WarmStart warmStart)
        {
            switch (kind)
            {
                case 0:
                    ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose);
                    break;
                case 1:
                    ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose, ref warmStart);
                    break;
                case 2:
                    ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose);
                    break;
                case 3:
                    ConvexQuery.Overlaps(a.Shape, a.Pose, b.Shape, b.Pose);
                    break;
                default:
                    ConvexQuery.Contacts(a.Shape, a.Pose, b.Shape, b.Pose, MostGap, out ContactManifold _);
                    break;
            }
        }
    }
}
