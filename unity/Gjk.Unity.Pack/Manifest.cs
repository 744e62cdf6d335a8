using System;
using System.Text.Json.Nodes;

namespace Gjk.Unity.Pack;

/// <summary>The package.json of a package that is given away. The one in the repository names no address: there, the
/// Package Manager opens the files of the package itself.</summary>
public static class Manifest
{
    private static readonly (string Field, string File)[] Addresses =
    [
        ("documentationUrl", "Documentation~/index.md"), ("changelogUrl", "CHANGELOG.md"),
        ("licensesUrl", "LICENSE.md"),
    ];

    /// <summary>Adds the repository, and the addresses of the pages in it.</summary>
    /// <param name="text">The file in the repository.</param>
    /// <param name="repository">The clone's remote; a path of this machine stays private.</param>
    /// <param name="version">Of the package; its tag is v and the version.</param>
    public static string Text(string text, string repository, string version)
    {
        if (!repository.StartsWith("https://", StringComparison.Ordinal)) return text;
        JsonObject manifest = JsonNode.Parse(text)!.AsObject();
        string folder = "unity/" + Layout.PackageName;
        manifest["repository"] = new JsonObject { ["type"] = "git", ["url"] = repository, ["directory"] = folder };
        string page = repository.EndsWith(".git", StringComparison.Ordinal) ? repository[..^4] : repository;
        foreach ((string field, string file) in Addresses) manifest[field] = $"{page}/blob/v{version}/{folder}/{file}";
        return manifest.ToJsonString(new() { WriteIndented = true, NewLine = "\n" }) + "\n";
    }
}
