namespace Gjk.Core.Tests.Regression;

/// <summary>Boxes whose faces are level and share a part only. A thin box's shortest side counted as level, and what
/// lay beside a face by rounding was not cut at all: the deepest points were up to the whole size off their
/// boxes.</summary>
public class BoxFacePointTests
{
    [Fact]
    public void PointsThatWereBesideTheirBoxes()
    {
        Check(
            new(0.00024869436f, 1, 0.5f), RigidPose.Identity, new(6.356872e-5f, 1, 0.5f),
            new RigidPose(
                new Quaternion(6.8070416E-10f, 1.02934415E-07f, -2.48537404E-08f, 1), new Vector3(0, 1.5f, 0)));
        Check(
            new(0.7f, 0.20236093f, 0.5f), new RigidPose(new Quaternion(0, 0.382683456f, 0, 0.923879504f), default),
            new(0.7f, 0.05139234f, 0.73995906f),
            new RigidPose(
                new Quaternion(4.3511168E-09f, 0.382683486f, -4.88915823E-08f, 0.923879504f),
                new Vector3(0.707106829f, 0.121814743f, 0.707106709f)));
        Check(
            new(6.3720984e-10f, 1, 0.5f), new RigidPose(new Quaternion(0.5f, 0.5f, 0.5f, 0.5f), default),
            new(6.3720984e-10f, 1, 1), new RigidPose(new Vector3(-0.374648929f, 0.821909189f, 0.466364801f)));
        var turned = new Quaternion(0, 0, -0.707106769f, 0.707106769f);
        Check(
            new(4.25040281e-11f, 1, 1), new RigidPose(turned, default), new(4.25040281e-11f, 1, 1),
            new RigidPose(turned, new Vector3(1.5f, 0, 0)));
    }

    [Fact]
    public void PlatesThatShareAPart()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(4000); seed++)
        {
            var rng = new Rng(91_000 + seed);
            var a = new Vector3(rng.LogFloat(1e-10, 1), 1, 0.5f);
            var b = new Vector3(rng.LogFloat(1e-10, 1), 1, rng.Float(0.3f, 1));
            Quaternion q = rng.Below(2) == 0 ? Quaternion.Identity : rng.Rotation();
            Vector3 tilt = rng.Vector(-1, 1) * rng.LogFloat(1e-9, 1e-4);
            Quaternion turned = q * Quaternion.Normalize(new Quaternion(tilt, 1));
            Vector3 aside = new(rng.Float(-1, 1) * (a.X + b.X), rng.Float(-1.8f, 1.8f), rng.Float(-0.7f, 0.7f));
            if (rng.Below(3) == 0) turned = q;
            Check(a, new RigidPose(q, default), b, new RigidPose(turned, Vector3.Transform(aside, q)));
        }
    }

    private static void Check(Vector3 halfA, in RigidPose poseA, Vector3 halfB, in RigidPose poseB)
    {
        DistanceResult r = ConvexQuery.SignedDistance(new BoxShape(halfA), poseA, new BoxShape(halfB), poseB);
        if (!r.IsOverlapping) return;
        float slack = 2e-7f * (halfA.Length() + halfB.Length());
        bool areOn = IsIn(r.LocalPointA, halfA, slack) && IsIn(r.LocalPointB, halfB, slack);
        if (!areOn) Assert.Fail($"{r.LocalPointA} and {r.LocalPointB}: boxes {halfA} at {poseA}, {halfB} at {poseB}");
    }

    private static bool IsIn(Vector3 p, Vector3 half, float slack) =>
        MathF.Abs(p.X) <= half.X + slack && MathF.Abs(p.Y) <= half.Y + slack && MathF.Abs(p.Z) <= half.Z + slack;
}
