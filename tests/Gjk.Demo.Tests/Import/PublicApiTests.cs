using System;
using System.IO;
using Gjk.Core.Tests.Api;
using Gjk.Demo.Tests.Support;
using Gjk.Import;
using Xunit;

namespace Gjk.Demo.Tests.Import;

/// <summary>The public surface of Gjk.Import is what PublicApi.Import.txt says: a change to it must be meant.</summary>
public sealed class PublicApiTests
{
    [Fact]
    public void TheSurfaceIsTheSnapshot()
    {
        string file = Repository.File("tests/Gjk.Demo.Tests/PublicApi.Import.txt");
        string actual = ApiText.Of(typeof(Importer).Assembly);
        if (Environment.GetEnvironmentVariable("GJK_UPDATE_API") == "1") File.WriteAllText(file, actual);
        Assert.Equal(File.ReadAllText(file).Replace("\r", ""), actual);
    }

    [Fact]
    public void EveryPublicTypeLivesInTheOneNamespace() =>
        Assert.All(typeof(Importer).Assembly.GetExportedTypes(), t => Assert.Equal("Gjk.Import", t.Namespace));
}
