using System;
using System.Collections.Generic;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Scenes;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>
/// Measures which part of a frame is the search for support points. One frame runs on meshes that record the direction
/// of every support call. The same calls are then repeated on the plain meshes and timed. No stopwatch runs inside the
/// loop, because it would cost more than the work that it measures.
/// </summary>
internal sealed class SupportReplay
{
    private static readonly TimeSpan Duration = TimeSpan.FromSeconds(0.2);

    private readonly ConvexMesh[] _meshes;
    private readonly List<SupportCall> _calls = [];
    private readonly CancellationToken _cancel;
    private long _ids;

    /// <param name="scene">Its shapes are unscaled meshes. The queries ask them directly, whatever type holds
    /// them.</param>
    /// <param name="cancel">Ends the measuring.</param>
    public SupportReplay(Scene scene, CancellationToken cancel)
    {
        _cancel = cancel;
        _meshes = Array.ConvertAll(scene.Objects, o => new ConvexMesh(o.Shape.Hull!));
        foreach ((int a, int b) in scene.Pairs)
        {
            var onA = new RecordingMesh(_meshes[a], a, _calls);
            var onB = new RecordingMesh(_meshes[b], b, _calls);
            ConvexQuery.Distance(onA, scene.Objects[a].Pose, onB, scene.Objects[b].Pose);
        }
    }

    /// <summary>The median time of all support calls of a frame, in nanoseconds.</summary>
    public double MedianNs()
    {
        SupportCall[] calls = [.. _calls];
        WarmUp.Run(() => Ask(calls), WarmUp.Short, _cancel);
        return Samples.Of(() => Ask(calls), Duration, 1, _cancel).MedianNs;
    }

    private void Ask(SupportCall[] calls)
    {
        long ids = 0;
        foreach (ref readonly SupportCall call in calls.AsSpan())
            ids += _meshes[call.Object].Support(call.Direction, out _);
        _ids = ids;
    }

    private readonly struct SupportCall
    {
        public readonly Vector3D Direction;
        public readonly int Object;

        public SupportCall(int index, in Vector3D direction)
        {
            Object = index;
            Direction = direction;
        }
    }

    /// <summary>A mesh that records each direction before it answers.</summary>
    private readonly struct RecordingMesh : ISupportMap
    {
        private readonly ConvexMesh _mesh;
        private readonly int _object;
        private readonly List<SupportCall> _calls;

        public RecordingMesh(in ConvexMesh mesh, int index, List<SupportCall> calls)
        {
            _mesh = mesh;
            _object = index;
            _calls = calls;
        }

        public Vector3D Center => _mesh.Center;

        public double Margin => _mesh.Margin;

        public double BoundingRadius => _mesh.BoundingRadius;

        public int Support(in Vector3D direction, out Vector3D point)
        {
            _calls.Add(new SupportCall(_object, direction));
            return _mesh.Support(direction, out point);
        }

        public bool TryGetVertex(int id, out Vector3D point) => _mesh.TryGetVertex(id, out point);
    }
}
