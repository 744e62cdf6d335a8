using System;
using System.IO;
using System.Linq;
using System.Text.Json;

namespace Gjk.Unity.Pack;

internal static class Program
{
    private const string Usage = """
        Gjk.Unity.Pack refresh [--force]   brings the generated files of unity/com.gjk.core up to date
        Gjk.Unity.Pack export DIR REMOTE [--release]   writes the package with the build's DLL, and a tarball, to DIR
        """;

    private static int Main(string[] args)
    {
        Layout layout = Layout.Above(AppContext.BaseDirectory);
        if (!File.Exists(Path.Combine(layout.Build, Layout.Library[0])))
        {
            Console.Error.WriteLine("Build first: dotnet build src/Gjk.Core -c Release -f netstandard2.1");
            return 2;
        }

        switch (args)
        {
            case ["refresh", .. string[] rest] when rest.All(a => a == "--force"):
                Console.WriteLine(Package.Refresh(layout, rest.Length > 0));
                return 0;
            case ["export", string target, string repository, .. string[] rest] when rest.All(a => a == "--release"):
                return Export(layout, target, repository, rest.Length > 0);
            default:
                Console.Error.WriteLine(Usage);
                return 2;
        }
    }

    private static int Export(Layout layout, string target, string repository, bool isRelease)
    {
        using var manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(layout.Package, "package.json")));
        string version = manifest.RootElement.GetProperty("version").GetString()!;
        Console.WriteLine($"wrote {Package.Export(layout, version, target, repository)}");
        string packed = Path.Combine(target, Layout.PackageName, "Runtime", "Plugins", Layout.Library[0]);
        byte[] dll = File.ReadAllBytes(packed);
        byte[] built = File.ReadAllBytes(Path.Combine(layout.Build, Layout.Library[0]));
        if (!dll.AsSpan().SequenceEqual(built))
        {
            Console.Error.WriteLine("The DLL in the package is not the build's.");
            return 1;
        }

        if (LibraryLock.IsCurrent(layout) && LibraryLock.NamesThePackagesFiles(layout)) return 0;
        const string behind = "The DLL in the repository, which a Git URL installs, is behind the sources: "
            + "unity/pack.sh refreshes it.";
        Console.WriteLine(behind);
        return isRelease ? 1 : 0;
    }
}
