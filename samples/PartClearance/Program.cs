using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using System.Threading;
using Gjk.Core;
using Gjk.Import;

namespace PartClearance;

/// <summary>Writes which parts of a folder are closer to each other than a clearance, as CSV.</summary>
internal static class Program
{
    private const int Done = 0, Refused = 2, Cancelled = 130, MadeParts = 500;

    private static int Main(string[] args)
    {
        using var cancel = new CancellationTokenSource();
        Console.CancelKeyPress += (_, e) =>
        {
            e.Cancel = true;
            cancel.Cancel();
        };
        try
        {
            return Run(args, cancel.Token);
        }
        catch (OperationCanceledException)
        {
            return Cancelled;
        }
        catch (Exception e) when (e is IOException or InvalidDataException or ImportException
            or UnauthorizedAccessException)
        {
            Console.Error.WriteLine(e.Message);
            return Refused;
        }
    }

    private static int Run(string[] args, CancellationToken cancel)
    {
        var folder = new Argument<string>("FOLDER")
        {
            Description = $"The folder with the parts: files that end in {Importer.Endings}.",
        };
        var within = new Option<float>("--within")
        {
            Description = "The largest clearance that is reported, in the unit of the files.",
            HelpName = "DISTANCE",
            DefaultValueFactory = _ => 1,
            CustomParser = ParseDistance,
        };
        var output = new Option<string?>("--out") { Description = "Write the CSV to this file.", HelpName = "FILE" };
        var make = new Option<bool>("--make") { Description = $"Write {MadeParts} parts to FOLDER instead." };
        var concave = new Option<bool>("--concave")
        {
            Description = "Take meshes as they are, and not as their hulls; with --make, write a chain of 10 links.",
        };
        folder.Validators.Add(r =>
        {
            if (r.Tokens is [{ Value: ['-', ..] } token]) r.AddError($"{token.Value}: there is no such option.");
        });
        var root = new RootCommand("Writes the pairs of parts that are closer than a clearance as CSV.")
        {
            folder, within, output, make, concave,
        };
        root.SetAction(r =>
        {
            bool isConcave = r.GetValue(concave);
            if (!r.GetValue(make))
                Measure(r.GetValue(folder)!, isConcave, r.GetValue(within), r.GetValue(output), cancel);
            else if (isConcave) PartMaker.WriteChain(r.GetValue(folder)!);
            else PartMaker.Write(r.GetValue(folder)!, MadeParts);
            return Done;
        });
        ParseResult parsed = root.Parse(args);
        if (parsed.Errors.Count > 0)
            throw new InvalidDataException(string.Join(" ", parsed.Errors.Select(e => e.Message)));
        return parsed.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false });
    }

    private static float ParseDistance(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (float.TryParse(text, CultureInfo.InvariantCulture, out float distance) && distance >= 0) return distance;
        result.AddError($"--within {text}: must be a number, at least 0.");
        return default;
    }

    private static void Measure(
        string folder, bool isConcave, float within, string? output, CancellationToken cancel)
    {
        List<Part> parts = PartReader.ReadFolder(folder, isConcave, n => Progress($"{n} parts read"), cancel);
        List<Gap> gaps = Clearance.Find(parts, within, (n, all) => Progress($"{n} of {all} pairs"), cancel);
        string csv = ToCsv(parts, gaps);
        Progress("");
        if (output is null) Console.Out.Write(csv);
        else WriteFile(output, csv);
        Console.Error.WriteLine($"{parts.Count} parts, {gaps.Count} pairs within {within}");
    }

    /// <summary>Writes the whole file or, if the disk is full, none of it.</summary>
    private static void WriteFile(string file, string text)
    {
        string temporary = file + ".tmp";
        try
        {
            File.WriteAllText(temporary, text);
            File.Move(temporary, file, overwrite: true);
        }
        catch
        {
            File.Delete(temporary);
            throw;
        }
    }

    private static string ToCsv(List<Part> parts, List<Gap> gaps)
    {
        var csv = new StringBuilder("a,b,status,clearance,ax,ay,az,bx,by,bz\n");
        foreach ((ObjectPair pair, DistanceResult r) in gaps)
        {
            // Adding zero turns -0 into 0.
            (Vector3 p, Vector3 q) = (r.PointA + Vector3.Zero, r.PointB + Vector3.Zero);
            csv.Append($"{Quoted(parts[pair.A].Name)},{Quoted(parts[pair.B].Name)},{r.Status},")
                .Append(FormattableString.Invariant($"{r.Distance},{p.X},{p.Y},{p.Z},{q.X},{q.Y},{q.Z}\n"));
        }

        return csv.ToString();
    }

    private static string Quoted(string name) =>
        name.AsSpan().ContainsAny(",\"\r\n") ? $"\"{name.Replace("\"", "\"\"")}\"" : name;

    /// <summary>Shows one line on a terminal, over the one before; a pipe gets none.</summary>
    private static void Progress(string text)
    {
        if (!Console.IsErrorRedirected) Console.Error.Write($"\r{text,-30}\r");
    }
}
