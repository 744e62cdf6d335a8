namespace Gjk.Core.Tests.Concave;

/// <summary>Sheets that pass through each other or meet at an edge keep a contact for each pair of faces that
/// touch.</summary>
public class CrossingSheetTests
{
    /// <summary>Two leaves on one spine, and the same ones but for a leaf: they cross at the spine, so their contacts
    /// there lie behind the planes of deep faces.</summary>
    [Fact]
    public void TheFaceOfALeafThatLiesOnALeafHasItsContact()
    {
        Vector3 leaf = new(-0.10202106f, 0.040344108f, -0.25211513f);
        AnyShape a = Book(new(0.9885516f, 0.49121153f, -0.464289f), leaf);
        AnyShape b = Book(new(-0.312166f, -0.23624215f, 0.7189878f), leaf);
        var turn = new Quaternion(0.46384367f, -0.56007355f, 0.5838012f, -0.35962012f);
        var apart = new RigidPose(turn, new Vector3(-4.816999E-08f, 1.4937426E-08f, 2.9126235E-07f));
        List<PairContacts> contacts = Find(a, new RigidPose(turn, Vector3.Zero), b, apart);
        Assert.Contains(contacts, one => one.PartA == 1 && one.PartB == 1 && one.Manifold.Count == 3);
    }

    /// <summary>The planes of all four leaves are across those of others, and their sides cover each other.</summary>
    [Fact]
    public void APointInTheFoldOfABookHasAContact()
    {
        AnyShape book = Book(
            new(-0.051196307f, 0.14438018f, -0.69232064f), new(0.29024246f, 0.19503398f, -0.26372743f),
            new(0.79841244f, 0.6161787f, 0.3331801f), new(0.9044265f, 0.8768064f, 0.77138114f));
        var turn = new Quaternion(0.25747055f, -0.38915265f, 0.75206834f, 0.46547005f);
        var at = new RigidPose(new Vector3(-0.9005212f, -0.26379573f, -0.34564906f));
        Assert.NotEmpty(Find(book, new RigidPose(turn, Vector3.Zero), AnyShape.Of(ConvexShape.Point()), at));
    }

    /// <summary>Within the room in which sides count as level each of two faces is behind the other.</summary>
    [Fact]
    public void APointJustAboveAFoldHasAContact()
    {
        var fold = AnyShape.Surface(new TriangleMesh(
            [
                new(-0.23038092f, 0.5977437f, 1.0093647f), new(-0.84814477f, 0.54350007f, 0.408445f),
                new(-0.48967662f, 0.9413697f, 0.23581584f), new(-0.22252093f, 6.123234E-17f, 0.9749279f),
            ],
            [0, 1, 2, 0, 3, 1]));
        var pose = new RigidPose(new Vector3(-0.31479412f, -0.47344813f, -0.36022085f));
        var at = new RigidPose(new Vector3(-0.5451714f, 0.12429455f, 0.64913964f));
        Assert.NotEmpty(Find(fold, pose, AnyShape.Of(ConvexShape.Point()), at));
    }

    /// <summary>Of two sheets of nearly one place a pair that crosses is pushed out at a corner that is another pair's,
    /// too, whose own contact is on the other side: each is named by its own parts.</summary>
    [Fact]
    public void APairKeepsItsContactBesideThatOfAPairThatCrosses()
    {
        Vector3 scale = new(-1.8006905f, -0.66165f, 0.8746338f), tip = new(0.044522684f, 0.84780717f, -0.54215485f);
        AnyShape a = Sheet(new(0.035206422f, -0.187273f, -0.9982214f));
        AnyShape b = Sheet(new(-0.75769836f, 0.26250398f, 0.06746166f));
        var turn = new Quaternion(0.70710677f, 0, 0, -0.70710677f);
        var apart = new RigidPose(turn, new Vector3(0.00020589425f, -0.0006866662f, 0.00015199788f));
        List<PairContacts> contacts = Find(a, new RigidPose(turn, Vector3.Zero), b, apart);
        PairContacts own = Assert.Single(contacts, one => one.PartA == 0 && one.PartB == 0);
        Assert.Equal((GjkStatus.Separated, 3), (own.Result.Status, own.Manifold.Count));
        PairContacts crossing = Assert.Single(contacts, one => one.PartA == 1 && one.PartB == 0);
        Assert.Equal(GjkStatus.Overlapping, crossing.Result.Status);

        AnyShape Sheet(Vector3 end) => AnyShape.Surface(
            new TriangleMesh([Vector3.Zero, Vector3.UnitY, tip, end], [0, 1, 2, 3, 1, 0]).Scaled(scale));
    }

    private static AnyShape Book(params Vector3[] leaves) => AnyShape.Surface(new TriangleMesh(
        [Vector3.Zero, Vector3.UnitY, .. leaves],
        [.. Enumerable.Range(0, leaves.Length).SelectMany(i => i < 2 ? new[] { 0, 1, 2 + i } : [2 + i, 1, 0])]));

    private static List<PairContacts> Find(AnyShape a, RigidPose poseA, AnyShape b, RigidPose poseB)
    {
        var contacts = new List<PairContacts>();
        Assert.True(ConcaveQuery.FindContacts(a, poseA, b, poseB, 0.01f, new ConcaveScratch(), contacts));
        return contacts;
    }
}
