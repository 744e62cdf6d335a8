using System.Runtime.InteropServices;

namespace Gjk.Demo.View;

/// <summary>When and where the objects of a scene first touch over the frame that follows each frame. Only pairs that
/// meet have an entry, in the order of the frames and then of the pairs.</summary>
internal sealed class SceneCasts
{
    /// <summary>Numbers in an entry: the fraction, the point, the normal. The last six are NaN where the search reached
    /// its iteration limit: the pair is apart up to the fraction.</summary>
    public const int EntrySize = 7;

    private readonly ConcaveScratch _scratch = new();
    private readonly List<int> _indices = [];
    private readonly List<float> _entries = [];

    /// <summary>For every entry the frame times the number of pairs, plus the pair.</summary>
    public ReadOnlySpan<int> Indices => CollectionsMarshal.AsSpan(_indices);

    /// <summary><see cref="EntrySize"/> numbers for each entry.</summary>
    public ReadOnlySpan<float> Entries => CollectionsMarshal.AsSpan(_entries);

    /// <summary>True for a pair whose objects move past each other. A cast does not turn them.</summary>
    public static bool Applies(SceneObject a, SceneObject b) =>
        a.Velocity != b.Velocity && a.AngularVelocity == Vector3.Zero && b.AngularVelocity == Vector3.Zero;

    /// <summary>Casts the next pair.</summary>
    /// <param name="index">Its place among all answers.</param>
    /// <param name="a">The first object.</param>
    /// <param name="poseA">Where it is in this frame.</param>
    /// <param name="b">The second object.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    public void Add(int index, SceneObject a, in RigidPose poseA, SceneObject b, in RigidPose poseB)
    {
        if (!Applies(a, b)) return;
        CastResult r = ConcaveQuery.Cast(a.Any, poseA, a.Velocity, b.Any, poseB, b.Velocity, _scratch).Result;
        if (r.Status is not (CastStatus.Hit or CastStatus.IterationLimit)) return;
        _indices.Add(index);
        _entries.AddRange(
            [r.Fraction, r.Point.X, r.Point.Y, r.Point.Z, r.Normal.X, r.Normal.Y, r.Normal.Z]);
    }
}
