namespace Gjk.Core.Tests.Api;

/// <summary>Names that are public. What is, PublicAPI.Unshipped.txt says, and the compiler holds it to that.</summary>
public class PublicApiTests
{
    [Fact]
    public void NoNameClashesWithUnitys() =>
        Assert.All(
            ["Collider", "BoxCollider", "MeshCollider", "Ray", "Plane", "Pose", "Bounds", "Transform"],
            name => Assert.Null(BuildUnderTest.Library.GetType("Gjk.Core." + name)));

    [Fact]
    public void EveryPublicTypeLivesInOneOfTwoNamespaces() =>
        Assert.All(
            BuildUnderTest.Library.GetExportedTypes(),
            t => Assert.Contains(t.Namespace, new[] { "Gjk.Core", "Gjk.Core.Diagnostics" }));
}
