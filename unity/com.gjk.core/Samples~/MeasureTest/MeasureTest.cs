using System.Diagnostics;
using Gjk.Core;
using Gjk.Unity;
using UnityEngine;
using UnityEngine.Rendering;
#if !ENABLE_LEGACY_INPUT_MANAGER
using UnityEngine.InputSystem;
#endif

namespace Gjk.Samples
{
    /// <summary>Table 1 of the report: 20 objects, 190 calls a frame, on screen the time and the loops per call. The
    /// space bar goes from the cubes to the spheres and back.</summary>
    public sealed class MeasureTest : MonoBehaviour
    {
        /// <summary>Frames: how many the figures on screen are the mean of.</summary>
        private const int FramesPerFigure = 60;

        [SerializeField]
        private GameObject _cubes;

        [SerializeField]
        private GameObject _spheres;

        private readonly Stopwatch _clock = new Stopwatch();
        private MeshFilter[] _filters;
        private PosedShape[] _shapes;
        private int _frames, _calls, _iterations, _intersecting;
        private string _figures = "";

#if ENABLE_LEGACY_INPUT_MANAGER
        private static bool WasPressed => Input.GetKeyDown(KeyCode.Space);
#else
        private static bool WasPressed => Keyboard.current != null && Keyboard.current.spaceKey.wasPressedThisFrame;
#endif

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

            Choose(_cubes);
        }

        private void Update()
        {
            if (WasPressed) Choose(_cubes.activeSelf ? _spheres : _cubes);
            for (int i = 0; i < _shapes.Length; i++) _shapes[i] = GjkShapes.From(_filters[i]);
            _intersecting = 0;
            _clock.Start();
            for (int i = 0; i < _shapes.Length; i++)
            {
                for (int j = i + 1; j < _shapes.Length; j++) Measure(_shapes[i], _shapes[j]);
            }

            _clock.Stop();
            if (++_frames < FramesPerFigure) return;
            double milliseconds = _clock.Elapsed.TotalMilliseconds;
            _figures = _calls / _frames + " calls a frame, " + _intersecting + " pairs intersect\n"
                + (milliseconds / _frames).ToString("F3") + " ms a frame, "
                + (milliseconds * 1000 / _calls).ToString("F3") + " us a call\n"
                + ((double)_iterations / _calls).ToString("F2") + " loops per call";
            Restart();
        }

        // Only shows: with the Input System alone it gets no clicks and no keys.
        private void OnGUI() => GUI.Label(
            new Rect(10, 10, 400, 80), _figures + "\nspace bar: " + (_cubes.activeSelf ? "spheres" : "cubes"));

        private void Measure(in PosedShape a, in PosedShape b)
        {
            DistanceResult result = ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose);
            _calls++;
            _iterations += result.Iterations;
            if (result.IsOverlapping) _intersecting++;
        }

        private void Choose(GameObject chosen)
        {
            _cubes.SetActive(chosen == _cubes);
            _spheres.SetActive(chosen == _spheres);
            _filters = chosen.GetComponentsInChildren<MeshFilter>();
            _shapes = new PosedShape[_filters.Length];
            _figures = "";
            Restart();
        }

        private void Restart()
        {
            _clock.Reset();
            _frames = _calls = _iterations = 0;
        }
    }
}
