using Gjk.Core;
using Gjk.Unity;
using UnityEngine;

namespace Gjk.Samples
{
    /// <summary>
    /// Figure 1 of the report, alive: the objects below this one turn red when they intersect, white lines join the
    /// closest points of the others, and the search for one pair is drawn as the solver makes it. Drag objects with the
    /// mouse. Lines are debug lines: switch Gizmos on in the game view.
    /// </summary>
    public sealed class Visualizer : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Each search direction, in yellow, and each simplex, in blue, of one pair.")]
        private bool _showSearch = true;

        [SerializeField]
        [Tooltip("Which pair's search is drawn: the two objects that are nearest to each other, or the n-th pair.")]
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
            for (int i = 0; i < _filters.Length; i++) _renderers[i] = _filters[i].GetComponent<Renderer>();
            _shapes = new PosedShape[_filters.Length];
            _areHit = new bool[_filters.Length];
            _dragging = new Dragging();
        }

        private void Update()
        {
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
        }

        private void OnGUI()
        {
            GUILayout.BeginArea(new Rect(10, 10, 400, 120));
            GUILayout.Label(_intersecting + " pairs intersect, " + _iterations + " iterations in this frame");
            _showSearch = GUILayout.Toggle(_showSearch, "show the search of one pair");
            if (GUILayout.Button("next pair"))
                _searchedPair = (_searchedPair + 1) % (_shapes.Length * (_shapes.Length - 1) / 2);
            GUILayout.EndArea();
            _dragging.OnGUI(_shapes, _filters);
        }

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
