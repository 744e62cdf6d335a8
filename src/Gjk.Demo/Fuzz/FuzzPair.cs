using System;
using Gjk.Core;

namespace Gjk.Demo.Fuzz;

/// <summary>Two posed shapes and the library's cold answer for them: what a promise is held to.</summary>
internal sealed class FuzzPair
{
    public readonly ConvexShape A, B;
    public readonly RigidPose PoseA, PoseB;

    public FuzzPair(in QueryRecord query)
        : this(query.A, query.PoseA, query.B, query.PoseB)
    {
    }

    public FuzzPair(in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
        : this(a, poseA, b, poseB, ConvexQuery.Distance(a, poseA, b, poseB))
    {
    }

    /// <summary>With an answer from elsewhere, which may be wrong.</summary>
    public FuzzPair(in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, in DistanceResult answer)
    {
        (A, PoseA, B, PoseB) = (a, poseA, b, poseB);
        Answer = answer;
        BodyA = new PosedShape(a, poseA);
        BodyB = new PosedShape(b, poseB);
        double side = Math.Max(BodyA.LongestSide, BodyB.LongestSide);
        Scale = side > 0 ? side : float.IsFinite(Answer.Distance) ? Answer.Distance : 0;
        Centers = BodyB.Position - BodyA.Position + (BodyB.Rotate(BodyB.Center) - BodyA.Rotate(BodyA.Center));
        Noise = Accuracy.Rounding * (BodyA.Reach + BodyB.Reach + Centers.Length);
    }

    /// <summary>What the cold query says.</summary>
    public DistanceResult Answer { get; }

    public PosedShape BodyA { get; }

    public PosedShape BodyB { get; }

    /// <summary>The longest side of the local bounding boxes, the larger of the two; of two points, their distance.</summary>
    public double Scale { get; }

    public bool IsCurved => BodyA.IsCurved || BodyB.IsCurved;

    /// <summary>From A's centre to B's, in the world's axes.</summary>
    public Vector3D Centers { get; }

    /// <summary>What rounding may do to a length computed here from the pair's own numbers.</summary>
    public double Noise { get; }

    public QueryRecord Record => new(A, PoseA, B, PoseB);

    /// <summary>How much a distance may be off.</summary>
    public double Band(double distance) => IsCurved
        ? Accuracy.CurvedRatio * Math.Max(Scale, distance) + Unavoidable
        : Accuracy.DistanceRatio * distance + Accuracy.DistanceScale * Scale + Unavoidable;

    /// <summary>What even shapes without extent cannot be held to: corners far from their local origin are turned in 106 bits, and floats end.</summary>
    private double Unavoidable => Accuracy.Offset * (BodyA.Reach + BodyB.Reach) + Accuracy.LeastFloat;

    /// <summary>How far a point of the answer may be off its shape, before it is rounded to float.</summary>
    public double WitnessSlack => (IsCurved ? Accuracy.CurvedRatio : Accuracy.WitnessScale) * Math.Max(Scale, IsCurved ? FiniteDistance : 0);

    /// <summary>How far apart the planes across a unit direction of the world stand that touch A and B; negative where the shapes reach past each other.</summary>
    public double Gap(in Vector3D n) => Vector3D.Dot(n, Centers) - BodyA.Height(n) - BodyB.Height(-n);

    /// <summary>The same shapes in other places.</summary>
    public FuzzPair At(in RigidPose poseA, in RigidPose poseB) => new(A, poseA, B, poseB);

    private double FiniteDistance => float.IsFinite(Answer.Distance) ? Answer.Distance : 0;
}
