using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Text.Json;
using System.Text.RegularExpressions;
using Gjk.Core;
using Gjk.Unity.Pack;

namespace Gjk.Unity.Checks;

/// <summary>The files of the package, as the Package Manager wants them.</summary>
public partial class PackageFilesTests
{
    private static readonly Layout Layout = Layout.Above(AppContext.BaseDirectory);

    private static string ManifestText => File.ReadAllText(Path.Combine(Layout.Package, "package.json"));

    [Fact]
    public void GeneratedFilesAreCurrent()
    {
        IReadOnlyDictionary<string, string> files = Pack.Package.GeneratedFiles(Layout, GuidList.Read(Layout.GuidFile));
        const string refresh = "; unity/pack.sh refreshes it";
        foreach ((string path, string text) in files)
            Assert.True(File.Exists(path) && File.ReadAllText(path) == text, path + refresh);
        Assert.Empty(Pack.Package.StrayMetas(Layout, files));
    }

    [Fact]
    public void EachPathHasAGuidOfItsOwn()
    {
        GuidList guids = GuidList.Read(Layout.GuidFile);
        Assert.Equal(Layout.PathsWithMeta(), guids.Paths);
        Assert.Equal(guids.Paths.Count, guids.Paths.Select(p => guids[p]).Distinct().Count());
        Assert.All(guids.Paths, p => Assert.Matches("^[0-9a-f]{32}$", guids[p]));
        Assert.Contains("Runtime/Plugins/Gjk.Core.dll", guids.Paths);
        Assert.DoesNotContain(guids.Paths, p => p.StartsWith("Documentation~", StringComparison.Ordinal));
    }

    /// <summary>Users' scenes hold these: a change would break them all.</summary>
    [Theory]
    [InlineData("Runtime/Plugins/Gjk.Core.dll")]
    [InlineData("Runtime/Gjk.Unity.asmdef")]
    [InlineData("Runtime/Components/ConvexDistance.cs")]
    [InlineData("Runtime/Components/ProximitySensor.cs")]
    public void PublishedGuidsAreTheDerivedOnes(string path) =>
        Assert.Equal(GuidList.Derive(path), GuidList.Read(Layout.GuidFile)[path]);

    [Fact]
    public void ARenamedPathKeepsTheGuidOfTheList()
    {
        GuidList guids = GuidList.Read(Layout.GuidFile);
        string path = guids.Paths.First(), guid = guids[path];
        guids.Update([path, "new"]);
        Assert.Equal(2, guids.Paths.Count);
        Assert.Equal(guid, guids[path]);
        Assert.Equal(GuidList.Derive("new"), guids["new"]);
    }

    [Fact]
    public void VersionsAgree()
    {
        using var manifest = JsonDocument.Parse(ManifestText);
        string version = manifest.RootElement.GetProperty("version").GetString()!;
        string informational = typeof(ConvexQuery).Assembly
            .GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;
        Assert.Equal(informational.Split('+')[0], version);
        string changes = File.ReadAllText(Path.Combine(Layout.Package, "CHANGELOG.md"));
        Assert.Equal(version, Heading().Match(changes).Groups["version"].Value);
        string library = Path.Combine(Layout.Plugins, Layout.Library[0]);
        Assert.Equal(version.Split('-')[0] + ".0", AssemblyName.GetAssemblyName(library).Version!.ToString());
    }

    [Fact]
    public void TheManifestIsThatOfAPackage()
    {
        using var manifest = JsonDocument.Parse(ManifestText);
        Assert.Equal(Layout.PackageName, manifest.RootElement.GetProperty("name").GetString());
        Assert.Equal("2021.3", manifest.RootElement.GetProperty("unity").GetString());
        foreach (JsonElement sample in manifest.RootElement.GetProperty("samples").EnumerateArray())
        {
            string folder = Path.Combine(Layout.Package, sample.GetProperty("path").GetString()!);
            Assert.NotEmpty(Directory.GetFiles(folder, "*.unity"));
        }

        foreach (string file in new[] { "README.md", "CHANGELOG.md", "LICENSE.md", "Documentation~/index.md" })
            Assert.True(File.Exists(Path.Combine(Layout.Package, file)), file);
        Assert.Equal(
            File.ReadAllText(Path.Combine(Layout.Root, "LICENSE")),
            File.ReadAllText(Path.Combine(Layout.Package, "LICENSE.md")));
    }

