using System;
using Gjk.Core;
using Gjk.Core.Tests.Support;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>Small polytopes are solved again in integers of any size: flag, distance and bound are held to the true answer.</summary>
internal sealed class TheExactAnswer : IPromise
{
    /// <summary>The exact solver takes a millisecond for so many vertices, of both shapes together.</summary>
    private const int MostVertices = 40;

    public string Name => "the answer is the exact one, rounded";

    public string? Broken(FuzzPair pair)
    {
        Vector3D[] a = pair.BodyA.Vertices, b = pair.BodyB.Vertices;
        DistanceResult r = pair.Answer;
        if (pair.IsCurved || a.Length + b.Length > MostVertices || r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping)) return null;

        ExactAnswer exact = ExactOracle.Solve(a, pair.A.Margin, pair.PoseA, b, pair.B.Margin, pair.PoseB);
        if (!(Math.Abs(r.Distance - exact.Distance) <= pair.Band(exact.Distance))) return Say.Line($"{r.Status}, distance {r.Distance}, truly {exact.Distance}");
        return r.LowerBound <= exact.Distance + Accuracy.Offset * (pair.BodyA.Reach + pair.BodyB.Reach) ? null : Say.Line($"the lower bound {r.LowerBound} is above the true distance {exact.Distance}");
    }
}
