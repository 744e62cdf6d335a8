namespace Gjk.Demo.View;

/// <summary>The poses and all answers of a scene, frame by frame. Each column is an array, as the page needs
/// it.</summary>
internal sealed class SceneResults
{
    /// <summary>Numbers in a pose: the quaternion x, y, z, w, then the position.</summary>
    public const int PoseSize = 7;

    /// <summary>The most answers that a page may hold. At 43 bytes each this is about 145 MB of text, which a browser
    /// can still open.</summary>
    public const long MostAnswers = 2_500_000;

    /// <summary>The most poses that a page may hold, for the same reason.</summary>
    public const long MostPoses = 2_500_000;

    /// <summary>How many pairs are answered between two checks for Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    private readonly ConcaveScratch _scratch = new();
    private ContactManifold _manifold;

    private SceneResults(int objects, ScenePairs chosen, int frames, bool isConvex)
    {
        Pairs = chosen;
        int pairs = (int)chosen.Count;
        Poses = new float[frames * objects * PoseSize];
        Status = new byte[frames * pairs];
        Iterations = new ushort[frames * pairs];
        Distance = new float[frames * pairs];
        PointA = new float[frames * pairs * 3];
        PointB = new float[frames * pairs * 3];
        Normal = new float[frames * pairs * 3];
        Overlapping = new int[frames];
        PartA = isConvex ? [] : new int[frames * pairs];
        PartB = isConvex ? [] : new int[frames * pairs];
    }

    /// <summary>The pairs that were queried. See <see cref="PairChoice"/>.</summary>
    public ScenePairs Pairs { get; }

    public float[] Poses { get; }

    public byte[] Status { get; }

    public ushort[] Iterations { get; }

    /// <summary>Minus the depth for a pair that overlaps.</summary>
    public float[] Distance { get; }

    /// <summary>Three numbers per pair. Where only bounds of the depth are known, it is no deepest point.</summary>
    public float[] PointA { get; }

    /// <summary>A's point plus the distance times the normal, rounded.</summary>
    public float[] PointB { get; }

    /// <summary>For a pair that overlaps, the direction in which B leaves A by the shortest way.</summary>
    public float[] Normal { get; }

    /// <summary>The part of A that the answer is about, as its file numbers it, or -1. Empty for a scene of convex
    /// shapes.</summary>
    public int[] PartA { get; }

    /// <summary>The part of B, likewise.</summary>
    public int[] PartB { get; }

    /// <summary>How many pairs overlap in each frame.</summary>
    public int[] Overlapping { get; }

    /// <summary>One entry for each pair that overlaps in a frame.</summary>
    public SceneContacts Contacts { get; } = new();

    /// <summary>One entry for each pair that meets over the frame that follows.</summary>
    public SceneCasts Casts { get; } = new();

    /// <exception cref="RefusedException">The scene is more than a page can hold, or the motion leaves the range of
    /// float.</exception>
    /// <param name="scene">The scene.</param>
    /// <param name="name">The user's name for it.</param>
    /// <param name="choosing">Takes the share of the search for the pairs that is done.</param>
    /// <param name="progress">Takes the share of the answers that is done.</param>
    /// <param name="cancel">Ends the work.</param>
    public static SceneResults Of(
        Scene scene, string name, Action<double> choosing, Action<double> progress, CancellationToken cancel)
    {
        if ((long)Math.Max(scene.Objects.Length, 1) * scene.Frames > MostPoses)
            throw new RefusedException(
                $"{name}: {scene.Objects.Length} objects in {scene.Frames} frames are more than the {MostPoses} poses "
                + "that a page can hold");
        var motion = new SceneMotion(scene, name);
        ScenePairs chosen = PairChoice.Of(scene, motion, name, choosing, cancel);
        choosing(1);
        int pairs = (int)chosen.Count;
        var results = new SceneResults(scene.Objects.Length, chosen, scene.Frames, scene.IsConvex);
        var poses = new RigidPose[scene.Objects.Length];
        for (int frame = 0; frame < scene.Frames; frame++)
        {
            cancel.ThrowIfCancellationRequested();
            motion.Poses(frame, poses);
            for (int i = 0; i < poses.Length; i++) results.Store(frame * poses.Length + i, poses[i]);
            int pair = 0;
            foreach ((int a, int b) in chosen)
            {
                if (pair % PairsPerLook == 0)
                {
                    cancel.ThrowIfCancellationRequested();
                    progress((frame + (double)pair / pairs) / scene.Frames);
                }

                int index = frame * pairs + pair++;
                results.Add(index, scene.Objects[a], poses[a], scene.Objects[b], poses[b]);
                if (results.Overlaps(index)) results.Overlapping[frame]++;
            }
        }

        progress(1);
        return results;
    }

    /// <summary>True for a pair that intersects. Where the search for the depth outgrew its room, the pair intersects
    /// too, and is at least as deep as its distance says.</summary>
    public bool Overlaps(int index) =>
        Status[index] == StatusCode.Of(GjkStatus.Overlapping)
        || (Status[index] == StatusCode.Of(GjkStatus.IterationLimit) && Distance[index] <= 0);

    private void Add(int index, SceneObject a, in RigidPose poseA, SceneObject b, in RigidPose poseB)
    {
        DistanceResult answer = Answer(index, a, poseA, b, poseB);
        Store(index, answer);
        Casts.Add(index, a, poseA, b, poseB);
        if (!Overlaps(index)) return;
        // Where only bounds of the depth are known, its points would be no contacts.
        if (answer.Status != GjkStatus.Overlapping) _manifold.Clear();
        Contacts.Add(_manifold);
    }

    /// <summary>The signed distance of a pair, and its contacts or its parts.</summary>
    private DistanceResult Answer(int index, SceneObject a, in RigidPose poseA, SceneObject b, in RigidPose poseB)
    {
        if (a.IsConvex && b.IsConvex)
        {
            if (PartA.Length > 0) PartA[index] = PartB[index] = -1;
            float mostGap = SceneContacts.MostGapOf(a.Shape, b.Shape);
            return ConvexQuery.Contacts(a.Shape, poseA, b.Shape, poseB, mostGap, out _manifold);
        }

        _manifold.Clear();
        PairDistance answer = ConcaveQuery.SignedDistance(a.Any, poseA, b.Any, poseB, _scratch);
        (PartA[index], PartB[index]) = (answer.PartA, answer.PartB);
        return answer.Result;
    }

    private void Store(int index, in RigidPose pose)
    {
        Span<float> to = Poses.AsSpan(index * PoseSize, PoseSize);
        new Vector4(pose.Rotation.X, pose.Rotation.Y, pose.Rotation.Z, pose.Rotation.W).CopyTo(to);
        pose.Position.CopyTo(to[4..]);
    }

    private void Store(int index, in DistanceResult answer)
    {
        Status[index] = StatusCode.Of(answer.Status);
        Iterations[index] = (ushort)Math.Min(answer.Iterations, ushort.MaxValue);
        Distance[index] = answer.Distance;
        answer.PointA.CopyTo(PointA.AsSpan(3 * index));
        answer.PointB.CopyTo(PointB.AsSpan(3 * index));
        answer.Normal.CopyTo(Normal.AsSpan(3 * index));
    }
}
