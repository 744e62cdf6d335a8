namespace Gjk.Core;

/// <summary>When parts of two bodies that move and turn first touch: conservative advancement of the whole bodies, and
/// of their parts where those come near.</summary>
/// <remarks>Idea (Mirtich 1996, section 2.3; for trees Tang, Kim and Manocha 2009): bodies at a distance do not touch
/// before they could have closed it at their greatest speed, so time goes on by that much. Where they are near, all
/// parts that could touch in a short piece of time are asked for their own time of impact, which <see
/// cref="ConvexQuery.TimeOfImpact{TA, TB}(in TA, in RigidMotion, in TB, in RigidMotion, float, float, in
/// CastOptions)"/> answers from the whole motion. Deviation: nothing is answered here. The pieces only say which parts
/// need not be asked, and so the result is that of all pairs asked in turn. Exactness: a pose at a fraction is rounded
/// to float; <see cref="PoseRounding"/> is added to every reach; from where no float has a pose the whole motion is one
/// piece. It ends: each piece is at least twice as long as the one before, and after <see cref="MostSteps"/> distances
/// the rest of the motion is one piece.</remarks>
internal static class PartAdvancement
{
    /// <summary>Ratio to the trees' reach: 2^-6; bodies nearer than this are looked at part by part. It changes the
    /// cost alone: larger ones ask more parts, smaller ones more distances. No test can tell.</summary>
    private const double Near = 1.0 / (1 << 6);

    /// <summary>Ratio to the reach and the position: 2^-21. Rounding a quaternion's four parts to float turns by at
    /// most 2^-23, and a position's by 2^-24 each. More only costs time; less is not seen by a test, as a touch has
    /// more room.</summary>
    private const double PoseRounding = 1.0 / (1 << 21);

    /// <summary>Distances of a query; a bound of the cost. Pinned by PartAdvancementTests.ATurnBesideAnotherBodyEnds,
    /// which does not end without one.</summary>
    private const int MostSteps = 64;

    /// <summary>Finds the first contact of the search that the scratch holds, of an impact that passes
    /// nothing.</summary>
    public static void Run(ConcaveScratch scratch, in RigidMotion a, in RigidMotion b)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        PartSide sideA = scratch.A, sideB = scratch.B;
        double reachA = Reach(sideA), reachB = Reach(sideB), near = Near * (reachA + reachB);
        double speed = search.Speed, touch = search.TouchRoom, from = 0, span = 0;
        for (int step = 0; from <= search.Last; step++)
        {
            if (!TryPoseAt(a, from, out sideA.Pose) || !TryPoseAt(b, from, out sideB.Pose))
            {
                (sideA.Pose, sideB.Pose) = (a.Pose, b.Pose);
                search.Look(scratch, 0, double.PositiveInfinity, 0);
                PartCastSearch.Run(scratch);
                break;
            }

            double rounding = PoseRounding * (reachA + reachB + Size(sideA.Pose) + Size(sideB.Pose));
            double room = touch + rounding;
            if (step < MostSteps)
            {
                PartPairSearch.Run(scratch, float.PositiveInfinity);
                double gap = scratch.Search.LowerBound - room;
                if (gap > near)
                {
                    from += gap / speed;
                    continue;
                }

                span = Math.Max(2 * span, near / speed);
            }
            else
            {
                span = double.PositiveInfinity;
            }

            double to = from + span;
            search.Look(scratch, from, to, rounding);
            PartCastSearch.Run(scratch);
            if (to >= search.Last) break;
            from = to;
        }

        sideA.Pose = a.Pose;
        sideB.Pose = b.Pose;
    }

    /// <summary>The furthest point of a side from its position, or more.</summary>
    private static double Reach(PartSide side) => side.Tree.Origin.Length + side.Tree.Radius + side.Margin;

    private static double Size(in RigidPose pose) => ((Double3)pose.Position).SumOfMagnitudes;

    /// <summary>The pose at a fraction, or the first one where float has no such pose.</summary>
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
