using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Numerics;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Study.Saves;

/// <summary>How a pair whose boxes meet is decided.</summary>
internal enum PairRule
{
    /// <summary>Every pair is asked.</summary>
    Exact,

    /// <summary>Two spheres around each centre, inside and outside, decide where they prove the answer.</summary>
    ProvedSpheres,

    /// <summary>
    /// As well, what is nearer than the threshold by its inner spheres touches: a gap that most people do not see. An
    /// overlap is never called apart, because an overlap is seen.
    /// </summary>
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
    /// <summary>Object sizes per frame.</summary>
    private const double Speed = 0.02;

    private readonly BuiltInScene _built;
    private readonly ConvexShape _shape;
    private readonly float _inner, _outer, _unseen;
    private readonly Curve _curve;

    /// <param name="scene">The objects, all of one shape.</param>
    /// <param name="tolerance">What people do not see.</param>
    /// <param name="unit">The length in the scene of a unit of the study.</param>
    public SavedQueries(BuiltInScene scene, Tolerance tolerance, double unit)
    {
        _built = scene;
        _shape = ConvexShape.Mesh(scene.Vertices);
        _outer = scene.Vertices.Max(v => v.Length());
        _inner = -ConvexQuery.SignedDistance(_shape, RigidPose.Identity, Vector3.Zero).Distance;
        _curve = tolerance.Curve with { Pse = tolerance.Curve.Pse * unit, Scale = tolerance.Curve.Scale * unit };
        _unseen = (float)_curve.Pse;
    }

    public RuleCost Run(PairRule rule, int frames, CancellationToken cancel)
    {
        var moving = new MovingObjects(_built, Speed);
        var scene = new CollisionScene();
        foreach (RigidPose pose in moving.Poses) scene.Add(_shape, pose);
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
            float centers = Vector3.Distance(a.Position, b.Position);
            if (rule == PairRule.SpheresOnly) return centers <= _inner + _outer;
            float unseen = rule == PairRule.TolerantSpheres ? _unseen : 0;
            if (centers - 2 * _outer > 0) return false;
            if (centers - 2 * _inner < unseen) return true;
        }

        queries++;
        return ConvexQuery.Overlaps(_shape, a, _shape, b);
    }

    /// <summary>The probability that somebody sees that a verdict is wrong; 0 for a right one.</summary>
    private double Judge(RigidPose[] poses, ObjectPair pair, bool verdict, ref long wrong)
    {
        float gap = ConvexQuery.SignedDistance(_shape, poses[pair.A], _shape, poses[pair.B]).Distance;
        if (gap <= 0 == verdict) return 0;
        wrong++;
        return verdict ? 1 - _curve.Touching(gap) : _curve.Touching(gap);
    }
}
