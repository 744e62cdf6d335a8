using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Runtime.CompilerServices;

namespace Gjk.Core.Tests.Api;

/// <summary>What Mono's compiler makes slow, found in a build: it keeps no struct in registers, clears large locals by
/// a call even where a path never touches them, and copies large structs by a call through native code.</summary>
internal static class CostOnMono
{
    /// <summary>Bytes: a larger struct is not passed by value. Two words travel in registers.</summary>
    private const int MostByValue = 16;

    /// <summary>Bytes: a larger local is cleared by a call of memset.</summary>
    private const int MostLocal = 64;

    /// <summary>The folders that a query goes through, in each round or once.</summary>
    private static readonly string[] Hot =
    [
        "Arithmetic/", "Geometry/", "Minkowski/", "Simplex/", "Cores/", "Contacts/", "Shapes/", "Queries/", "Solvers/",
        "Concave/", "World/",
    ];

    /// <summary>Parts of those that tell what happens in a search, and rays, which no pair of shapes is.</summary>
    private static readonly string[] Rare = ["Solvers/Trace/", "Queries/Rays/"];

    private static readonly MethodInfo SizeOf = typeof(Unsafe).GetMethod(nameof(Unsafe.SizeOf))!;

    /// <summary>Methods with a local of a type parameter's type: a shape that is copied before a method of its
    /// interface is called, because it came as a readonly reference.</summary>
    public static IEnumerable<string> CopiedShapes(Assembly library) =>
        from method in HotMethods(library)
        where method.GetMethodBody()?.LocalVariables.Any(l => l.LocalType.IsGenericParameter) == true
        select NameOf(method);

    /// <summary>Methods that take a large struct by value. What an interface of .NET asks for cannot do
    /// otherwise.</summary>
    public static IEnumerable<string> ByValue(Assembly library) =>
        from method in HotMethods(library)
        where method.Name is not ("Equals" or "CompareTo")
        where method.GetParameters().Any(p => SizeOfType(p.ParameterType) > MostByValue)
        select NameOf(method);

    /// <summary>Methods with a large local.</summary>
    public static IEnumerable<string> LargeLocals(Assembly library) =>
        from method in HotMethods(library)
        where method.GetMethodBody()?.LocalVariables.Any(l => SizeOfType(l.LocalType) > MostLocal) == true
        select NameOf(method);

    private static IEnumerable<MethodBase> HotMethods(Assembly library)
    {
        const BindingFlags all = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static
            | BindingFlags.Instance | BindingFlags.DeclaredOnly;
        using FileStream file = File.OpenRead(Path.ChangeExtension(library.Location, ".pdb"));
        using var provider = MetadataReaderProvider.FromPortablePdbStream(file);
        MetadataReader symbols = provider.GetMetadataReader();
        foreach (Type type in library.GetTypes())
        {
            if (type.Name.Contains('<')) continue;
            foreach (MethodBase method in type.GetMethods(all).Cast<MethodBase>().Concat(type.GetConstructors(all)))
                if (IsHot(SourceOf(symbols, method))) yield return method;
        }
    }

    /// <summary>The source file below src/Gjk.Core; empty for a method without statements.</summary>
    private static string SourceOf(MetadataReader symbols, MethodBase method)
    {
        const string root = "Gjk.Core/";
        MethodDefinitionHandle handle = MetadataTokens.MethodDefinitionHandle(method.MetadataToken & 0xFFFFFF);
        MethodDebugInformation debug = symbols.GetMethodDebugInformation(handle);
        DocumentHandle document = debug.Document.IsNil
            ? debug.GetSequencePoints().FirstOrDefault().Document
            : debug.Document;
        if (document.IsNil) return "";
        string name = symbols.GetString(symbols.GetDocument(document).Name);
        return name[(name.LastIndexOf(root, StringComparison.Ordinal) + root.Length)..];
    }

    private static bool IsHot(string source) =>
        Hot.Any(f => source.StartsWith(f, StringComparison.Ordinal))
        && !Rare.Any(f => source.StartsWith(f, StringComparison.Ordinal));

    private static string NameOf(MethodBase method) =>
        $"{method.DeclaringType!.Name.Split('`')[0]}.{method.Name.Split('.')[^1]}";

    /// <summary>0 for what is no struct, and for one that depends on a type parameter.</summary>
    private static int SizeOfType(Type type) =>
        type.IsByRef || type.IsPointer || !type.IsValueType || type.ContainsGenericParameters
            ? 0
            : (int)SizeOf.MakeGenericMethod(type).Invoke(null, null)!;
}
