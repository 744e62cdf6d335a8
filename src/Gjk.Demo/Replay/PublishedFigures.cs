namespace Gjk.Demo.Replay;

/// <summary>Table 1 of the report "Implementing GJK as a plugin for Unity" (2022). It was measured in Unity 2020.3 on
/// Mono with the deep profiler, on an Intel i5-6600K.</summary>
internal sealed class PublishedFigures
{
    public const string Machine = "Unity 2020.3, Mono, deep profiler, Intel i5-6600K";

    private PublishedFigures(int vertices, double loopsPerCall, double msPerFrame, string supportShare)
    {
        Vertices = vertices;
        LoopsPerCall = loopsPerCall;
        MsPerFrame = msPerFrame;
        SupportShare = supportShare;
    }

    public int Objects => 20;

    public int Vertices { get; }

    public int CallsPerFrame => 190;

    public double LoopsPerCall { get; }

    public double MsPerFrame { get; }

    public string SupportShare { get; }

    /// <summary>Those of one of the report's own scenes.</summary>
    public static PublishedFigures Of(string scene) => scene switch
    {
        "cubes" => new PublishedFigures(24, 4.05, 21, "about 60 %"),
        "spheres" => new PublishedFigures(515, 4.15, 120, "over 90 %"),
        _ => throw new ArgumentOutOfRangeException(nameof(scene), scene, "The report has no such scene."),
    };
}