    /// <summary>Relative addresses open nothing; those of a release lead to the repository.</summary>
    [Fact]
    public void AReleaseNamesTheRepository()
    {
        Assert.DoesNotContain("Url", ManifestText);
        Assert.Equal(ManifestText, Manifest.Text(ManifestText, "/home/me/gjk", "1.2.3"));
        using var manifest = JsonDocument.Parse(Manifest.Text(ManifestText, "https://example.org/gjk.git", "1.2.3"));
        JsonElement root = manifest.RootElement;
        Assert.Equal("https://example.org/gjk.git", root.GetProperty("repository").GetProperty("url").GetString());
        Assert.Equal("unity/com.gjk.core", root.GetProperty("repository").GetProperty("directory").GetString());
        foreach (string field in new[] { "documentationUrl", "changelogUrl", "licensesUrl" })
        {
            string address = root.GetProperty(field).GetString()!;
            string file = address["https://example.org/gjk/blob/v1.2.3/".Length..];
            Assert.True(File.Exists(Path.Combine(Layout.Root, file)), address);
        }

        Assert.Equal(Layout.PackageName, root.GetProperty("name").GetString());
    }

    [Theory]
    [InlineData("Runtime/Gjk.Unity.asmdef", "Gjk.Unity")]
    [InlineData("Editor/Gjk.Unity.Editor.asmdef", "Gjk.Unity.Editor")]
    [InlineData("Tests/Gjk.Unity.Tests.asmdef", "Gjk.Unity.Tests")]
    public void AssemblyDefinitionsReferToTheOneLibrary(string file, string name)
    {
        using var definition = JsonDocument.Parse(File.ReadAllText(Path.Combine(Layout.Package, file)));
        JsonElement root = definition.RootElement;
        Assert.Equal(name, root.GetProperty("name").GetString());
        Assert.True(root.GetProperty("overrideReferences").GetBoolean());
        Assert.Equal("Gjk.Core.dll", root.GetProperty("precompiledReferences")[0].GetString());
        Assert.Single(Directory.GetFiles(Layout.Package, "*.dll", SearchOption.AllDirectories));
    }

    [Fact]
    public void TheLibraryInThePackageReferencesNothingButNetStandard()
    {
        using var file = new PEReader(File.OpenRead(Path.Combine(Layout.Plugins, Layout.Library[0])));
        MetadataReader reader = file.GetMetadataReader();
        IEnumerable<string> references = reader.AssemblyReferences
            .Select(r => reader.GetString(reader.GetAssemblyReference(r).Name));
        Assert.Equal(["netstandard"], references);
    }

    [Fact]
    public void TheLibraryInThePackageIsTheOneThatTheLockNames() =>
        Assert.True(LibraryLock.NamesThePackagesFiles(Layout), "unity/pack.sh refreshes the DLL and the lock");

