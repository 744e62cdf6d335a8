using System.Diagnostics;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>Measures which part of the queries is the search for support points. Passes over the pairs search each
/// support point once and twice, in turns. All else is the same code, so the second search makes the difference. No
/// stopwatch runs inside the loop, because it would cost more than the work that it measures.</summary>
internal sealed class SupportShare
{
    private static readonly TimeSpan Duration = TimeSpan.FromSeconds(0.5);

    private readonly Scene _scene;
    private readonly RepeatedMesh[] _meshes;
    private readonly Repetition _repetition = new();
    private readonly CancellationToken _cancel;

    /// <param name="scene">Its shapes are unscaled meshes.</param>
    /// <param name="cancel">Ends the measuring.</param>
    public SupportShare(Scene scene, CancellationToken cancel)
    {
        _scene = scene;
        _cancel = cancel;
        _meshes = Array.ConvertAll(scene.Objects, o => new RepeatedMesh(new ConvexMesh(o.Shape.Hull!), _repetition));
    }

    /// <summary>(time with two searches - time with one) / (time with one), from 0 to 1: the median over the
    /// turns.</summary>
    public double Measure()
    {
        WarmUp.Run(
            () =>
            {
                Ask(false);
                Ask(true);
            },
            WarmUp.Short,
            _cancel);
        var shares = new List<double>();
        long start = Stopwatch.GetTimestamp();
        do
        {
            _cancel.ThrowIfCancellationRequested();
            long before = Stopwatch.GetTimestamp();
            Ask(false);
            long between = Stopwatch.GetTimestamp();
            Ask(true);
            shares.Add((double)(Stopwatch.GetTimestamp() - between) / (between - before) - 1);
        }
        while (Stopwatch.GetElapsedTime(start) < Duration);
        shares.Sort();
        return Math.Clamp(shares[shares.Count / 2], 0, 1);
    }

    private void Ask(bool isTwice)
    {
        _repetition.IsOn = isTwice;
        foreach ((int a, int b) in _scene.Pairs)
            ConvexQuery.Distance(_meshes[a], _scene.Objects[a].Pose, _meshes[b], _scene.Objects[b].Pose);
    }

    private sealed class Repetition
    {
        public bool IsOn { get; set; }
    }

    /// <summary>A mesh that may search each of its support points twice.</summary>
    private readonly struct RepeatedMesh(ConvexMesh mesh, Repetition repetition) : ISupportMap
    {
        private readonly ConvexMesh _mesh = mesh;
        private readonly Repetition _repetition = repetition;

        public Double3 Center => _mesh.Center;

        public double Margin => _mesh.Margin;

        public double BoundingRadius => _mesh.BoundingRadius;

        /// <summary>The second search begins with what the first one found: else a processor runs both at
        /// once.</summary>
        public int Support(in Double3 direction, out Double3 point)
        {
            int id = _mesh.Support(direction, out point);
            if (!_repetition.IsOn) return id;
            Double3 same = direction + point * 0;
            return _mesh.Support(same, out point);
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point) => _mesh.TryGetVertex(id, out point);
    }
}
