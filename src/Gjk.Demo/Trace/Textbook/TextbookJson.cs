using System.Text.Json;
using static Gjk.Demo.Trace.TraceJson;

namespace Gjk.Demo.Trace;

/// <summary>The textbook's steps as the page reads them, in the form of the query's own: in A's frame, so that both are
/// drawn in one picture. The numbers are the textbook's; only the page's turn into that frame is in double.</summary>
internal static class TextbookJson
{
    public static void Write(Utf8JsonWriter json, TextbookRun run, SceneObject a, in RelativeFrame bInA)
    {
        json.WriteStartObject("textbook");
        json.WriteString("ending", run.Ending.ToString());
        json.WriteNumber("repeatOf", run.RepeatOf);
        json.WriteNumber("stepCap", TextbookGjk.StepCap);
        Number(json, "distance", run.Distance);
        json.WriteStartArray("steps");
        foreach (TextbookStep step in run.Steps) Write(json, step, a.Pose, bInA);
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, TextbookStep step, in RigidPose pose, in RelativeFrame bInA)
    {
        json.WriteStartObject();
        Vector(json, "normal", Against(bInA.FromWorld(step.Direction)));
        Vector(json, "onA", bInA.FromWorld((Double3)step.Vertex.OnA - pose.Position));
        Vector(json, "onB", bInA.FromWorld((Double3)step.Vertex.OnB - pose.Position));
        Vector(json, "w", bInA.FromWorld(step.Vertex.W));
        Indices(json, "before", step.Before);
        if (step.After is not null)
        {
            Indices(json, "after", step.After);
            Numbers(json, "weights", Array.ConvertAll(step.Weights, weight => (double)weight));
            Vector(json, "nearest", bInA.FromWorld(step.Nearest));
            Number(json, "upper", MathF.Sqrt(TextbookMath.Dot(step.Nearest, step.Nearest)));
        }

        json.WriteEndObject();
    }

    /// <summary>The unit vector against a direction; zero against none.</summary>
    private static Double3 Against(in Double3 direction)
    {
        // No product of sizes that float can hold leaves double's range.
        double length = direction.Length;
        return length > 0 ? direction * (-1 / length) : default;
    }
}
