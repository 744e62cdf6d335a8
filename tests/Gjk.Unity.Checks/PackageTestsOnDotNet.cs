using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Loader;
using System.Runtime.Versioning;
using Gjk.Unity.Pack;

namespace Gjk.Unity.Checks;

/// <summary>The tests inside the package, run without an engine.</summary>
[Collection(nameof(OneScene))]
public class PackageTestsOnDotNet
{
    private const string TestAssembly = "Gjk.Unity.Tests";

    private static readonly Assembly Tests = Assembly.Load(TestAssembly);

    public static TheoryData<string> Names => new(PackageTestRunner.TestsOf(Tests).Select(PackageTestRunner.NameOf));

    [Theory]
    [MemberData(nameof(Names))]
    public void Passes(string name) =>
        PackageTestRunner.Run(PackageTestRunner.TestsOf(Tests).Single(t => PackageTestRunner.NameOf(t) == name));

    /// <summary>Those above run with the build for .NET 10, which Unity's CoreCLR may take some day, though the package
    /// is compiled against .NET Standard.</summary>
    [Fact]
    public void TheLibraryBesideThemIsTheBuildForNet10()
    {
        Assert.Equal(".NETCoreApp,Version=v10.0", Target(typeof(Gjk.Core.ConvexQuery).Assembly));
        Assert.Equal(".NETStandard,Version=v2.1", Target(typeof(GjkPhysics).Assembly));
    }

    /// <summary>With the DLL that a Git URL installs, which may be behind the library. Where this fails and the others
    /// do not, unity/pack.sh refreshes the DLL.</summary>
    [Fact]
    public void AllPassWithTheLibraryInThePackage()
    {
        var layout = Layout.Above(AppContext.BaseDirectory);
        var context = new PackageContext(layout.Plugins);
        IReadOnlyList<MethodInfo> tests = PackageTestRunner.TestsOf(context.LoadFromAssemblyName(new(TestAssembly)));
        foreach (MethodInfo test in tests) PackageTestRunner.Run(test);
        Assert.True(tests.Count > 25, $"only {tests.Count} tests");
        Assembly library = context.Assemblies.Single(a => a.GetName().Name == "Gjk.Core");
        Assert.Equal(Path.Combine(layout.Plugins, Layout.Library[0]), library.Location);
    }

    private static string Target(Assembly assembly) =>
        assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;

    /// <summary>Loads the package's own library, and another copy of what was compiled against it.</summary>
    private sealed class PackageContext(string plugins) : AssemblyLoadContext("the package")
    {
        private static readonly string[] Copied = [TestAssembly, "Gjk.Unity", "UnityStubs"];

        protected override Assembly? Load(AssemblyName assemblyName)
        {
            string name = assemblyName.Name!;
            if (name == "Gjk.Core") return LoadFromAssemblyPath(Path.Combine(plugins, name + ".dll"));
            return Copied.Contains(name)
                ? LoadFromAssemblyPath(Path.Combine(AppContext.BaseDirectory, name + ".dll"))
                : null;
        }
    }
}

/// <summary>The stubs have one scene for all, so that tests with game objects take turns.</summary>
[CollectionDefinition(nameof(OneScene))]
public class OneScene
{
}
