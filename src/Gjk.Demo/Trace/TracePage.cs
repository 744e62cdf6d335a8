using System.Text.Json;
using Gjk.Demo.View;
using static Gjk.Demo.Trace.TraceJson;

namespace Gjk.Demo.Trace;

/// <summary>The page of one query. It shows both shapes and their Minkowski difference in A's frame, and every
/// step.</summary>
internal static class TracePage
{
    /// <summary>The distance from the origin to the furthest point of the Minkowski difference as it is drawn. With a
    /// fixed value no size is too small or too large to draw.</summary>
    private const double DrawnRadius = 10;

    /// <param name="stream">Where to write.</param>
    /// <param name="scene">The scene of both shapes.</param>
    /// <param name="pair">The indices of both shapes.</param>
    /// <param name="steps">The recorded steps of the query.</param>
    /// <param name="result">The answer of the query.</param>
    /// <param name="depth">The search for the depth, where the shapes overlap.</param>
    /// <param name="isExample">The textbook fails on the pair: the page opens where it does.</param>
    public static void Write(
        Stream stream, Scene scene, (int A, int B) pair, List<TraceStep> steps, in DistanceResult result,
        DepthAnswer? depth, bool isExample)
    {
        SceneObject a = scene.Objects[pair.A], b = scene.Objects[pair.B];
        var bInA = new RelativeFrame(a.Pose, b.Pose);
        double reach = (bInA.Place(b.Shape.Center) - a.Shape.Center).Length
            + a.Shape.BoundingRadius + b.Shape.BoundingRadius;
        double unit = reach > 0 ? DrawnRadius / reach : 1;
        string nameA = a.Name ?? $"#{pair.A}", nameB = b.Name ?? $"#{pair.B}";
        using var data = new PageData();
        Utf8JsonWriter json = data.Json;
        json.WriteStartObject();
        json.WriteString("kind", "trace");
        json.WriteBoolean("isExample", isExample);
        json.WriteString("name", scene.Name);
        json.WriteString("nameA", nameA);
        json.WriteString("nameB", nameB);
        json.WriteNumber("unit", unit);
        json.WriteNumber("marginA", a.Shape.Margin);
        json.WriteNumber("marginB", b.Shape.Margin);
        Numbers(json, "rotation", bInA.Quaternion());
        Vector(json, "position", bInA.Position);
        json.WritePropertyName("shapeA");
        ScenePage.WriteShape(data, ShapeMesh.Of(a.Shape));
        json.WritePropertyName("shapeB");
        ScenePage.WriteShape(data, ShapeMesh.Of(b.Shape));
        json.WritePropertyName("difference");
        ScenePage.WriteShape(data, DifferenceMesh.Of(a.Shape, b.Shape, bInA, unit, Vertices(steps, depth)));
        WriteResult(json, result, bInA);
        WriteSteps(json, steps);
        if (depth is not null) WriteDepth(json, depth, bInA);
        TextbookJson.Write(json, TextbookGjk.Run(a, b), a, bInA);
        Lesson.Write(json);
        json.WriteEndObject();
        HtmlPage.Write(
            stream, $"{scene.Name}: {nameA} – {nameB}",
            [
                ("steps", steps.Count), ("iterations", result.Iterations),
                ("depth-steps", depth?.Search.Steps.Count ?? 0), ("a", pair.A), ("b", pair.B),
            ],
            data.Text);
    }

    private static void WriteResult(Utf8JsonWriter json, in DistanceResult result, in RelativeFrame bInA)
    {
        json.WriteStartObject("result");
        json.WriteString("status", result.Status.ToString());
        Number(json, "distance", result.Distance);
        Number(json, "lowerBound", result.LowerBound);
        Vector(json, "normal", bInA.FromWorld(result.Normal));
        Vector(json, "pointA", result.LocalPointA);
        json.WriteNumber("iterations", result.Iterations);
        json.WriteEndObject();
    }

    private static void WriteSteps(Utf8JsonWriter json, List<TraceStep> steps)
    {
        json.WriteStartArray("steps");
        foreach (TraceStep step in steps)
        {
            json.WriteStartObject();
            Vector(json, "normal", step.Support.Normal * (1 / step.Support.Normal.Length));
            Vector(json, "onA", step.Support.PointOnA);
            Vector(json, "onB", step.Support.PointOnB);
            Vector(json, "w", step.Support.Vertex);
            json.WriteNumber("idA", step.Support.IdA);
            json.WriteNumber("idB", step.Support.IdB);
            Number(json, "lower", step.Support.LowerBound);
            json.WriteBoolean("extended", step.Support.IsExtended);
            Indices(json, "before", step.Before);
            if (step.After is not null)
            {
                Indices(json, "after", step.After);
                Numbers(json, "weights", step.Weights);
                Vector(json, "nearest", step.Nearest);
                Number(json, "upper", step.UpperBound);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteDepth(Utf8JsonWriter json, DepthAnswer depth, in RelativeFrame bInA)
    {
        json.WriteStartObject("depth");
        WriteResult(json, depth.Result, bInA);
        json.WriteStartArray("vertices");
        foreach (Double3 v in depth.Search.Vertices) NumbersOf(json, [v.X, v.Y, v.Z]);
        json.WriteEndArray();
        json.WriteStartArray("steps");
        foreach (DepthStep step in depth.Search.Steps)
        {
            json.WriteStartObject();
            json.WriteString("outcome", step.Outcome.ToString());
            json.WriteNumber("count", step.Faces);
            json.WriteNumber("room", step.Room);
            Number(json, "below", step.Below);
            Number(json, "above", step.Above);
            if (step.Lowest >= 0)
            {
                json.WriteNumber("lowest", step.Lowest);
                json.WriteNumber("vertex", step.Vertex);
                Vector(json, "normal", -step.Support.Normal);
                Vector(json, "onA", step.Support.PointOnA);
                Vector(json, "onB", step.Support.PointOnB);
                json.WriteNumber("idA", step.Support.IdA);
                json.WriteNumber("idB", step.Support.IdB);
                Indices(json, "removed", step.Removed);
                json.WriteStartArray("added");
                foreach ((int number, int a, int b, int c) in step.Added) NumbersOf(json, [number, a, b, c]);
                json.WriteEndArray();
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static IEnumerable<Double3> Vertices(List<TraceStep> steps, DepthAnswer? depth)
    {
        foreach (TraceStep step in steps) yield return step.Support.Vertex;
        foreach (Double3 vertex in depth?.Search.Vertices ?? []) yield return vertex;
    }
}
