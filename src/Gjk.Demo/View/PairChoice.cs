namespace Gjk.Demo.View;

/// <summary>Chooses the pairs that a page shows. These are all pairs, unless a browser could not sort and draw that
/// many smoothly. In that case they are every pair that intersects in some frame, and each object's nearest partners in
/// every frame.</summary>
internal sealed class PairChoice
{
    /// <summary>Up to this many answers (pairs times frames) all pairs are shown. A page needs 43 bytes for each, so
    /// about 10 MB.</summary>
    public const long MostOfAll = 250_000;

    /// <summary>Nearest partners kept for each object in each frame.</summary>
    public const int Partners = 6;

    /// <summary>Ratio: several roundings to float, of which 1.2e-7 each is the most. More only costs time.</summary>
    private const double Rounding = 1e-6;

    /// <summary>How many pairs are answered between two checks for Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    private readonly Scene _scene;
    private readonly ConcaveScratch _scratch = new();
    private readonly SortedSet<(int A, int B)> _kept = [];
    private readonly (float Distance, int Partner, bool IsFirst)[] _nearest;

    /// <summary>Around each object: a ball in its own frame, and where it is in the world in this frame.</summary>
    private readonly (Double3 Center, double Radius)[] _local, _balls;

    private PairChoice(Scene scene)
    {
        _scene = scene;
        _nearest = new (float, int, bool)[scene.Objects.Length * Partners];
        _local = Array.ConvertAll(scene.Objects, o => BallOf(o.Any));
        _balls = new (Double3, double)[_local.Length];
    }

    /// <exception cref="RefusedException">Even the chosen pairs are too many for a page.</exception>
    public static ScenePairs Of(
        Scene scene, SceneMotion motion, string name, Action<double> progress, CancellationToken cancel)
    {
        if (scene.Pairs.Count * (double)scene.Frames <= MostOfAll) return scene.Pairs;
        var choice = new PairChoice(scene);
        var poses = new RigidPose[scene.Objects.Length];
        for (int frame = 0; frame < scene.Frames; frame++)
        {
            motion.Poses(frame, poses);
            choice.AddFrame(poses, share => progress((frame + share) / scene.Frames), cancel);
            if (choice._kept.Count * (long)scene.Frames <= SceneResults.MostAnswers) continue;
            throw new RefusedException(
                $"{name}: {scene.Pairs.Count} pairs in {scene.Frames} frames are more than a page can hold, and so are "
                + "the intersecting and nearest ones alone; list fewer in $.pairs");
        }

        return choice.Listed();
    }

    private void AddFrame(RigidPose[] poses, Action<double> progress, CancellationToken cancel)
    {
        Array.Fill(_nearest, (float.PositiveInfinity, -1, true));
        for (int i = 0; i < poses.Length; i++)
        {
            Double3 center = poses[i].TransformPoint((Vector3)_local[i].Center);
            _balls[i] = (center, _local[i].Radius + Rounding * center.Length);
        }

        long done = 0;
        foreach ((int a, int b) in _scene.Pairs)
        {
            if (done++ % PairsPerLook == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress((double)done / _scene.Pairs.Count);
            }

            float reach = Math.Max(
                _nearest[a * Partners + Partners - 1].Distance, _nearest[b * Partners + Partners - 1].Distance);
            if (IsBeyond(_balls[a], _balls[b], reach)) continue;
            DistanceResult answer = ConcaveQuery.Distance(
                _scene.Objects[a].Any, poses[a], _scene.Objects[b].Any, poses[b], _scratch, reach).Result;
            if (answer.Status is GjkStatus.Overlapping or GjkStatus.IterationLimit or GjkStatus.InvalidShape)
                _kept.Add((a, b));
            if (answer.Status != GjkStatus.Separated) continue;
            Rank(a, b, answer.Distance, isFirst: true);
            Rank(b, a, answer.Distance, isFirst: false);
        }

        for (int i = 0; i < _nearest.Length; i++)
        {
            (_, int partner, bool isFirst) = _nearest[i];
            if (partner >= 0) _kept.Add(isFirst ? (i / Partners, partner) : (partner, i / Partners));
        }
    }

    /// <summary>True if the balls are further apart. Most pairs of a large scene need no other look.</summary>
    private static bool IsBeyond(
        in (Double3 Center, double Radius) a, in (Double3 Center, double Radius) b, double reach)
    {
        double most = reach + a.Radius + b.Radius;
        return (b.Center - a.Center).LengthSquared > most * most;
    }

    private static (Double3 Center, double Radius) BallOf(in AnyShape shape)
    {
        if (shape.Kind == AnyShapeKind.Convex)
        {
            double extent = shape.Convex.BoundingRadius;
            return (shape.Convex.Center, extent + Rounding * (extent + shape.Convex.Center.Length));
        }

        double radius = 0;
        for (int i = 0; i < shape.Mesh?.VertexCount; i++)
            radius = Math.Max(radius, ((Double3)(shape.Mesh.GetVertex(i) * shape.Mesh.Scale)).Length);
        for (int i = 0; i < shape.Compound?.PartCount; i++)
        {
            (Double3 center, double reach) = BallOf(AnyShape.Of(shape.Compound.GetPart(i)));
            radius = Math.Max(radius, center.Length + reach);
        }

        return (default, radius * (1 + Rounding));
    }

    /// <summary>Inserts a partner into the list of an object's nearest partners.</summary>
    private void Rank(int of, int partner, float distance, bool isFirst)
    {
        int first = of * Partners, at = first + Partners - 1;
        if (!(distance < _nearest[at].Distance)) return;
        for (; at > first && distance < _nearest[at - 1].Distance; at--) _nearest[at] = _nearest[at - 1];
        _nearest[at] = (distance, partner, isFirst);
    }

    private ScenePairs Listed()
    {
        var indices = new int[2 * _kept.Count];
        int i = 0;
        foreach ((int a, int b) in _kept)
        {
            indices[i++] = a;
            indices[i++] = b;
        }

        return ScenePairs.Listed(indices);
    }
}
