using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>Names that are public. What is, PublicAPI.Unshipped.txt says, and the compiler holds it to that.</summary>
public sealed class PublicApiTests
{
    [Fact]
    public void EveryPublicTypeLivesInTheOneNamespace() =>
        Assert.All(typeof(Importer).Assembly.GetExportedTypes(), t => Assert.Equal("Gjk.Import", t.Namespace));
}
