namespace Gjk.Demo.Timing;

/// <summary>A scene prepared for measuring. Shapes, poses and pairs are in arrays, and one method per verb goes through
/// the whole list, as a user's own loop would. The transforms are part of the measured time. The hulls were built
/// before.</summary>
internal sealed class PairLoop
{
    /// <summary>How many pairs are done between two checks for Ctrl-C. The check is so rare that it does not show in
    /// the times.</summary>
    private const int PairsPerLook = 1024;

    private readonly ConvexShape[] _shapes;
    private readonly RigidPose[] _poses;
    private readonly Vector3[] _velocities;
    private readonly int[] _a;
    private readonly int[] _b;
    private readonly CancellationToken _cancel;
    private readonly ObjectPair[] _pairs;
    private readonly DistanceResult[] _results;
    private readonly GjkStatus[] _statuses;
    private WarmStart[] _warm = [];
    private int[] _overlapping = [];

    public PairLoop(Scene scene, CancellationToken cancel)
    {
        _shapes = Array.ConvertAll(scene.Objects, o => o.Shape);
        _poses = Array.ConvertAll(scene.Objects, o => o.Pose);
        _velocities = Array.ConvertAll(scene.Objects, o => o.Velocity);
        _a = new int[scene.Pairs.Count];
        _b = new int[scene.Pairs.Count];
        scene.Pairs.CopyTo(_a, _b);
        _pairs = new ObjectPair[_a.Length];
        for (int i = 0; i < _a.Length; i++) _pairs[i] = new ObjectPair(_a[i], _b[i]);
        _results = new DistanceResult[_a.Length];
        _statuses = new GjkStatus[_a.Length];
        _cancel = cancel;
    }

    public int Count => _a.Length;

    public ReadOnlySpan<int> A => _a;

    public ReadOnlySpan<int> B => _b;

    /// <summary>The sum of the iterations over all pairs of the last pass. It gives the mean, and it keeps the compiler
    /// from removing the work.</summary>
    public long Iterations { get; private set; }

    /// <summary>Pairs that the last pass found overlapping.</summary>
    public int Overlapping { get; private set; }

    /// <summary>Distance without warm starts. The results are kept.</summary>
    public void Distances(DistanceResult[] results)
    {
        for (int i = 0; i < _a.Length; i++)
        {
            int a = _a[i], b = _b[i];
            results[i] = ConvexQuery.Distance(_shapes[a], _poses[a], _shapes[b], _poses[b]);
        }
    }

    /// <summary>Distance without warm starts.</summary>
    public void Cold()
    {
        long iterations = 0;
        int overlapping = 0;
        for (int start = 0; start < _a.Length; start += PairsPerLook)
        {
            _cancel.ThrowIfCancellationRequested();
            int end = Math.Min(start + PairsPerLook, _a.Length);
            for (int i = start; i < end; i++)
            {
                int a = _a[i], b = _b[i];
                DistanceResult result = ConvexQuery.Distance(_shapes[a], _poses[a], _shapes[b], _poses[b]);
                iterations += result.Iterations;
                if (result.IsOverlapping) overlapping++;
            }
        }

        Iterations = iterations;
        Overlapping = overlapping;
    }

    /// <summary>Distance with the warm start that each pair kept from its last query.</summary>
    /// <param name="poses">The poses in this frame. Null means the poses of the scene.</param>
    public void Warm(RigidPose[]? poses = null)
    {
        poses ??= _poses;
        if (_warm.Length == 0) _warm = new WarmStart[_a.Length];
        long iterations = 0;
        for (int start = 0; start < _a.Length; start += PairsPerLook)
        {
            _cancel.ThrowIfCancellationRequested();
            int end = Math.Min(start + PairsPerLook, _a.Length);
            for (int i = start; i < end; i++)
            {
                int a = _a[i], b = _b[i];
                iterations += ConvexQuery.Distance(_shapes[a], poses[a], _shapes[b], poses[b], ref _warm[i]).Iterations;
            }
        }

        Iterations = iterations;
    }

    /// <summary>The boolean query without warm starts.</summary>
    public void Boolean()
    {
        int overlapping = 0;
        for (int start = 0; start < _a.Length; start += PairsPerLook)
        {
            _cancel.ThrowIfCancellationRequested();
            int end = Math.Min(start + PairsPerLook, _a.Length);
            for (int i = start; i < end; i++)
            {
                int a = _a[i], b = _b[i];
                if (ConvexQuery.Overlaps(_shapes[a], _poses[a], _shapes[b], _poses[b])) overlapping++;
            }
        }

        Overlapping = overlapping;
    }

    /// <summary>Finds the pairs that overlap, for <see cref="Depth"/>; returns how many there are.</summary>
    public int CollectOverlapping()
    {
        var overlapping = new List<int>();
        for (int i = 0; i < _a.Length; i++)
            if (ConvexQuery.Overlaps(_shapes[_a[i]], _poses[_a[i]], _shapes[_b[i]], _poses[_b[i]])) overlapping.Add(i);
        _overlapping = [.. overlapping];
        return _overlapping.Length;
    }

    /// <summary>The signed distance of the pairs that overlap, without warm starts.</summary>
    public void Depth()
    {
        long iterations = 0;
        for (int k = 0; k < _overlapping.Length; k++)
        {
            if (k % PairsPerLook == 0) _cancel.ThrowIfCancellationRequested();
            int i = _overlapping[k], a = _a[i], b = _b[i];
            iterations += ConvexQuery.SignedDistance(_shapes[a], _poses[a], _shapes[b], _poses[b]).Iterations;
        }

        Iterations = iterations;
    }

    /// <summary>The casts of one frame: both objects of a pair move by their velocities. Without warm starts.</summary>
    public void Casts()
    {
        long iterations = 0;
        for (int start = 0; start < _a.Length; start += PairsPerLook)
        {
            _cancel.ThrowIfCancellationRequested();
            int end = Math.Min(start + PairsPerLook, _a.Length);
            for (int i = start; i < end; i++)
            {
                int a = _a[i], b = _b[i];
                iterations += ConvexQuery.Cast(
                    _shapes[a], _poses[a], _velocities[a], _shapes[b], _poses[b], _velocities[b]).Iterations;
            }
        }

        Iterations = iterations;
    }

    /// <summary>Distance without warm starts, the whole list in one call.</summary>
    public void Batch() => PairBatch.Distance(_shapes, _poses, _pairs, _results, cancellation: _cancel);

    /// <summary>Distance with warm starts, the whole list in one call.</summary>
    public void BatchWarm()
    {
        if (_warm.Length == 0) _warm = new WarmStart[_a.Length];
        PairBatch.Distance(_shapes, _poses, _pairs, _results, _warm, cancellation: _cancel);
    }

    /// <summary>The boolean query, the whole list in one call.</summary>
    public void BatchBoolean() => PairBatch.Overlaps(_shapes, _poses, _pairs, _statuses, cancellation: _cancel);
}
