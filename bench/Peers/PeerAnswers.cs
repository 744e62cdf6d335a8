using System.Text;
using Gjk.Exact.Cases;

namespace Gjk.Bench.Peers;

/// <summary>Writes what every engine answers to the pairs of <c>tests/Cases</c>, in the columns that
/// <c>gjk-demo judge</c> reads. A family with a shape that the engines' programs do not know is left out; so is an
/// engine that breaks off.</summary>
internal static class PeerAnswers
{
    public static void Run(TextWriter progress, string project, string target)
    {
        string cases = Path.Combine(project, "..", "tests", "Cases");
        Directory.CreateDirectory(target);
        PeersRun.WithEngines(progress, project, (processes, folder) =>
        {
            string file = Path.Combine(folder, "pairs.bin");
            var running = new List<PeerProcess>(processes);
            foreach (string name in CaseFile.Distances.Concat(CaseFile.Depths))
            {
                var family = CaseFile.Read(cases, name);
                if (!TryWrite(file, family)) progress.WriteLine($"{name}: left out, the programs lack a shape");
                else running.RemoveAll(engine => !TryAnswer(progress, engine, file, family, target));
            }
        });
    }

    private static bool TryWrite(string file, CaseFile family)
    {
        var scene = new BenchScene();
        foreach (PosedShape o in family.Objects)
        {
            // The file of pairs has no scales.
            if (o.Shape.Kind == ShapeKind.Mesh && o.Shape.Scale != System.Numerics.Vector3.One) return false;
            scene.Add(o.Shape, o.Pose);
        }

        foreach (CasePair pair in family.Pairs) scene.AddPair(pair.IndexA, pair.IndexB);
        try
        {
            PairFile.Write(file, scene.Build());
            return true;
        }
        catch (NotSupportedException)
        {
            return false;
        }
    }

    /// <returns>False if the engine has ended.</returns>
    private static bool TryAnswer(TextWriter progress, PeerProcess engine, string file, CaseFile family, string target)
    {
        PeerVerb verb = family.Kind == CaseKind.Depth ? PeerVerb.Depth : PeerVerb.Distance;
        try
        {
            engine.Load(file);
            if (!engine.Can(verb)) return true;
            (bool Overlap, double Value)[] answers = engine.Answers(verb, family.Pairs.Count);
            var text = new StringBuilder("a,b,overlap,distance\n");
            for (int i = 0; i < answers.Length; i++)
            {
                (bool overlap, double value) = answers[i];
                CasePair pair = family.Pairs[i];

                // A query for the depth has no distance of a pair that is apart.
                string number = verb == PeerVerb.Distance ? Text(value) : overlap ? Text(-value) : "";
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"{pair.IndexA},{pair.IndexB},{(overlap ? "true" : "false")},{number}\n");
            }

            File.WriteAllText(Path.Combine(target, $"{engine.Name}.{family.Name}.csv"), text.ToString());
            return true;
        }
        catch (Exception e) when (e is FactorCheckException or IOException)
        {
            progress.WriteLine($"{engine.Name}: broke off in {family.Name}");
            return false;
        }
    }

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
