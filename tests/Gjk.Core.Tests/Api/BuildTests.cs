using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;

namespace Gjk.Core.Tests.Api;

/// <summary>The right build is under test, and it references nothing that a Unity project would lack.</summary>
public class BuildTests
{
    [Fact]
    public void TheBuildIsTheOneTheProjectAskedFor() =>
        Assert.Equal(BuildUnderTest.Expected, BuildUnderTest.TargetFramework);

    [Fact]
    public void ItReferencesOnlyWhatItsTargetBrings()
    {
        using FileStream file = File.OpenRead(BuildUnderTest.Library.Location);
        using var image = new PEReader(file);
        MetadataReader reader = image.GetMetadataReader();
        string[] references =
            [.. reader.AssemblyReferences.Select(r => reader.GetString(reader.GetAssemblyReference(r).Name)).Order()];
        switch (BuildUnderTest.TargetFramework)
        {
            case ".NETStandard,Version=v2.1":
                Assert.Equal(["netstandard"], references);
                break;
            case ".NETStandard,Version=v2.0":
                Assert.Equal(["System.Numerics.Vectors", "netstandard"], references);
                break;
            default:
                Assert.All(references, r => Assert.StartsWith("System.", r));
                break;
        }
    }

    /// <summary>Cryptography, compression and the network are OpenSSL's, zlib's and the resolver's on Linux: a program
    /// ends, or a call throws, where those are not installed.</summary>
    [Fact]
    public void ItNeedsNoLibraryOfTheSystem()
    {
        using FileStream file = File.OpenRead(BuildUnderTest.Library.Location);
        using var image = new PEReader(file);
        MetadataReader reader = image.GetMetadataReader();
        string[] used = [.. reader.TypeReferences.Select(r => reader.GetTypeReference(r).Namespace).Distinct()
            .Select(reader.GetString)];
        Assert.Contains("System", used);
        Assert.DoesNotContain(used, n => n.StartsWith("System.Security.Cryptography", StringComparison.Ordinal));
        Assert.DoesNotContain(used, n => n.StartsWith("System.Net", StringComparison.Ordinal));
        Assert.DoesNotContain(used, n => n.StartsWith("System.IO.Compression", StringComparison.Ordinal));
    }

    /// <summary>Ahead-of-time compilers refuse reflection or make boxes of it, so what a type of shape can do is asked
    /// of the type itself. Attributes are reflection in name only.</summary>
    [Fact]
    public void ItUsesNoReflection()
    {
        using FileStream file = File.OpenRead(BuildUnderTest.Library.Location);
        using var image = new PEReader(file);
        MetadataReader reader = image.GetMetadataReader();
        string[] used = [.. from h in reader.TypeReferences
                            let t = reader.GetTypeReference(h)
                            let space = reader.GetString(t.Namespace)
                            where space == "System.Reflection" || space == "System.Reflection.Emit"
                            let name = reader.GetString(t.Name)
                            where !name.EndsWith("Attribute", StringComparison.Ordinal)
                            select $"{space}.{name}"];
        Assert.Empty(used);
        string[] members =
            [.. reader.MemberReferences.Select(m => reader.GetString(reader.GetMemberReference(m).Name))];
        Assert.Contains("Sqrt", members);
        Assert.DoesNotContain("CreateDelegate", members);
        Assert.DoesNotContain("CreateInstance", members);
        Assert.DoesNotContain("MakeGenericType", members);
        EntityHandle[] parents = [.. reader.TypeDefinitions.Select(t => reader.GetTypeDefinition(t).BaseType)];
        Assert.DoesNotContain(parents, p => p.Kind == HandleKind.TypeReference
            && reader.GetString(reader.GetTypeReference((TypeReferenceHandle)p).Name) == "MulticastDelegate");
    }

    /// <summary>A delegate of a struct's method holds a copy of the struct on the heap.</summary>
    [Fact]
    public void ItMakesNoDelegateOfAStructsMethod()
    {
        using FileStream file = File.OpenRead(BuildUnderTest.Library.Location);
        using var image = new PEReader(file);
        MetadataReader reader = image.GetMetadataReader();
        string[] made = [.. from h in reader.MethodDefinitions
                            let m = reader.GetMethodDefinition(h)
                            where m.RelativeVirtualAddress != 0
                            let body = image.GetMethodBody(m.RelativeVirtualAddress).GetILBytes()!
                            from target in IntermediateCode.DelegateTargets(body)
                            where IntermediateCode.IsOfStruct(reader, target)
                            select reader.GetString(m.Name)];
        Assert.Empty(made);
    }

    [Fact]
    public void ItHoldsNoMutableStaticState()
    {
        const BindingFlags statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;
        string[] found = [.. from t in BuildUnderTest.Library.GetTypes()
                             where !t.Name.Contains('<') && t.Namespace == "Gjk.Core"
                             from f in t.GetFields(statics)
                             where !f.IsLiteral && !f.IsInitOnly && !f.Name.Contains('<')
                             select $"{t.Name}.{f.Name}"];
        Assert.Empty(found);
    }
}
