namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>Where two convex shapes touch: the signed distance, and up to four points that a solver needs to keep
    /// one on the other.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="maxGap">Points further apart than this are left out, in world units; below 0 counts as 0, and NaN
    /// gives <see cref="GjkStatus.InvalidInput"/>. A little more than the shapes can move in a frame, or than a body
    /// rocks, keeps the corners of one that is about to touch.</param>
    /// <param name="manifold">Gets the points: none when the shapes are further apart than <paramref name="maxGap"/> or
    /// invalid. A face on a face has up to four, an edge on a face two, as have parallel cylinders, or a round side
    /// along an edge, a corner one; where two cross deeper between their ends, or a round side leaves a face over an
    /// edge that it runs along, a third may lie there. They hold a point as
    /// deep as the deepest, to within 1e-6 of the size, and span at least 80 % of the largest area that four points of
    /// what is shared can (as measured over random faces, and 99 % on the average). Shapes whose face, edge or corner
    /// there is unknown or round (spheres, ellipsoids, those that show none) have the one pair of deepest points. Every
    /// pair of points lies along the manifold's normal.</param>
    /// <returns>As <c>SignedDistance</c> gives it of the pair or, exchanged, of the exchanged pair, bit for bit, if the
    /// gap is a number.</returns>
    /// <remarks>The pair (B, A) has the result and the points of (A, B), exchanged, to the last bit; only shapes of one
    /// size and margin in the very same pose, which no order tells apart, may differ.</remarks>
    public static DistanceResult Contacts<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxGap, out ContactManifold manifold)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        ContactPlane* plane = stackalloc ContactPlane[1];
        SolveContacts(a, poseA, b, poseB, maxGap, null, plane, out manifold, out DistanceResult result);
        return result;
    }

    /// <summary>As the first, beginning where the last query of the pair ended: faster for pairs that move
    /// little.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated. It may be the
    /// one that <c>Distance</c> and <c>SignedDistance</c> use.</param>
    /// <param name="maxGap">See the first overload.</param>
    /// <param name="manifold">See the first overload.</param>
    /// <returns>As <c>SignedDistance</c> gives it. Within the accuracy that of the cold query.</returns>
    public static DistanceResult Contacts<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart warmStart, float maxGap,
        out ContactManifold manifold)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        ContactPlane* plane = stackalloc ContactPlane[1];
        fixed (WarmStart* warm = &warmStart)
        {
            SolveContacts(a, poseA, b, poseB, maxGap, warm, plane, out manifold, out DistanceResult result);
            return result;
        }
    }

    /// <summary>As the first, and where the contact is.</summary>
    internal static DistanceResult Contacts(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, float maxGap,
        ref ContactPlane plane, out ContactManifold manifold)
    {
        fixed (ContactPlane* found = &plane)
        {
            SolveContacts(a, poseA, b, poseB, maxGap, null, found, out manifold, out DistanceResult result);
            return result;
        }
    }

    /// <summary>The points of a pair along a direction near its normal: where the faces or edges that both show along
    /// it lie opposite each other.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Its pose.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="normal">From A to B, of unit length, in the world.</param>
    /// <param name="maxGap">Points further apart along it are left out.</param>
    /// <param name="plane">Where the contact is; its normal becomes the other one.</param>
    /// <param name="manifold">Gets the points; none where the two show no more than a corner.</param>
    internal static void ContactsAlong(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, in Double3 normal, float maxGap,
        ref ContactPlane plane, out ContactManifold manifold)
    {
        manifold = default;
        manifold.Begin((Vector3)normal);
        if (plane.IsExchanged) AddAlong(b, poseB, a, -normal, maxGap, ref plane, ref manifold);
        else AddAlong(a, poseA, b, normal, maxGap, ref plane, ref manifold);
        if (manifold.Count == 0) manifold.Clear();
    }

    private static void AddAlong(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in Double3 normal, float maxGap,
        ref ContactPlane plane, ref ContactManifold manifold)
    {
        plane.SetAlong(plane.Frame.RotationA.InverseRotate(normal));
        ConvexShape coreA = plane.Frame.IsPlaced ? ShapeTraits<ConvexShape>.Instance.InCoreAxes(a) : a;
        ConvexShape coreB = plane.Frame.IsPlaced ? ShapeTraits<ConvexShape>.Instance.InCoreAxes(b) : b;
        TryAddFaces(ref coreA, poseA, ref coreB, ref plane, float.NegativeInfinity, maxGap, ref manifold, out _);
    }

    /// <summary>Asks in the order that <see cref="PairOrder"/> has.</summary>
    private static void SolveContacts<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxGap, WarmStart* warm,
        ContactPlane* plane, out ContactManifold manifold, out DistanceResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        plane->IsExchanged =
            PairOrder.IsExchanged(ref PairQuery.AsRef(a), poseA, ref PairQuery.AsRef(b), poseB);
        if (!plane->IsExchanged)
        {
            SolveInOrder(a, poseA, b, poseB, maxGap, warm, plane, out manifold, out result);
            return;
        }

        if (warm != null) warm->Exchange();
        SolveInOrder(b, poseB, a, poseA, maxGap, warm, plane, out manifold, out result);
        if (warm != null) warm->Exchange();
        DistanceResult.Exchange(ref result);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveInOrder<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxGap, WarmStart* warm,
        ContactPlane* plane, out ContactManifold manifold, out DistanceResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        float mostGap = maxGap < 0 ? 0 : maxGap;
        var solver = new SignedDistanceSolver<NoPolytopeTrace> { Warm = warm, Plane = plane, PlaneGap = mostGap };
        PairQuery.Run(a, poseA, b, poseB, ref solver, out result);
        UnsafeRef.SkipInit(out manifold);
        manifold.Clear();
        if (!(result.Distance <= mostGap))
        {
            if (float.IsNaN(maxGap)) result = DistanceResult.Invalid(GjkStatus.InvalidInput, 0);
            return;
        }

        manifold.Begin(plane->IsExchanged ? Opposite.Of(result.Normal) : result.Normal);
        bool isKnown = plane->Normal.LengthSquared > 0;
        if (isKnown && HalfSpacePair.IsHalfSpace(ref PairQuery.AsRef(a)))
        {
            var patch = new HalfSpacePatch(plane->Normal, plane->Size);
            AddPlacedPoints(patch, poseA, b, ref *plane, result, mostGap, ref manifold);
        }
        else if (isKnown && plane->Frame.IsPlaced)
        {
            AddPlacedPoints(a, poseA, b, ref *plane, result, mostGap, ref manifold);
        }
        else
        {
            AddPoints(
                ref PairQuery.AsRef(a), poseA, ref PairQuery.AsRef(b), ref *plane, result, mostGap, ref manifold);
        }
    }

    /// <summary>The same for shapes of which one is placed, without the placement.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void AddPlacedPoints<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, ref ContactPlane plane, in DistanceResult result, float maxGap,
        ref ContactManifold manifold)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA coreA = ShapeTraits<TA>.Instance.InCoreAxes(a);
        TB coreB = ShapeTraits<TB>.Instance.InCoreAxes(b);
        AddPoints(ref coreA, poseA, ref coreB, ref plane, result, maxGap, ref manifold);
    }

    /// <summary>Asks both shapes for what they show along the normal.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void AddPoints<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, ref ContactPlane plane, in DistanceResult result, float maxGap,
        ref ContactManifold manifold)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (TryAddFaces(ref a, poseA, ref b, ref plane, result.Distance, maxGap, ref manifold, out long id)) return;
        var point = new ManifoldPoint(
            result.PointA, result.PointB, result.LocalPointA, result.LocalPointB, result.Distance, id);
        manifold.Add(plane.IsExchanged ? point.Swapped : point);
    }

    /// <summary>Adds what two faces or edges share; if they share nothing, only the corners have a name.</summary>
    private static bool TryAddFaces<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, ref ContactPlane plane, float distance, float maxGap,
        ref ContactManifold manifold, out long id)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        FaceCorner* memory = stackalloc FaceCorner[2 * FaceCorners.Capacity];
        var cornersA = new FaceCorners(memory);
        var cornersB = new FaceCorners(memory + FaceCorners.Capacity);
        if (plane.Normal.LengthSquared > 0)
        {
            a.GetFace(plane.Normal, ref cornersA);
            b.GetFace(plane.Frame.Rotation.InverseRotate(-plane.Normal), ref cornersB);
        }

        id = ContactFeature.Of(ContactFeature.OnlyCorner(cornersA), ContactFeature.OnlyCorner(cornersB));
        if (cornersA.Count < 2 || cornersB.Count < 2) return false;
        plane.Span();
        return ContactBuilder.TryBuild(ref a, ref b, plane, cornersA, cornersB, poseA, maxGap, distance, ref manifold);
    }
}
