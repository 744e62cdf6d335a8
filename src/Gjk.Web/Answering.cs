namespace Gjk.Web;

/// <summary>Answers the pairs that a page asks about, as the demo's <c>query</c> and <c>cast</c> do.</summary>
internal static class Answering
{
    /// <summary>Answers the first pairs of the list.</summary>
    public static void Run(Bodies bodies, Question question, int count)
    {
        for (int i = 0; i < count; i++)
        {
            int a = bodies.Pairs[2 * i], b = bodies.Pairs[2 * i + 1];
            Span<float> answer = bodies.Answers.AsSpan(i * Bodies.AnswerSize, Bodies.AnswerSize);
            if (question == Question.Impact) Write(answer, Impact(bodies, a, b));
            else Write(answer, Distance(bodies, a, b, question == Question.SignedDistance));
        }
    }

    private static DistanceResult Distance(Bodies bodies, int a, int b, bool isSigned)
    {
        ConvexShape shapeA = bodies.ShapeAt(a), shapeB = bodies.ShapeAt(b);
        RigidPose poseA = bodies.PoseAt(a), poseB = bodies.PoseAt(b);
        return isSigned
            ? ConvexQuery.SignedDistance(shapeA, poseA, shapeB, poseB)
            : ConvexQuery.Distance(shapeA, poseA, shapeB, poseB);
    }

    /// <summary>Each pair within the distance: its bodies, then the numbers of its answer.</summary>
    public static double[] PairsWithin(Bodies bodies, int count, float distance)
    {
        var scene = new CollisionScene();
        var bodyOf = new Dictionary<int, int>();
        for (int i = 0; i < count; i++) bodyOf.Add(scene.Add(bodies.ShapeAt(i), bodies.PoseAt(i)), i);
        var pairs = new List<PairDistance>();
        scene.FindPairsWithin(distance, pairs);
        var numbers = new List<double>();
        Span<float> answer = stackalloc float[Bodies.AnswerSize];
        foreach (PairDistance pair in pairs)
        {
            Write(answer, pair.Result);
            numbers.AddRange([bodyOf[pair.Pair.A], bodyOf[pair.Pair.B]]);
            foreach (float number in answer) numbers.Add(number);
        }

        return numbers.ToArray();
    }

    /// <summary>A pair that does not turn is answered to the last bit, one that does to a tolerance.</summary>
    private static CastResult Impact(Bodies bodies, int a, int b)
    {
        ConvexShape shapeA = bodies.ShapeAt(a), shapeB = bodies.ShapeAt(b);
        RigidMotion motionA = bodies.MotionAt(a), motionB = bodies.MotionAt(b);
        return motionA.AngularVelocity == Vector3.Zero && motionB.AngularVelocity == Vector3.Zero
            ? ConvexQuery.Cast(shapeA, motionA.Pose, motionA.Velocity, shapeB, motionB.Pose, motionB.Velocity)
            : ConvexQuery.TimeOfImpact(shapeA, motionA, shapeB, motionB);
    }

    /// <summary>Status, distance, lower bound, point of A, point of B, normal, iterations.</summary>
    private static void Write(Span<float> to, in DistanceResult result)
    {
        to[0] = (float)result.Status;
        to[1] = result.Distance;
        to[2] = result.LowerBound;
        result.PointA.CopyTo(to[3..]);
        result.PointB.CopyTo(to[6..]);
        result.Normal.CopyTo(to[9..]);
        to[12] = result.Iterations;
    }

    /// <summary>Status, fraction, point, normal, iterations; the rest is 0.</summary>
    private static void Write(Span<float> to, in CastResult result)
    {
        to.Clear();
        to[0] = (float)result.Status;
        to[1] = result.Fraction;
        result.Point.CopyTo(to[3..]);
        result.Normal.CopyTo(to[9..]);
        to[12] = result.Iterations;
    }
}

/// <summary>What a page asks of a pair.</summary>
internal enum Question
{
    Distance = 0,

    SignedDistance = 1,

    /// <summary>When the bodies first touch, along their velocities over one frame.</summary>
    Impact = 2,
}
