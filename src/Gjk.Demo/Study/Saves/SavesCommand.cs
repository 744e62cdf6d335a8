using System.CommandLine;
using System.Globalization;
using System.Text;
using System.Threading;
using Gjk.Demo.Output;

namespace Gjk.Demo.Study.Saves;

/// <summary>The command <c>study saves</c>: what thresholds are worth in a scene of moving objects.</summary>
internal static class SavesCommand
{
    private static readonly PairRule[] Rules =
        [PairRule.Exact, PairRule.ProvedSpheres, PairRule.TolerantSpheres, PairRule.SpheresOnly];

    public static Command Build(CancellationToken cancel)
    {
        var thresholds = new Argument<string>("THRESHOLDS")
        {
            Description = "The CSV that study fit wrote.",
        };
        Option<string> scene = StudyCommand.Word("--scene", "The objects of the scene.", "spheres", "cubes");
        Option<int> frames = StudyCommand.Whole("--frames", "How many frames to run.", 100, 1, 100_000);
        Option<double> unit = StudyCommand.Real(
            "--unit", "The length in the scene, whose objects have the size 1, of a unit of the study.", 1, 1e-9, 1e9);
        Option<string?> output =
            StudyCommand.Output("Write the table to this file instead of standard output.", "FILE.csv");
        var command = new Command(
            "saves",
            "Say how many queries and how much time a scene of 20 and of 2,000 moving objects saves with thresholds as "
            + "tolerances, and how many errors that makes.")
        {
            thresholds, scene, frames, unit, output,
        };
        command.SetAction(r =>
        {
            string file = r.GetValue(thresholds)!;
            TargetFiles.Check(file, "the thresholds", ("--out", r.GetValue(output)));
            string text = Encoding.UTF8.GetString(InputFile.Read(file, cancel));
            Tolerance tolerance = Tolerance.Read(InputFile.NameOf(file), text);
            string table = Table(tolerance, r.GetValue(scene)!, r.GetValue(unit), r.GetValue(frames), cancel);
            StudyCommand.Write(cancel, (r.GetValue(output), table));
            return ExitCode.Done;
        });
        return command;
    }

    private static string Table(Tolerance tolerance, string name, double unit, int frames, CancellationToken cancel)
    {
        var csv = new StringBuilder("scene,objects,observers,threshold,rule,pairs,queries,saved,ms,wrong,seen\n");
        foreach (int objects in (int[])[20, 2_000])
        {
            BuiltInScene scene = name == "cubes" ? BuiltInScenes.Cubes(objects) : BuiltInScenes.Spheres(objects);
            var saved = new SavedQueries(scene, tolerance, unit);
            foreach (PairRule rule in Rules) saved.Run(rule, 2, cancel);
            foreach (PairRule rule in Rules)
            {
                RuleCost cost = saved.Run(rule, frames, cancel);
                double share = cost.Pairs > 0 ? 1 - cost.Queries / cost.Pairs : 0;
                string who = tolerance.IsSimulated ? "simulated" : "people";
                csv.Append(
                    CultureInfo.InvariantCulture, $"{name},{objects},{who},{tolerance.Curve.Pse * unit:G4},{rule},");
                csv.Append(CultureInfo.InvariantCulture, $"{cost.Pairs:F2},{cost.Queries:F2},{share:F3},");
                csv.Append(CultureInfo.InvariantCulture, $"{cost.Milliseconds:F4},{cost.Wrong:F3},{cost.Seen:F3}\n");
            }
        }

        return csv.ToString();
    }
}
