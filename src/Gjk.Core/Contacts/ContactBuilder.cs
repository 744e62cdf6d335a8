namespace Gjk.Core;

/// <summary>From the two faces or edges that a pair shows along its normal to the points of its manifold: both are seen
/// along the normal, the places where they lie opposite each other are found (<see cref="ContactPlaces"/>), each gets a
/// point of both surfaces (<see cref="SurfacePoint"/>), and four of them stay
/// (<see cref="ContactReduction"/>).</summary>
/// <remarks>The gap of each point is the distance of the two surfaces along the normal, so none is less than the signed
/// distance. A deepest point belongs to the manifold even where no corner or edge names it, as on the rim of a tilted
/// disc.</remarks>
internal static unsafe class ContactBuilder
{
    /// <summary>Length, as a fraction of the size: a point is as deep as the deepest where its gap is wider by no more.
    /// Times the 1.74 that a size may be of a scale it is within the promised 1e-6; above what rounding to float does
    /// to the poses of bodies that lie flat, and what opens along a line where bodies cross at 1e-3. Pinned by
    /// ContactPropertyTests.</summary>
    public const double AsDeep = 5.5e-7;

    /// <summary>Fills a manifold, whose normal is there already.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="plane">Where the contact is; where it is open, the deepest place is the deepest point.</param>
    /// <param name="cornersA">A's face or edge, from A's centre; at least two corners.</param>
    /// <param name="cornersB">B's, from B's centre in B's frame; at least two corners.</param>
    /// <param name="poseA">Where A is.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="distance">The signed distance, in world units.</param>
    /// <param name="manifold">Gets the points.</param>
    /// <returns>False where the faces lie too steep to say anything; the manifold has no points then.</returns>
    public static bool TryBuild<TA, TB>(
        ref TA a, ref TB b, in ContactPlane plane, in FaceCorners cornersA, in FaceCorners cornersB, in RigidPose poseA,
        double maxGap, float distance, ref ContactManifold manifold)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        FlatCorner* flat = stackalloc FlatCorner[2 * FaceCorners.Capacity];
        FlatFeature faceA = plane.Project(cornersA, isOfA: true, flat);
        FlatFeature faceB = plane.Project(cornersB, isOfA: false, flat + FaceCorners.Capacity);
        if (!plane.IsOpen) MeetingEdges.Keep(ref faceA, ref faceB, plane.Size);
        if (!faceA.IsLevel || !faceB.IsLevel) return false;
        ContactPlace* places = stackalloc ContactPlace[ContactPlaces.Capacity];
        var found = new ContactPlaces(places, faceA, faceB, plane.Size);
        found.Find(ref faceA, ref faceB);
        Candidate* memory = stackalloc Candidate[ContactCandidates.Capacity];
        var candidates = new ContactCandidates(memory);
        double mostGap = Math.Max(maxGap / plane.Frame.Unit, plane.Distance);
        bool haveMoved = false;
        for (int i = 0; i < found.Count; i++)
        {
            if (!TryMeasure(ref a, ref b, plane, found, found[i], faceA, faceB, out Candidate candidate)) continue;
            haveMoved |= candidate.U != found[i].U || candidate.V != found[i].V;
            if (candidate.Gap <= mostGap) candidates.Add(candidate);
        }

        if (plane.IsOpen && candidates.Count == 0) return true;
        if (haveMoved && candidates.Count > ContactManifold.Capacity) candidates.KeepOutline();
        bool areEdges = faceA.Count == 2 && faceB.Count == 2;
        var deepest = new Candidate(
            0, 0, plane.Frame.MarginA, plane.Frame.MarginB - plane.CoreDistance,
            areEdges ? ContactFeature.Of(ContactFeature.Edge(faceA[0].Id), ContactFeature.Edge(faceB[0].Id)) : 0);
        if (plane.IsOpen) deepest = candidates.Deepest;
        Candidate* quarters = stackalloc Candidate[ContactManifold.Capacity];
        if (!QuarterNames.TryFind(ref faceA, ref faceB, quarters)) quarters = null;
        ContactReduction.Reduce(ref candidates, deepest, quarters, AsDeep * plane.Size, found.ReachAround);
        for (int i = 0; i < candidates.Count; i++) manifold.Add(Point(candidates[i], plane, poseA, distance));
        return true;
    }

    /// <summary>Finds the surfaces over a place, or near it: where a surface that was worked out is not the shape's
    /// own, the place moves to where a face is flat.</summary>
    private static bool TryMeasure<TA, TB>(
        ref TA shapeA, ref TB shapeB, in ContactPlane plane, in ContactPlaces places, in ContactPlace place,
        in FlatFeature a, in FlatFeature b, out Candidate candidate)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double u = place.U, v = place.V;
        for (int tries = 0; ; tries++)
        {
            SurfacePoint onA = a.SurfaceAt(u, v, tries == 0 ? place.CornerA : -1);
            SurfacePoint onB = b.SurfaceAt(u, v, tries == 0 ? place.CornerB : -1);
            candidate = new Candidate(u, v, onA.Height, onB.Height, place.Id);
            bool holdsA = a.IsSure || ContactProof.Holds(ref shapeA, true, plane, onA, u, v);
            bool holdsB = b.IsSure || ContactProof.Holds(ref shapeB, false, plane, onB, u, v);
            if (holdsA && holdsB) return true;
            if (tries > 0 || holdsA == holdsB) return false;
            if (holdsA) b.ToFlatPart(ref u, ref v);
            else a.ToFlatPart(ref u, ref v);
            if (!(holdsA ? a : b).Holds(u, v, places.SlackAround)) return false;
        }
    }

    /// <summary>Back from the plane to the shapes and to the world.</summary>
    private static ManifoldPoint Point(
        in Candidate candidate, in ContactPlane plane, in RigidPose poseA, float distance)
    {
        ref readonly PairFrame frame = ref plane.Frame;
        Double3 onA = plane.OnA + plane.Direction(candidate.U, candidate.V, candidate.HeightA);
        Double3 onB = plane.OnA + plane.Direction(candidate.U, candidate.V, -candidate.HeightB);
        Double3 localA = (onA + frame.CenterA) * frame.Unit;
        Double3 localB = (frame.Rotation.InverseRotate(onB - frame.Translation) + frame.CenterB) * frame.Unit;
        double gap = candidate.Gap * frame.Unit;
        Double3 worldA = frame.RotationA.Rotate(localA) + poseA.Position;
        Double3 worldB = worldA + frame.RotationA.Rotate(plane.Normal) * gap;
        if (frame.IsPlaced)
        {
            localA = frame.OutOfA(localA.ToXyz()).ToDouble3();
            localB = frame.OutOfB(localB.ToXyz()).ToDouble3();
        }

        var point = new ManifoldPoint(
            (Vector3)worldA, (Vector3)worldB, (Vector3)localA, (Vector3)localB, Math.Max((float)gap, distance),
            candidate.Id);
        return plane.IsExchanged ? point.Swapped : point;
    }
}
