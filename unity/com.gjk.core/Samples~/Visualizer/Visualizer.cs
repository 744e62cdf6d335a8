using Gjk.Core;
using Gjk.Unity;
using UnityEngine;

namespace Gjk.Samples
{
    /// <summary>Figure 1 of the report, alive: the objects below this one turn red when they intersect, white lines
    /// join the closest points of the others, and the search for one pair is drawn as the solver makes it. Drag objects
    /// with the mouse; S shows the search or hides it, N goes to the next pair. Lines are debug lines: switch Gizmos on
    /// in the game view.</summary>
    public sealed class Visualizer : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Each search direction, in yellow, and each simplex, in blue, of one pair.")]
        private bool _showSearch = true;

        [SerializeField]
        [Tooltip("Which pair's search is drawn, by its number from 0.")]
        private int _searchedPair;

        private readonly SearchLines _lines = new SearchLines();
        private MeshFilter[] _filters;
        private Renderer[] _renderers;
        private PosedShape[] _shapes;
        private bool[] _areHit;
        private Dragging _dragging;
        private int _iterations, _intersecting;

        private void OnEnable()
        {
            _filters = GetComponentsInChildren<MeshFilter>();
            _renderers = new Renderer[_filters.Length];
            for (int i = 0; i < _filters.Length; i++)
            {
                _renderers[i] = _filters[i].GetComponent<Renderer>();
                Controls.MakeVisible(_renderers[i]);
            }

            _shapes = new PosedShape[_filters.Length];
            _areHit = new bool[_filters.Length];
            _dragging = new Dragging();
        }

        private void Update()
        {
            if (Controls.WasSearchPressed) _showSearch = !_showSearch;
            if (Controls.WasNextPressed)
                _searchedPair = (_searchedPair + 1) % (_shapes.Length * (_shapes.Length - 1) / 2);
            for (int i = 0; i < _shapes.Length; i++)
            {
                _shapes[i] = GjkShapes.From(_filters[i]);
                _areHit[i] = false;
            }

            _iterations = 0;
            _intersecting = 0;
            for (int i = 0, pair = 0; i < _shapes.Length; i++)
            {
                for (int j = i + 1; j < _shapes.Length; j++, pair++)
                {
                    Show(i, j);
                    if (_showSearch && pair == _searchedPair) _lines.Draw(_shapes[i], _shapes[j]);
                }
            }

            for (int i = 0; i < _shapes.Length; i++)
                _renderers[i].material.color = _areHit[i] ? Color.red : Color.green;
            _dragging.Update(_shapes, _filters);
        }

        // Only shows: with the Input System alone it gets no clicks and no keys.
        private void OnGUI() => GUI.Label(
            new Rect(10, 10, 400, 60),
            _intersecting + " pairs intersect, " + _iterations + " iterations in this frame\nS: the search of one pair "
            + (_showSearch ? "on" : "off") + ", N: next pair");

        private void Show(int i, int j)
        {
            ref PosedShape a = ref _shapes[i], b = ref _shapes[j];
            DistanceResult result = ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose);
            _iterations += result.Iterations;
            if (result.IsOverlapping)
            {
                _intersecting++;
                _areHit[i] = _areHit[j] = true;
                return;
            }

            Debug.DrawLine(result.PointA.ToUnity(), result.PointB.ToUnity(), Color.white);
        }
    }
}
