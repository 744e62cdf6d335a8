namespace Gjk.Core.Tests.Api;

/// <summary>The rules that keep single queries fast on Mono, Unity's runtime, held in the builds that it gets. Each
/// exception has a reason, and fails here when nothing needs it.</summary>
public class BuildCostOnMonoTests
{
    private const string Given = "a public method: the shape comes as a readonly reference, and is copied once",
        Decorator = "a shape around another: it keeps the other read-only, so each call of it copies",
        Trace = "only where a trace listens or a text is asked for",
        Making = "makes or compares shapes, which no query does",
        State = "the state of the search, which each round uses",
        Exact = "106 bits: entered where doubles prove nothing",
        Placed = "placed shapes, once for each query",
        Range = "only directions near the ends of a double's range",
        Answer = "the answer, or the frame of the question, once for each query",
        Conversion = "from and to System.Numerics, for users; no query calls it",
        Contact = "the contact of two parts that meet, which costs thousands of operations",
        Cover = "asked of parts that meet, whether others cover them; each goes through a list or a tree",
        Part = "a part or a shape that was asked about, copied into what queries take",
        Way = "the way out and the bodies around it, once for each depth",
        Back = "the pose to go back to";

    private static readonly (string Method, string Reason)[] CopiedShapes =
    [
        ("Placement.GetFace", Given), ("ShapeTraits.cctor", Making), ("PlacedTraits.InCoreAxes", Decorator),
        ("Guard.NotNull", Making), ("PairFrame.Tighten", Given),
        ("UnitSized.*", Decorator), ("ConvexQuery.AddPlacedPoints", Placed), ("PairQuery.SolveCopies", Given),
        ("Placed.*", Decorator), ("Rounded.*", Decorator), ("Scaled.*", Decorator),
        ("HalfSpacePair.Solve", "the core of the other shape, once for each query"), ("PairAnswers.LastAnswer", Answer),
    ];

    private static readonly (string Method, string Reason)[] ByValue =
    [
        ("SegmentCore.UnitDot", Range), ("TriangleCore.FurthestInUnits", Range),
        ("XyzExtensions.ToDouble3", "so short that Mono inlines it unasked"),
        ("PairFrame.OutOfA", Placed), ("PairFrame.OutOfB", Placed), ("ConvexQuery.SettleImpact", Answer),
        ("ShapeParts.set_Scale", Making),
        ("ClosestPointWeights.FaceWeightsExtended", Exact), ("ClosestPointWeights.VolumeWeightsExtended", Exact),
        ("NextSimplex.Nearest", "where more than one face sees the origin"),
        ("BestNormal.set_Normal", "once for each normal"),
        ("GjkDistance.Stop", "once for each search"), ("GjkDistance.TraceReduction", Trace),
        ("Proofs.IsCertainlyInside", "once, where the simplex may hold the origin"),
        ("DeepestPoint.MakeContact", "it changes its copy"), ("CompoundShape.BoxOf", Making),
        ("BoxFit.set_Origin", Making),
    ];

