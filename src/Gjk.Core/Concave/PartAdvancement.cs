namespace Gjk.Core;

/// <summary>Finds when parts of two bodies that move and turn first touch: conservative advancement of the whole
/// bodies, and of their parts where those come near.</summary>
/// <remarks>Idea (Mirtich 1996, section 2.3; for trees Tang, Kim and Manocha 2009): bodies at a distance do not touch
/// before they could have closed it at their greatest speed, so time advances by that much. Where they are near, the
/// search looks at the parts that could touch within a short piece of time. Planes that move with the parts prove most
/// of them apart (<see cref="ConvexQuery.StaysApart"/>). For the others
/// <see cref="ConvexQuery.TimeOfImpact{TA, TB}(in TA, in RigidMotion, in TB, in RigidMotion, float, float, in
/// CastOptions)"/> answers from the whole motion. Deviation: no answer is made here. The pieces only rule parts out, so
/// the result is that of all pairs in turn. Exactness: a pose at a fraction is rounded to float;
/// <see cref="PoseRounding"/> is added to every reach. From where no float has a pose, the whole motion is one piece.
/// It ends: after <see cref="MostSteps"/> pieces and distances the rest of the motion is one piece.</remarks>
internal static class PartAdvancement
{
    /// <summary>Ratio to the trees' reach: 2^-6; how far the bodies move in the first piece. It changes the time only,
    /// so no test sees it: longer pieces measure more parts, shorter ones more distances.</summary>
    private const double Near = 1.0 / (1 << 6);

    /// <summary>Count: so many pairs of parts cost about as much as one distance of the bodies. After a piece with
    /// fewer, the next one is twice as long. After a piece that got less far for its cost than a distance would, it is
    /// half as long. Where the bodies are about as near as parts that touch, distances lead nowhere, and each piece is
    /// twice as long. It changes the time only.</summary>
    private const int PartsPerDistance = 32;

    /// <summary>Ratio to the reach and the position: 2^-21. Rounding a quaternion's four parts to float turns by at
    /// most 2^-23, and a position's by 2^-24 each. More only costs time; less is not seen by a test, as a touch has
    /// more room.</summary>
    private const double PoseRounding = 1.0 / (1 << 21);

    /// <summary>Count: distances and pieces of a query; a bound of the cost. Pinned by
    /// PartAdvancementTests.ATurnBesideAnotherBodyEnds, which does not end without one.</summary>
    private const int MostSteps = 1 << 14;

    /// <summary>Finds the first contact of the search that the scratch holds, of an impact that passes
    /// nothing.</summary>
    public static void Run(ConcaveScratch scratch, in PartMotion motion)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        PartSide sideA = scratch.A, sideB = scratch.B;
        double reachA = Reach(sideA), reachB = Reach(sideB), speed = search.Speed, from = 0;
        double span = Near * (reachA + reachB) / speed;
        int nearestA = PartSide.NoPart, nearestB = PartSide.NoPart;
        for (search.Steps = 0; from <= search.LastFraction; search.Steps++)
        {
            bool isPosed = TryPoseAt(motion.A, from, out sideA.Pose) & TryPoseAt(motion.B, from, out sideB.Pose);
            if (!isPosed || search.Steps >= MostSteps)
            {
                if (!isPosed) (sideA.Pose, sideB.Pose, from) = (motion.A.Pose, motion.B.Pose, 0);
                search.RestrictTo(scratch, from, double.PositiveInfinity, isPosed ? RoundingOf(sideA, sideB) : 0);
                PartCastSearch.Run(scratch);
                break;
            }

            double rounding = RoundingOf(sideA, sideB);
            PartPairSearch.Run(scratch, float.PositiveInfinity, nearestA, nearestB);
            (nearestA, nearestB) = (scratch.Search.PartA, scratch.Search.PartB);
            double room = (search.TouchRoom + rounding) / speed;
            double free = scratch.Search.LowerBound / speed - room;
            if (free > span)
            {
                from += free;
                continue;
            }

            double to = from + span;
            int before = search.QueryCount;
            search.RestrictTo(scratch, from, to, rounding);
            PartCastSearch.Run(scratch);
            int asked = search.QueryCount - before;
            if (to >= search.LastFraction) break;
            from = to;
            if (asked < PartsPerDistance || free <= room) span *= 2;
            else if (asked * free > PartsPerDistance * span) span /= 2;
        }

        sideA.Pose = motion.A.Pose;
        sideB.Pose = motion.B.Pose;
    }

    /// <summary>A bound of the distance of a side's furthest point from its position.</summary>
    private static double Reach(PartSide side) => side.Tree.Origin.Length + side.Tree.Radius + side.Margin;

    private static double RoundingOf(PartSide a, PartSide b) =>
        PoseRounding * (Reach(a) + Reach(b) + Size(a.Pose) + Size(b.Pose));

    private static double Size(in RigidPose pose) => ((Double3)pose.Position).SumOfMagnitudes;

    /// <summary>The pose at a fraction; the first pose where float has no pose there.</summary>
    public static RigidPose PoseAt(in RigidMotion motion, double fraction) =>
        TryPoseAt(motion, fraction, out RigidPose pose) ? pose : motion.Pose;

    private static bool TryPoseAt(in RigidMotion motion, double fraction, out RigidPose pose)
    {
        pose = default;
        Double3 turn = motion.AngularVelocity;
        double rate = turn.Length;
        if (!(rate * fraction < SineCosine.MaxAngle)) return false;
        QuaternionD rotation = motion.Pose.Rotation;
        if (rate > 0) rotation = QuaternionD.About(turn * (1 / rate), rate * fraction) * rotation;
        var position = (Vector3)((Double3)motion.Pose.Position + (Double3)motion.Velocity * fraction);
        if (!Guard.IsFinite(position)) return false;
        pose = new RigidPose(
            new Quaternion((float)rotation.X, (float)rotation.Y, (float)rotation.Z, (float)rotation.W), position);
        return true;
    }
}
