using System.Diagnostics;
using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Study.Saves;

/// <summary>How a pair whose boxes meet is decided.</summary>
internal enum PairRule
{
    /// <summary>Every pair is asked.</summary>
    Exact,

    /// <summary>Two spheres around each centre, inside and outside, decide where they prove the answer.</summary>
    ProvedSpheres,

    /// <summary>As well, what is nearer than the threshold by its inner spheres touches: a gap that most people do not
    /// see. An overlap is never called apart, because an overlap is seen.</summary>
    TolerantSpheres,

    /// <summary>A sphere of middle size is the collider, and nothing is asked.</summary>
    SpheresOnly,
}

/// <summary>What a rule costs and gets wrong, for each frame.</summary>
/// <param name="Rule">The rule.</param>
/// <param name="Pairs">Pairs whose boxes meet.</param>
/// <param name="Queries">Pairs that the library was asked about.</param>
/// <param name="Milliseconds">The time of the decisions.</param>
/// <param name="Wrong">Decisions that the exact answer contradicts.</param>
/// <param name="Seen">How many of these somebody at the threshold sees: the sum of the curve's probabilities.</param>
internal readonly record struct RuleCost(
    PairRule Rule, double Pairs, double Queries, double Milliseconds, double Wrong, double Seen);

/// <summary>Runs a scene of moving objects and decides its pairs by a rule, and judges the decisions
/// afterwards.</summary>
internal sealed class SavedQueries
{
    private readonly SceneObject[] _objects;
    private readonly RigidPose[] _poses;
    private readonly Aabb _room;
    private readonly double _speed;
    private readonly float _unseen;
    private readonly Curve _curve;

    /// <summary>Radii of balls about each object's centre, inside and outside of it.</summary>
    private readonly float[] _inner, _outer;

    /// <summary>The centres in the objects' frames.</summary>
    private readonly Vector3[] _centers;

    /// <param name="scene">Convex objects, where they begin.</param>
    /// <param name="room">The box that their positions do not leave.</param>
    /// <param name="speed">Length per frame.</param>
    /// <param name="tolerance">What people do not see.</param>
    /// <param name="unit">The length in the scene of a unit of the study.</param>
    public SavedQueries(Scene scene, in Aabb room, double speed, Tolerance tolerance, double unit)
    {
        _objects = scene.Objects;
        _poses = Array.ConvertAll(_objects, o => o.Pose);
        _room = room;
        _speed = speed;
        _centers = Array.ConvertAll(_objects, o => (Vector3)o.Shape.Center);
        _outer = Array.ConvertAll(_objects, o => MathF.BitIncrement((float)o.Shape.BoundingRadius));
        _inner = Array.ConvertAll(_objects, o => Math.Max(0, -SignedDistanceOf(o.Shape)));
        _curve = tolerance.Curve with { Pse = tolerance.Curve.Pse * unit, Scale = tolerance.Curve.Scale * unit };
        _unseen = (float)_curve.Pse;
    }

    private static float SignedDistanceOf(in ConvexShape shape) =>
        ConvexQuery.SignedDistance(shape, RigidPose.Identity, (Vector3)shape.Center).Distance;

    public RuleCost Run(PairRule rule, int frames, CancellationToken cancel)
    {
        var moving = new MovingObjects(_poses, _room, _speed);
        var scene = new CollisionScene();
        foreach (SceneObject each in _objects) scene.Add(each.Shape, each.Pose);
        var pairs = new List<ObjectPair>();
        var verdicts = new List<bool>();
        long count = 0, queries = 0, ticks = 0, wrong = 0;
        double seen = 0;
        for (int frame = 0; frame < frames; frame++)
        {
            cancel.ThrowIfCancellationRequested();
            for (int i = 0; i < moving.Poses.Length; i++) scene.Move(i, moving.Poses[i]);
            scene.CollectCandidates(pairs);
            verdicts.Clear();
            long start = Stopwatch.GetTimestamp();
            foreach (ObjectPair pair in pairs) verdicts.Add(Decide(rule, moving.Poses, pair, ref queries));
            ticks += Stopwatch.GetTimestamp() - start;
            count += pairs.Count;
            for (int i = 0; i < pairs.Count; i++) seen += Judge(moving.Poses, pairs[i], verdicts[i], ref wrong);
            moving.Advance();
        }

        double milliseconds = ticks * 1e3 / Stopwatch.Frequency / frames;
        return new RuleCost(
            rule, (double)count / frames, (double)queries / frames, milliseconds, (double)wrong / frames,
                seen / frames);
    }

    /// <summary>Whether the pair touches, by the rule.</summary>
    private bool Decide(PairRule rule, RigidPose[] poses, ObjectPair pair, ref long queries)
    {
        RigidPose a = poses[pair.A], b = poses[pair.B];
        if (rule != PairRule.Exact)
        {
            float centers = Vector3.Distance(a.TransformPoint(_centers[pair.A]), b.TransformPoint(_centers[pair.B]));
            float inner = _inner[pair.A] + _inner[pair.B], outer = _outer[pair.A] + _outer[pair.B];
            if (rule == PairRule.SpheresOnly) return centers <= (inner + outer) / 2;
            float unseen = rule == PairRule.TolerantSpheres ? _unseen : 0;
            if (centers - outer > 0) return false;
            if (centers - inner < unseen) return true;
        }

        queries++;
        return ConvexQuery.Overlaps(_objects[pair.A].Shape, a, _objects[pair.B].Shape, b);
    }

    /// <summary>The probability that somebody sees that a verdict is wrong; 0 for a right one.</summary>
    private double Judge(RigidPose[] poses, ObjectPair pair, bool verdict, ref long wrong)
    {
        float gap = ConvexQuery.SignedDistance(
            _objects[pair.A].Shape, poses[pair.A], _objects[pair.B].Shape, poses[pair.B]).Distance;
        if (gap <= 0 == verdict) return 0;
        wrong++;
        return verdict ? 1 - _curve.Touching(gap) : _curve.Touching(gap);
    }
}
