namespace Gjk.Demo.Timing;

/// <summary>The loops of <see cref="PairLoop"/> for a scene with surfaces or compounds. Such queries keep no starts and
/// have no batch.</summary>
internal sealed class ConcaveLoop
{
    private readonly AnyShape[] _shapes;
    private readonly RigidPose[] _poses;
    private readonly Vector3[] _velocities;
    private readonly int[] _a;
    private readonly int[] _b;
    private readonly ConcaveScratch _scratch = new();
    private readonly CancellationToken _cancel;

    public ConcaveLoop(Scene scene, CancellationToken cancel)
    {
        _shapes = Array.ConvertAll(scene.Objects, o => o.Any);
        _poses = Array.ConvertAll(scene.Objects, o => o.Pose);
        _velocities = Array.ConvertAll(scene.Objects, o => o.Velocity);
        _a = new int[scene.Pairs.Count];
        _b = new int[scene.Pairs.Count];
        scene.Pairs.CopyTo(_a, _b);
        _cancel = cancel;
    }

    /// <inheritdoc cref="PairLoop.Iterations"/>
    public long Iterations { get; private set; }

    /// <inheritdoc cref="PairLoop.Overlapping"/>
    public int Overlapping { get; private set; }

    /// <summary>The distances of all pairs.</summary>
    /// <param name="poses">The poses in this frame. Null means the poses of the scene.</param>
    public void Distances(RigidPose[]? poses = null) => Distances(poses, null);

    /// <inheritdoc cref="Distances(RigidPose[])"/>
    /// <param name="poses">The poses in this frame. Null means the poses of the scene.</param>
    /// <param name="results">Gets the results, or null.</param>
    public void Distances(RigidPose[]? poses, DistanceResult[]? results)
    {
        poses ??= _poses;
        long iterations = 0;
        int overlapping = 0;
        for (int i = 0; i < _a.Length; i++)
        {
            _cancel.ThrowIfCancellationRequested();
            int a = _a[i], b = _b[i];
            DistanceResult result = ConcaveQuery.Distance(_shapes[a], poses[a], _shapes[b], poses[b], _scratch).Result;
            if (results is not null) results[i] = result;
            iterations += result.Iterations;
            if (result.IsOverlapping) overlapping++;
        }

        Iterations = iterations;
        Overlapping = overlapping;
    }

    /// <summary>The boolean query.</summary>
    public void Boolean()
    {
        int overlapping = 0;
        for (int i = 0; i < _a.Length; i++)
        {
            _cancel.ThrowIfCancellationRequested();
            int a = _a[i], b = _b[i];
            if (ConcaveQuery.Overlaps(_shapes[a], _poses[a], _shapes[b], _poses[b], _scratch)) overlapping++;
        }

        Overlapping = overlapping;
    }

    /// <summary>The casts of one frame: both objects of a pair move by their velocities.</summary>
    public void Casts()
    {
        long iterations = 0;
        for (int i = 0; i < _a.Length; i++)
        {
            _cancel.ThrowIfCancellationRequested();
            int a = _a[i], b = _b[i];
            CastHit cast = ConcaveQuery.Cast(
                _shapes[a], _poses[a], _velocities[a], _shapes[b], _poses[b], _velocities[b], _scratch);
            iterations += cast.Result.Iterations;
        }

        Iterations = iterations;
    }
}