    /// <summary>What the manuals of Unity 6.0 to 7.0 alpha call obsolete and a package like this could use. From 6.5 on
    /// the instance ids are errors. The assembly is compiled with the defines of 6.4 and later.</summary>
    [Fact]
    public void NewerUnityIsAskedNothingObsolete()
    {
        string folder = Path.Combine(Layout.Root, "unity", "Gjk.Unity.Newer", "bin");
        string newer = Directory.GetFiles(folder, "Gjk.Unity.Newer.dll", SearchOption.AllDirectories)
            .MaxBy(File.GetLastWriteTimeUtc)!;
        using var file = new PEReader(File.OpenRead(newer));
        MetadataReader reader = file.GetMetadataReader();
        string[] used =
        [
            .. reader.TypeReferences.Select(t => reader.GetString(reader.GetTypeReference(t).Name)),
            .. reader.MemberReferences.Select(m => reader.GetString(reader.GetMemberReference(m).Name)),
        ];
        Assert.Contains("FindObjectsByType", used);
        string[] obsolete =
        [
            "FindObjectOfType", "FindObjectsOfType", "FindObjectsSortMode", "GetInstanceID", "InstanceIDToObject",
            "PhysicMaterial", "get_drag", "get_angularDrag", "get_velocity",
        ];
        Assert.DoesNotContain(used, obsolete.Contains);
    }

    [Fact]
    public void RuntimeSourcesDoNotNeedAnEditor()
    {
        foreach (string folder in new[] { "Runtime", "Samples~" })
        {
            foreach (string file in Sources(folder))
                Assert.DoesNotContain("UnityEditor", File.ReadAllText(file), StringComparison.Ordinal);
        }
    }

    /// <summary>In Unity a script is found by the name of its file.</summary>
    [Fact]
    public void AScriptIsNamedAsItsFile()
    {
        foreach (string file in Sources("Runtime").Concat(Sources("Samples~")))
        {
            Match script = Behaviour().Match(File.ReadAllText(file));
            if (script.Success) Assert.Equal(Path.GetFileNameWithoutExtension(file), script.Groups["name"].Value);
        }
    }

    [Theory]
    [InlineData("Samples~/Visualizer/Visualizer.unity", 6, 0)]
    [InlineData("Samples~/MeasureTest/MeasureTest.unity", 40, 1)]
    [InlineData("Samples~/Jobs/Jobs.unity", 20, 0)]
    [InlineData("Samples~/Benchmark/Benchmark.unity", 20, 0)]
    public void ReferencesInASceneAreResolved(string path, int meshes, int inactive)
    {
        string scene = File.ReadAllText(Path.Combine(Layout.Package, path));
        string[] ids = [.. Header().Matches(scene).Select(m => m.Groups["id"].Value)];
        Assert.Equal(ids.Length, ids.Distinct().Count());
        foreach (Match reference in LocalReference().Matches(scene))
            Assert.Contains(reference.Groups["id"].Value, ids.Append("0"));
        GuidList guids = GuidList.Read(Layout.GuidFile);
        string[] scripts = [.. ScriptReference().Matches(scene).Select(m => m.Groups["guid"].Value)];
        string folder = Path.Combine(Layout.Package, Path.GetDirectoryName(path)!);
        string script = Directory.GetFiles(folder, "*.cs").Single(f => Behaviour().IsMatch(File.ReadAllText(f)));
        Assert.Equal([guids[Path.GetRelativePath(Layout.Package, script).Replace('\\', '/')]], scripts);
        Assert.Equal(meshes, Header().Matches(scene).Count(m => m.Groups["class"].Value == "33"));
        Assert.Equal(inactive, scene.Split("m_IsActive: 0").Length - 1);
    }

    private static string[] Sources(string folder) =>
        Directory.GetFiles(Path.Combine(Layout.Package, folder), "*.cs", SearchOption.AllDirectories);

    [GeneratedRegex(@"^## \[(?<version>[^\]]+)\]", RegexOptions.Multiline)]
    private static partial Regex Heading();

    [GeneratedRegex(@"class (?<name>\w+) : MonoBehaviour")]
    private static partial Regex Behaviour();

    [GeneratedRegex(@"^--- !u!(?<class>\d+) &(?<id>\d+)$", RegexOptions.Multiline)]
    private static partial Regex Header();

    [GeneratedRegex(@"\{fileID: (?<id>\d+)\}")]
    private static partial Regex LocalReference();

    [GeneratedRegex(@"\{fileID: 11500000, guid: (?<guid>[0-9a-f]+), type: 3\}")]
    private static partial Regex ScriptReference();
}
