using System.Text.Json;

namespace Gjk.Demo.Replay;

/// <summary>Writes the replay's figures and results as JSON. Numbers that are not finite become null, because JSON
/// cannot express them, and so do figures that do not apply to a scene.</summary>
internal static class ReplayJson
{
    public static void Write(Stream stream, IReadOnlyList<SceneReport> reports) =>
        WriteScenes(stream, reports, WriteScene);

    public static void Write(Stream stream, IReadOnlyList<WorldReport> reports) =>
        WriteScenes(stream, reports, WriteWorld);

    private static void WriteScenes<T>(Stream stream, IReadOnlyList<T> reports, Action<Utf8JsonWriter, T> write)
    {
        using (var json = new Utf8JsonWriter(stream))
        {
            json.WriteStartObject();
            json.WriteStartArray("scenes");
            foreach (T report in reports) write(json, report);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
    }

    private static void WriteScene(Utf8JsonWriter json, SceneReport report)
    {
        json.WriteStartObject();
        json.WriteString("name", report.Name);
        json.WriteNumber("objects", report.ObjectNames.Length);
        Write(json, "vertices_per_object", report.VerticesPerObject);
        Write(json, "hull_vertices", report.HullVertices);
        json.WriteNumber("calls_per_frame", report.Results.Length);
        json.WriteNumber("intersecting_pairs", report.IntersectingPairs);
        json.WriteNumber("loops_per_call", report.LoopsPerCall);
        json.WriteNumber("frames", report.Frames);
        json.WriteNumber("ms_per_frame_median", report.MedianMs);
        json.WriteNumber("ms_per_frame_p99", report.P99Ms);
        Write(json, "support_share", report.SupportShare);
        json.WriteNumber("bytes_per_call", report.BytesPerCall);
        json.WriteNumber("iteration_limits", report.IterationLimits);
        json.WriteString("hash", report.Hash);
        json.WriteStartArray("pairs");
        for (int i = 0; i < report.Results.Length; i++) WritePair(json, report.A[i], report.B[i], report.Results[i]);
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteWorld(Utf8JsonWriter json, WorldReport report)
    {
        json.WriteStartObject();
        json.WriteString("name", report.Name);
        json.WriteNumber("objects", report.Objects);
        json.WriteNumber("vertices_per_object", report.VerticesPerObject);
        json.WriteNumber("hull_vertices", report.HullVertices);
        json.WriteString("broad", report.Settings.BroadPhaseName);
        json.WriteNumber("motion", report.Settings.Speed);
        json.WriteNumber("threads", report.Settings.Threads);
        json.WriteNumber("pairs_per_frame", report.PairsPerFrame);
        json.WriteNumber("calls_per_frame", report.CallsPerFrame);
        json.WriteNumber("calls_saved_per_frame", report.CallsSavedPerFrame);
        json.WriteNumber("intersecting_pairs", report.IntersectingPairs);
        json.WriteNumber("frames", report.Frames);
        json.WriteNumber("ms_broad_median", report.BroadMs);
        json.WriteNumber("ms_narrow_median", report.NarrowMs);
        json.WriteNumber("ms_per_frame_median", report.MedianMs);
        json.WriteNumber("ms_per_frame_p99", report.P99Ms);
        json.WriteNumber("bytes_per_frame", report.BytesPerFrame);
        json.WriteNumber("hashed_frames", report.CountedFrames);
        json.WriteString("hash", report.Hash);
        json.WriteStartArray("pairs");
        foreach (ObjectPair pair in report.FirstPairs)
        {
            json.WriteStartObject();
            json.WriteNumber("a", pair.A);
            json.WriteNumber("b", pair.B);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>Writes the columns of the CSV as fields.</summary>
    private static void WritePair(Utf8JsonWriter json, int a, int b, in DistanceResult result)
    {
        json.WriteStartObject();
        json.WriteNumber("a", a);
        json.WriteNumber("b", b);
        json.WriteString("status", result.Status.ToString());
        json.WriteBoolean("overlap", result.IsOverlapping);
        Write(json, "distance", result.Distance);
        Write(json, "lower_bound", result.LowerBound);
        Write(json, "ax", result.PointA.X);
        Write(json, "ay", result.PointA.Y);
        Write(json, "az", result.PointA.Z);
        Write(json, "bx", result.PointB.X);
        Write(json, "by", result.PointB.Y);
        Write(json, "bz", result.PointB.Z);
        Write(json, "nx", result.Normal.X);
        Write(json, "ny", result.Normal.Y);
        Write(json, "nz", result.Normal.Z);
        json.WriteNumber("iterations", result.Iterations);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, string name, double? value)
    {
        if (value is { } number) json.WriteNumber(name, number);
        else json.WriteNull(name);
    }

    /// <summary>Adding 0 turns -0 into 0.</summary>
    private static void Write(Utf8JsonWriter json, string name, float value)
    {
        if (float.IsFinite(value)) json.WriteNumber(name, value + 0f);
        else json.WriteNull(name);
    }
}
