using System.Globalization;
using System.IO;
using System.Text;
using System.Threading;

namespace Gjk.Mutation;

/// <summary>The process that runs tests: it may hang or die of a mutant. Commands come line by line on the standard
/// input; what tests print is dropped.</summary>
internal static class TestServer
{
    public static int Run(string tests)
    {
        using var output = new StreamWriter(Console.OpenStandardOutput(), new UTF8Encoding(false));
        output.AutoFlush = true;
        Console.SetOut(TextWriter.Null);
        Console.SetError(TextWriter.Null);
        var catalog = new TestCatalog(tests);

        // Tests get the stack that xunit gives them.
        var thread = new Thread(() => Serve(catalog, output));
        thread.Start();
        thread.Join();
        return 0;
    }

    private static void Serve(TestCatalog catalog, TextWriter output)
    {
        output.WriteLine("ready");
        while (Console.In.ReadLine() is { } line)
        {
            string[] words = line.Split(' ');
            if (words[0] == "record") Record(catalog, output, [.. words[1].Split(',')]);
            else Try(catalog, output, int.Parse(words[1], CultureInfo.InvariantCulture), words[2]);
        }
    }

    /// <summary>Each test that is not known, without a mutant: its time on the processor, whether it passes, what it
    /// reaches.</summary>
    private static void Record(TestCatalog catalog, TextWriter output, HashSet<string> known)
    {
        foreach (string method in catalog.Methods)
        {
            if (known.Contains(method)) continue;
            int rows = catalog.RowsOf(method);
            for (int row = 0; row < rows; row++)
            {
                Array.Clear(catalog.Reached!);
                TimeSpan before = Environment.CpuUsage.TotalTime;
                string? fault = catalog.Run(method, row, 0);
                TimeSpan used = Environment.CpuUsage.TotalTime - before;
                string time = used.TotalSeconds.ToString("F4", CultureInfo.InvariantCulture);
                string reached = string.Join(
                    ",",
                    Enumerable.Range(0, catalog.Reached!.Length).Where(i => catalog.Reached[i] != 0).Select(
                        i => catalog.Reached[i] == 1 ? $"{i}" : $"{i}={catalog.Reached[i]}"));
                output.WriteLine($"{method}\t{row}\t{time}\t{fault ?? "ok"}\t{reached}");
            }
        }

        output.WriteLine("end");
    }

    /// <summary>Tests until one fails that passes without the mutant.</summary>
    private static void Try(TestCatalog catalog, TextWriter output, int mutant, string tests)
    {
        foreach (string test in tests.Split(','))
        {
            string[] parts = test.Split(':');
            string method = parts[0];
            int row = int.Parse(parts[1], CultureInfo.InvariantCulture);
            output.WriteLine($"start\t{test}");
            string? fault = catalog.Run(method, row, mutant);
            if (fault is null) continue;
            bool isSpoiled = catalog.Run(method, row, 0) is not null;
            output.WriteLine($"{(isSpoiled ? "spoiled" : "killed")}\t{test}\t{fault}");
            return;
        }

        output.WriteLine("survived");
    }
}
