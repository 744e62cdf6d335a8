using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// From the two faces or edges that a pair shows along its normal to the points of its manifold: both are seen along
/// the normal, what lies opposite is found (<see cref="ContactCandidates"/>), and four points of it stay
/// (<see cref="ContactReduction"/>).
/// </summary>
/// <remarks>
/// The gap of each point is the distance of the two surfaces along the normal, so none is less than the signed
/// distance. The deepest points belong to the manifold even where no corner or edge names them: the rim of a tilted
/// disc, a face that is shown by some of its corners. A margin is added along the normal.
/// </remarks>
internal static unsafe class ContactBuilder
{
    /// <summary>Fills a manifold, whose normal is there already.</summary>
    /// <param name="plane">Where the contact is.</param>
    /// <param name="cornersA">A's face or edge, from A's centre; at least two corners.</param>
    /// <param name="cornersB">B's, from B's centre in B's frame; at least two corners.</param>
    /// <param name="poseA">Where A is.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="distance">The signed distance, in world units.</param>
    /// <param name="manifold">Gets the points.</param>
    /// <returns>False where the faces lie too steep to say anything; the manifold has no points then.</returns>
    public static bool TryBuild(
        in ContactPlane plane, in FaceCorners cornersA, in FaceCorners cornersB, in RigidPose poseA, double maxGap,
        float distance, ref ContactManifold manifold)
    {
        var basis = new PlaneBasis(plane.Normal);
        FlatCorner* flat = stackalloc FlatCorner[2 * FaceCorners.Capacity];
        FlatCorner* flatB = flat + FaceCorners.Capacity;
        double factor = 1 / plane.Frame.Unit;
        for (int i = 0; i < cornersA.Count; i++) flat[i] = See(cornersA[i] * factor, cornersA.IdOf(i), plane, basis);
        for (int i = 0; i < cornersB.Count; i++)
        {
            Vector3D point = plane.Frame.Rotation.Rotate(cornersB[i] * factor) + plane.Frame.Translation;
            flatB[i] = See(point, cornersB.IdOf(i), plane, basis);
        }

        var a = new FlatFeature(flat, cornersA.Count);
        var b = new FlatFeature(flatB, cornersB.Count);
        if (!a.IsLevel || !b.IsLevel) return false;
        Candidate* memory = stackalloc Candidate[ContactCandidates.Capacity];
        double mostGap = Math.Max(maxGap * factor + plane.Frame.Margins, plane.CoreDistance);
        var candidates = new ContactCandidates(memory, plane.Size, mostGap);
        candidates.Find(ref a, ref b);
        AddDeepest(plane, basis, ref candidates);
        int count = ContactReduction.Reduce(ref candidates, plane.Size);
        for (int i = 0; i < count; i++) manifold.Add(Point(candidates[i], plane, basis, poseA, distance));
        return true;
    }

    private static FlatCorner See(in Vector3D point, int id, in ContactPlane plane, in PlaneBasis basis)
    {
        // From the deepest point, so that no length is larger than the shapes.
        Vector3D p = point - plane.OnA;
        return new FlatCorner
        {
            U = Vector3D.Dot(p, basis.U),
            V = Vector3D.Dot(p, basis.V),
            Height = Vector3D.Dot(p, plane.Normal),
            Id = id,
        };
    }

    private static void AddDeepest(in ContactPlane plane, in PlaneBasis basis, ref ContactCandidates candidates)
    {
        double enough = plane.CoreDistance + ContactCandidates.Slack * plane.Size;
        for (int i = 0; i < candidates.Count; i++)
            if (candidates[i].Gap <= enough) return;
        candidates.Add(default, plane.CoreDistance, ContactFeature.None);
    }

    /// <summary>Back from the plane to the shapes and to the world.</summary>
    private static ContactPoint Point(
        in Candidate candidate, in ContactPlane plane, in PlaneBasis basis, in RigidPose poseA, float distance)
    {
        ref readonly PairFrame frame = ref plane.Frame;
        Vector3D place = plane.OnA + basis.U * candidate.U + basis.V * candidate.V;
        Vector3D onA = place + plane.Normal * (candidate.HeightA + frame.MarginA);
        Vector3D onB = place + plane.Normal * (candidate.HeightB - frame.MarginB);
        Vector3D localA = (onA + frame.CenterA) * frame.Unit;
        Vector3D localB = (frame.Rotation.InverseRotate(onB - frame.Translation) + frame.CenterB) * frame.Unit;
        double gap = (candidate.Gap - frame.Margins) * frame.Unit;
        Vector3D worldA = frame.RotationA.Rotate(localA) + poseA.Position;
        Vector3D worldB = worldA + frame.RotationA.Rotate(plane.Normal) * gap;
        return new ContactPoint(
            (Vector3)worldA, (Vector3)worldB, (Vector3)localA, (Vector3)localB, Math.Max((float)gap, distance),
            candidate.Id);
    }
}
