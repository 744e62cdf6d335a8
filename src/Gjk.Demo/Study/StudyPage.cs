using System.CommandLine;
using System.Text.Json;
using Gjk.Demo.Play;
using Gjk.Demo.Study.Plan;
using Gjk.Demo.View;

namespace Gjk.Demo.Study;

/// <summary>The command <c>study page</c>: a study as one page that needs no network. The page carries the library,
/// jsPsych and the plan, with each shape as a record of the library.</summary>
internal static class StudyPage
{
    public static Command Build(CancellationToken cancel)
    {
        Option<string?> plan = StudyCommand.Named("--plan", "The plan; the default one if none is given.", "PLAN.json");
        var output = new Option<string>("--out")
        {
            Description = "Write the page to this file.",
            HelpName = "FILE.html",
            Required = true,
        };
        var command = new Command(
            "page", "Write the study as a page for a browser: one file that needs no network and sends nothing.")
        {
            plan, output,
        };
        command.SetAction(r =>
        {
            string html = r.GetValue(output)!;
            TargetFiles.Check(r.GetValue(plan), "the plan", ("--out", html));
            StudyPlan study = StudyCommand.LoadPlan(r.GetValue(plan), cancel);
            Check(study);
            using var file = new AtomicFile(html, cancel);
            using var data = new PageData();
            Write(data.Json, study);
            ScriptPage.Write(file.Stream, study.Name, data.Text, "study", "jspsych.LICENSE.txt");
            file.Commit();
            StandardError.Line($"wrote the study to {html}");
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>Places every trial once, so that a gap that cannot be met is refused here and not in front of a
    /// person.</summary>
    private static void Check(StudyPlan plan)
    {
        foreach (PairPlan pair in plan.Pairs)
        {
            var place = new Placement(pair, Vector3.UnitX);
            foreach (float gap in plan.Constant?.Gaps ?? []) place.Position(gap);
            foreach (float start in plan.Adjustment?.Starts ?? []) place.Position(start);
            if (plan.CatchTrials > 0) place.Position(-plan.CatchGap);
            foreach (string collider in plan.Mismatch?.Colliders ?? [])
                _ = new Placement(pair with { B = Collider.Of(pair.B, collider) }, Vector3.UnitY);
        }
    }

    private static void Write(Utf8JsonWriter json, StudyPlan plan)
    {
        json.WriteStartObject();
        json.WriteString("id", plan.Id);
        json.WriteString("name", plan.Name);
        json.WriteNumber("seed", plan.Seed);
        json.WriteString("consent", plan.Consent);
        json.WriteString("instructions", plan.Instructions);
        json.WriteBoolean("questions", plan.HasQuestions);
        json.WriteNumber("viewingDistance", plan.ViewingDistance);
        json.WriteNumber("practice", plan.PracticeTrials);
        json.WriteNumber("catchTrials", plan.CatchTrials);
        json.WriteNumber("catchGap", plan.CatchGap);
        json.WriteNumber("breakEvery", plan.BreakEvery);
        json.WriteStartArray("pairs");
        foreach (PairPlan pair in plan.Pairs) Write(json, pair, plan.Mismatch?.Colliders ?? []);
        json.WriteEndArray();
        json.WriteStartArray("views");
        foreach (ViewPlan view in plan.Views) Write(json, view);
        json.WriteEndArray();
        WriteTasks(json, plan);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, PairPlan pair, string[] colliders)
    {
        json.WriteStartObject();
        json.WriteString("name", pair.Name);
        json.WriteString("a", RecordOf(pair.A));
        json.WriteString("b", RecordOf(pair.B));
        Write(json, "rotationA", pair.RotationA);
        Write(json, "rotationB", pair.RotationB);
        json.WriteStartObject("colliders");
        foreach (string name in colliders) json.WriteString(name, RecordOf(Collider.Of(pair.B, name)));
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, ViewPlan view)
    {
        json.WriteStartObject();
        json.WriteString("name", view.Name);
        json.WriteString("camera", view.Camera);
        json.WriteNumber("yaw", view.Yaw);
        json.WriteNumber("pitch", view.Pitch);
        json.WriteBoolean("shadow", view.HasShadow);
        json.WriteBoolean("texture", view.HasTexture);
        json.WriteString("background", view.Background);
        json.WriteEndObject();
    }

    private static void WriteTasks(Utf8JsonWriter json, StudyPlan plan)
    {
        if (plan.Adjustment is { } adjustment)
        {
            json.WriteStartObject("adjustment");
            json.WriteNumber("repeats", adjustment.Repeats);
            Write(json, "starts", adjustment.Starts);
            json.WriteNumber("fine", adjustment.Fine);
            json.WriteNumber("coarse", adjustment.Coarse);
            json.WriteEndObject();
        }

        if (plan.Constant is { } constant)
        {
            json.WriteStartObject("constant");
            json.WriteNumber("repeats", constant.Repeats);
            Write(json, "gaps", constant.Gaps);
            json.WriteNumber("cross", constant.Cross);
            json.WriteNumber("milliseconds", constant.Milliseconds);
            json.WriteNumber("mask", constant.Mask);
            json.WriteEndObject();
        }

        if (plan.Mismatch is not { } mismatch) return;
        json.WriteStartObject("mismatch");
        json.WriteNumber("repeats", mismatch.Repeats);
        json.WriteStartArray("colliders");
        foreach (string name in mismatch.Colliders) json.WriteStringValue(name);
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, string name, params float[] numbers)
    {
        json.WriteStartArray(name);
        foreach (float number in numbers) json.WriteNumberValue(number);
        json.WriteEndArray();
    }

    private static void Write(Utf8JsonWriter json, string name, Quaternion q) => Write(json, name, q.X, q.Y, q.Z, q.W);

    /// <summary>A record whose first body has the shape; the page reads only that.</summary>
    private static string RecordOf(in ConvexShape shape) =>
        new QueryRecord(shape, RigidPose.Identity, ConvexShape.Point(), RigidPose.Identity).ToString();
}
