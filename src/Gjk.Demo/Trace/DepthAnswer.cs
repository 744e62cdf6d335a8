namespace Gjk.Demo.Trace;

/// <summary>How deep two objects overlap, and how the query found it.</summary>
internal sealed class DepthAnswer
{
    private DepthAnswer(in DistanceResult result, DepthSearch search)
    {
        Result = result;
        Search = search;
    }

    public DistanceResult Result { get; }

    public DepthSearch Search { get; }

    public static DepthAnswer Of(SceneObject a, SceneObject b)
    {
        var search = new DepthSearch();
        var recorder = new DepthRecorder(search);
        DistanceResult result = ConvexQuery.ExplainDepth(a.Shape, a.Pose, b.Shape, b.Pose, ref recorder);
        return new DepthAnswer(result, search);
    }
}
