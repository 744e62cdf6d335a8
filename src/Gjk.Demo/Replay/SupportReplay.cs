using System.Diagnostics;
using Gjk.Core;
using Gjk.Demo.Scenes;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>Measures which part of the queries is the search for support points. One pass over the pairs records what
/// each support call gives. Then the passes search and read the record in turns. The record gives the same points in
/// the same order, and all else is the same code, so the search alone makes the difference. No stopwatch runs inside
/// the loop, because it would cost more than the work that it measures.</summary>
internal sealed class SupportReplay
{
    private static readonly TimeSpan Duration = TimeSpan.FromSeconds(0.5);

    private readonly Scene _scene;
    private readonly RecordedMesh[] _meshes;
    private readonly SupportRecord _record = new();
    private readonly CancellationToken _cancel;

    /// <param name="scene">Its shapes are unscaled meshes.</param>
    /// <param name="cancel">Ends the measuring.</param>
    public SupportReplay(Scene scene, CancellationToken cancel)
    {
        _scene = scene;
        _cancel = cancel;
        _meshes = Array.ConvertAll(scene.Objects, o => new RecordedMesh(new ConvexMesh(o.Shape.Hull!), _record));
        Ask(RecordUse.Write);
    }

    /// <summary>1 - (time of the queries that read the record) / (time of the queries), from 0 to 1: the median over
    /// the turns.</summary>
    public double Share()
    {
        WarmUp.Run(() => Ask(RecordUse.None), WarmUp.Short, _cancel);
        WarmUp.Run(() => Ask(RecordUse.Read), WarmUp.Short, _cancel);
        var shares = new List<double>();
        long start = Stopwatch.GetTimestamp();
        do
        {
            _cancel.ThrowIfCancellationRequested();
            long before = Stopwatch.GetTimestamp();
            Ask(RecordUse.None);
            long between = Stopwatch.GetTimestamp();
            Ask(RecordUse.Read);
            shares.Add(1 - (double)(Stopwatch.GetTimestamp() - between) / (between - before));
        }
        while (Stopwatch.GetElapsedTime(start) < Duration);
        shares.Sort();
        return Math.Clamp(shares[shares.Count / 2], 0, 1);
    }

    private void Ask(RecordUse use)
    {
        _record.Begin(use);
        foreach ((int a, int b) in _scene.Pairs)
            ConvexQuery.Distance(_meshes[a], _scene.Objects[a].Pose, _meshes[b], _scene.Objects[b].Pose);
    }

    private enum RecordUse
    {
        None,
        Write,
        Read,
    }

    /// <summary>The points and ids of all support calls of a pass, in their order.</summary>
    private sealed class SupportRecord
    {
        private (Double3 Point, int Id)[] _calls = new (Double3, int)[1024];
        private int _next;

        public RecordUse Use { get; private set; }

        public void Begin(RecordUse use)
        {
            Use = use;
            _next = 0;
        }

        public void Write(in Double3 point, int id)
        {
            if (_next == _calls.Length) Array.Resize(ref _calls, 2 * _next);
            _calls[_next++] = (point, id);
        }

        public int Read(out Double3 point)
        {
            ref readonly (Double3 Point, int Id) call = ref _calls[_next++];
            point = call.Point;
            return call.Id;
        }
    }

    /// <summary>A mesh that writes its support points into the record, or reads them there.</summary>
    private readonly struct RecordedMesh(ConvexMesh mesh, SupportRecord record) : ISupportMap
    {
        private readonly ConvexMesh _mesh = mesh;
        private readonly SupportRecord _record = record;

        public Double3 Center => _mesh.Center;

        public double Margin => _mesh.Margin;

        public double BoundingRadius => _mesh.BoundingRadius;

        public int Support(in Double3 direction, out Double3 point)
        {
            if (_record.Use == RecordUse.Read) return _record.Read(out point);
            int id = _mesh.Support(direction, out point);
            if (_record.Use == RecordUse.Write) _record.Write(point, id);
            return id;
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point) => _mesh.TryGetVertex(id, out point);
    }
}
