using System.Diagnostics;
using System.Reflection;
using System.Text;

namespace Gjk.Docs.Tests;

/// <summary>A temporary folder that holds the files of a page, in which its commands run.</summary>
internal sealed class PageFolder : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    /// <summary>Writes the blocks that name a file (<c>json crates.json</c>, <c>text part.obj</c>) to the
    /// folder.</summary>
    public PageFolder(IEnumerable<CodeBlock> blocks)
    {
        Name = Directory.CreateTempSubdirectory("gjk-page-").FullName;
        foreach (CodeBlock block in blocks)
        {
            string? file = block.Words.Skip(1).FirstOrDefault(w => w.Contains('.'));
            if (file is not null) File.WriteAllText(Path.Combine(Name, Path.GetFileName(file)), block.Text);
        }
    }

    public string Name { get; }

    /// <summary>Runs a script of the page in which <c>gjk-demo</c> is the demo, and returns what it prints.</summary>
    public string Run(string script)
    {
        string demo = typeof(PageFolder).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
            .Single(a => a.Key == "DemoAssembly").Value!;
        string host = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        var start = new ProcessStartInfo("sh")
        {
            WorkingDirectory = Name,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            StandardOutputEncoding = new UTF8Encoding(false),
        };
        // A function of a POSIX shell has no hyphen in its name, so the command's name is replaced.
        start.ArgumentList.Add("-ec");
        start.ArgumentList.Add("demo() { \"$0\" \"$GJK_DEMO\" \"$@\"; }\n" + script.Replace("gjk-demo ", "demo "));
        start.ArgumentList.Add(host);
        start.Environment["GJK_DEMO"] = demo;
        using Process process = Process.Start(start)!;
        var error = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        Assert.True(process.WaitForExit(Patience), $"does not end: {script}");
        Assert.True(process.ExitCode == 0, $"exit code {process.ExitCode} of {script}{error.Result}");
        return output;
    }

    public void Dispose() => Directory.Delete(Name, recursive: true);
}