    private static readonly (string Method, string Reason)[] LargeLocals =
    [
        ("ContactBuilder.*", State), ("MeetingEdges.IsOverFace", State),
        ("ContactManifold.get_Swapped", Answer), ("PairContacts.get_Swapped", Answer),
        ("DistanceResult.get_Swapped", Answer), ("ContactPlaces.*", State),
        ("AxisScale.Frame", Placed), ("BodyForm.*", "round shapes of the depth, once"),
        ("Placement.GetFace", State), ("RigidPose.*", Conversion),
        ("ConvexQuery.*", Answer), ("DistanceFinish.ToWorld", Answer), ("DistanceSolver.SolveAsPoints", Trace),
        ("DistanceSolver.SolvePoints", State), ("SignedDistanceSolver.SolveAsPoints", Trace), ("ConvexShape.*", Making),
        ("Scaled.GetFace", State), ("ScaledLayer.AreEqual", Making),
        ("NextSimplex.DistanceSquared", "where more than one face sees the origin"), ("BestNormal.ctor", State),
        ("GjkDistance.*", State), ("GjkExtendedPrecision.Solve", Exact), ("GjkOverlap.Solve", State),
        ("SideNormal.*", "shapes that touch at their sides"), ("SettledContact.MeasureAtStart", Answer),
        ("ImpactQuestion.*", Answer), ("RayQuestion.TryBegin", Answer), ("MetFeatures.Of", Answer),
        ("Polytope.Grow", "once, in the few searches that outgrow the first room"),
        ("AnyShape.*", Making), ("CompoundShape.*", Making), ("CompoundPart.ctor", Making),
        ("TriangleMesh.GetShape", Part),
        ("TriangleMesh.GetMassProperties", Making), ("MassProperties.*", Making),
        ("ConeShape.GetMass", Making), ("CylinderShape.GetMass", Making), ("EllipsoidShape.GetMass", Making),
        ("TaperedCapsuleShape.GetMass", Making),
        ("UnionLift.*", Answer), ("PartsCast.*", Answer), ("UnionCast.*", Answer),
        ("ConcaveQuery.*", Answer), ("PartQuery.*", Part), ("PartPairSearch.*", Answer), ("PartCastSearch.*", Part),
        ("Containment.*", Answer), ("ConcaveScratch.*", Answer), ("SolidExit.*", Answer), ("TreeFrame.Compose", Answer),
        ("BoxFit.TryGetSpread", Making), ("PlaneProof.*", Cover), ("TrianglesApart.*", Part),
        ("OutwardContact.*", Contact), ("SolidInside.*", Answer),
        ("CoveredSides.*", Cover), ("PartsCover.*", Cover), ("PairsAtPoint.*", Cover), ("SeamContacts.*", Contact),
        ("ContactPush.*", Contact), ("FlushSides.*", Contact), ("FaceSearch.*", Contact), ("TipContact.*", Contact),
        ("TouchLine.*", Contact), ("DeepFaces.*", Contact),
        ("DeepestPoint.*", Contact),
        ("AxialDepth.*", State), ("CornerDepth.*", Way), ("CylinderDepth.*", Way), ("PairForm.*", Way),
        ("BoxDepth.Solve", State), ("BoxDepthPoints.Find", "once, for the ends of the way that was found"),
        ("DepthBounds.StoreWithPoints", "where B is beyond the way out, once for each depth"),
        ("DepthCells.Search", State),
        ("GjkDepth.Solve", State), ("GjkDepth.TraceStep", Trace), ("HullArc.TryWalk", State), ("HullDepth.*", State),
        ("SignedSolver.SolveDepthLast", "the common point of shapes that only touch, and else the start of a search"),
        ("SignedSolver.SolveRound", Way), ("SignedSolver.SolveLarge", Way), ("SignedSolver.TraceSearch", Trace),
        ("SignedSolver.TraceRound", Trace), ("SmoothNormal.*", State),
        ("AdvancementSolver.Solve", State), ("AdvancementSolver.TryLeave", Back), ("CastNormal.*", State),
        ("CastPortal.Solve", State), ("CastSolver.Find", State), ("ContactFollower.Solve", State),
        ("ContactFollower.TryEnd", Back), ("DeepeningSolver.*", State),
        ("TurningBody.Measure", "each so many steps, for all axes"), ("TurningPlane.Choose", State),
        ("CollisionScene.*", "once for each question about the whole scene"), ("NearestSearch.*", Answer),
        ("MovingShape.*", Answer), ("FirstCastHit.*", Answer), ("FirstRayHit.*", Part), ("AllCastHits.*", Answer),
        ("SceneObjects.DepthOf", Answer), ("SceneObjects.ContactsOf", Answer),
        ("HalfSpaceMotion.*", State), ("HalfSpacePair.*", Answer), ("SimultaneousHits.*", Contact),
        ("SceneRayJob.Run", State),
        ("SceneDistanceJob.SolveConcave", "once for some dozens of pairs"), ("ScenePartQueries.*", Part),
        ("SceneUnions.*", Contact), ("JoinedGrounds.*", Cover), ("PartSide.*", Cover),
        ("ShapeBounds.BoxAt", "the turned axes, of which each object that moved needs all"),
        ("ShapeBounds.ctor", Making),
    ];

    [Fact]
    public void NoShapeIsCopiedBeforeACall() => Hold(CostOnMono.CopiedShapes(BuildUnderTest.Library), CopiedShapes);

    [Fact]
    public void NoLargeStructIsPassedByValue() => Hold(CostOnMono.ByValue(BuildUnderTest.Library), ByValue);

    [Fact]
    public void NoLargeLocalIsClearedInVain() => Hold(CostOnMono.LargeLocals(BuildUnderTest.Library), LargeLocals);

    /// <summary>The rules find what they look for.</summary>
    [Fact]
    public void TheRulesSeeTheLibrary()
    {
        Assert.Contains("ConvexQuery.Contacts", CostOnMono.LargeLocals(BuildUnderTest.Library));
        Assert.Contains("Rounded.Support", CostOnMono.CopiedShapes(BuildUnderTest.Library));
    }

    private static void Hold(IEnumerable<string> found, (string Method, string Reason)[] exceptions)
    {
        string[] all = [.. found.Distinct()];
        string[] unnamed = [.. all.Where(m => !exceptions.Any(e => Covers(e.Method, m)))];
        Assert.True(unnamed.Length == 0, $"costs on Mono, without a reason here: {string.Join(", ", unnamed)}");
        string[] idle = [.. exceptions.Select(e => e.Method).Where(e => !all.Any(m => Covers(e, m)))];
        Assert.True(idle.Length == 0, $"needs no exception: {string.Join(", ", idle)}");
    }

    private static bool Covers(string exception, string method) =>
        exception == method
        || (exception.EndsWith(".*", StringComparison.Ordinal)
            && method.StartsWith(exception[..^1], StringComparison.Ordinal));
}
