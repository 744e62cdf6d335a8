using System;
using System.Collections.Generic;
using System.Linq;
using Gjk.Bench.Benchmarks;
using Gjk.Bench.Scenes;
using Gjk.Bench.Table;
using Gjk.Core;

namespace Gjk.Bench.Peers;

/// <summary>What an engine needed for a set, and how many of its answers were wrong.</summary>
internal readonly record struct PeerFigure(double Nanoseconds, int Wrong);

/// <summary>One set of pairs and one question about them.</summary>
/// <param name="Name">The set's.</param>
/// <param name="Verb">The question.</param>
/// <param name="Scene">The pairs.</param>
internal sealed record PeerSet(string Name, PeerVerb Verb, BenchScene Scene)
{
    /// <summary>
    /// Ratio to the larger of size and distance. An engine is wrong if its distance or depth is further off, or its
    /// flag differs although the shapes are further apart, or deeper in each other, than that.
    /// </summary>
    private const double Tolerance = 1e-5;

    /// <summary>The library's loop.</summary>
    public TimedLoop Library() => new(Scene.Pairs.Length, Verb switch
    {
        PeerVerb.Distance => () => SceneQueries.Distance(Scene),
        PeerVerb.Boolean => () => SceneQueries.Overlaps(Scene),
        _ => () => SceneQueries.Depth(Scene),
    });

    /// <summary>How many of an engine's answers differ from the library's, which are proved.</summary>
    public int Wrong(IReadOnlyList<(bool Overlap, double Value)> answers) =>
        Enumerable.Range(0, Scene.Pairs.Length).Count(i => IsWrong(Scene.Pairs[i], answers[i]));

    private bool IsWrong(BenchScene.Pair pair, (bool Overlap, double Value) answer)
    {
        ref ConvexShape a = ref Scene.Shapes[pair.A], b = ref Scene.Shapes[pair.B];
        double signed = ConvexQuery.SignedDistance(a, Scene.Poses[pair.A], b, Scene.Poses[pair.B]).Distance;
        double most = Tolerance * Math.Max(Math.Max(Motion.Size(a), Motion.Size(b)), Math.Abs(signed));
        if (answer.Overlap != signed <= 0 && Math.Abs(signed) > most) return true;
        if (Verb == PeerVerb.Boolean) return false;
        double truth = Verb == PeerVerb.Depth ? -signed : Math.Max(signed, 0);
        return !(Math.Abs(answer.Value - truth) <= most);
    }

    /// <summary>All sets: the report's scenes and random pairs for distances and booleans, the depths' own.</summary>
    public static IEnumerable<Func<PeerSet[]>> All()
    {
        foreach (string name in ReportScenes.Names) yield return () => Of(name, ReportScenes.Create(name));
        foreach (string name in RandomPairs.Names) yield return () => Of(name, RandomPairs.Create(name));
        foreach (string name in DepthPairs.Names)
            yield return () => [new PeerSet(name, PeerVerb.Depth, DepthPairs.Create(name))];
    }

    private static PeerSet[] Of(string name, BenchScene scene) =>
        [new PeerSet(name, PeerVerb.Distance, scene), new PeerSet(name, PeerVerb.Boolean, scene)];
}
