using System.CommandLine;

namespace Gjk.Demo.Study.Saves;

/// <summary>The command <c>study saves</c>: what thresholds are worth in a scene of moving objects.</summary>
internal static class SavesCommand
{
    /// <summary>Object sizes per frame.</summary>
    private const double Speed = 0.02;

    private static readonly PairRule[] Rules =
        [PairRule.Exact, PairRule.ProvedSpheres, PairRule.TolerantSpheres, PairRule.SpheresOnly];

    public static Command Build(CancellationToken cancel)
    {
        var thresholds = new Argument<string>("THRESHOLDS")
        {
            Description = "The CSV that study fit wrote.",
        };
        var scene = new Option<string>("--scene")
        {
            Description = "The objects: spheres or cubes, 20 and 2,000 of them, or those of a scene file, which begin "
                + "where the file has them and move at random.",
            HelpName = "spheres|cubes|SCENE.json",
            DefaultValueFactory = _ => "spheres",
        };
        Option<int> frames = StudyCommand.Whole("--frames", "How many frames to run.", 100, 1, 100_000);
        Option<double> unit = StudyCommand.Real(
            "--unit", "The length in the scene of a unit of the study. Built-in objects have the size 1.", 1, 1e-9,
            1e9);
        Option<string?> output =
            StudyCommand.Output("Write the table to this file instead of standard output.", "FILE.csv");
        var command = new Command(
            "saves",
            "Say how many queries and how much time a scene of moving objects saves with thresholds as tolerances, and "
            + "how many errors that makes.")
        {
            thresholds, scene, frames, unit, output,
        };
        command.SetAction(r =>
        {
            string file = r.GetValue(thresholds)!;
            TargetFiles.Check(file, "the thresholds", ("--out", r.GetValue(output)));
            string text = Encoding.UTF8.GetString(InputFile.Read(file, cancel));
            Tolerance tolerance = Tolerance.Read(InputFile.NameOf(file), text);
            string table = Table(
                Moving(r.GetValue(scene)!, cancel), tolerance, r.GetValue(unit), r.GetValue(frames), cancel);
            StudyCommand.Write(cancel, (r.GetValue(output), table));
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>The scenes that a name stands for, with their rooms and speeds.</summary>
    /// <exception cref="RefusedException">The file is no scene of two or more convex objects.</exception>
    public static IEnumerable<(Scene Scene, Aabb Room, double Speed)> Moving(string name, CancellationToken cancel)
    {
        if (name is not ("spheres" or "cubes"))
        {
            Scene scene = SceneFile.Load(name, cancel).Convex(InputFile.NameOf(name), "study saves");
            if (scene.Objects.Length < 2)
                throw new RefusedException($"{InputFile.NameOf(name)}: $.objects: at least two are needed");
            return [(scene, RoomOf(scene), Speed * scene.Objects.Average(o => 2 * o.Shape.BoundingRadius))];
        }

        return ((int[])[20, 2_000]).Select(objects =>
        {
            BuiltInScene built = name == "cubes" ? BuiltInScenes.Cubes(objects) : BuiltInScenes.Spheres(objects);
            return (Scene.From(built), built.Room, Speed);
        });
    }

    /// <summary>The box around the objects' positions.</summary>
    private static Aabb RoomOf(Scene scene)
    {
        Vector3 least = scene.Objects[0].Pose.Position, most = least;
        foreach (SceneObject each in scene.Objects)
        {
            least = Vector3.Min(least, each.Pose.Position);
            most = Vector3.Max(most, each.Pose.Position);
        }

        return new Aabb(least, most);
    }

    /// <summary>The costs of all rules, as CSV.</summary>
    public static string Table(
        IEnumerable<(Scene Scene, Aabb Room, double Speed)> scenes, Tolerance tolerance, double unit, int frames,
        CancellationToken cancel)
    {
        var csv = new StringBuilder("scene,objects,observers,threshold,rule,pairs,queries,saved,ms,wrong,seen\n");
        foreach ((Scene scene, Aabb room, double speed) in scenes)
        {
            var saved = new SavedQueries(scene, room, speed, tolerance, unit);
            foreach (PairRule rule in Rules) saved.Run(rule, 2, cancel);
            foreach (PairRule rule in Rules)
            {
                RuleCost cost = saved.Run(rule, frames, cancel);
                double share = cost.Pairs > 0 ? 1 - cost.Queries / cost.Pairs : 0;
                string who = tolerance.IsSimulated ? "simulated" : "people";
                csv.Append(
                    CultureInfo.InvariantCulture, $"{PlainText.CsvField(scene.Name)},{scene.Objects.Length},{who},");
                csv.Append(CultureInfo.InvariantCulture, $"{tolerance.Curve.Pse * unit:G4},{rule},");
                csv.Append(CultureInfo.InvariantCulture, $"{cost.Pairs:F2},{cost.Queries:F2},{share:F3},");
                csv.Append(CultureInfo.InvariantCulture, $"{cost.Milliseconds:F4},{cost.Wrong:F3},{cost.Seen:F3}\n");
            }
        }

        return csv.ToString();
    }
}
