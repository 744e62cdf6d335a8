using System;
using System.IO;
using System.Linq;
using System.Reflection;
using Gjk.Core;

namespace Gjk.Unity.Checks;

/// <summary>A script has "using UnityEngine;" beside ours: a type of the same name cannot be written there without its
/// namespace. The list holds the engine's public types that a script about physics, geometry or scenes meets, and those
/// whose names a library of this kind might choose; the stubs' own are added.</summary>
public class NameClashTests
{
    private static readonly string[] Names =
    [
        .. File.ReadAllLines(Path.Combine(AppContext.BaseDirectory, "unity-type-names.txt")).SelectMany(
            line => line.Split('#')[0].Split(' ', StringSplitOptions.RemoveEmptyEntries)),
        .. typeof(UnityEngine.Object).Assembly.GetExportedTypes()
            .Where(t => t.Namespace is "UnityEngine" or "UnityEngine.Events" or "UnityEngine.Rendering")
            .Select(t => t.Name.Split('`')[0]),
    ];

    [Theory]
    [InlineData(typeof(ConvexQuery))]
    [InlineData(typeof(GjkPhysics))]
    public void NoPublicTypeIsNamedAsOneOfTheEngines(Type ours)
    {
        Assert.True(Names.Length > 250, $"only {Names.Length} names");
        Assert.Contains("ContactPoint", Names);
        Assembly assembly = ours.Assembly;
        Assert.Empty(assembly.GetExportedTypes().Select(t => t.Name.Split('`')[0]).Intersect(Names));
    }
}
