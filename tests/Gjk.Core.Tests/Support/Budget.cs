namespace Gjk.Core.Tests.Support;

/// <summary>How much a test tries: a third of a count keeps the whole suite short, and GJK_LONG=1 asks for a hundred times
/// the count.</summary>
internal static class Budget
{
    private const int QuickShare = 3, LongFactor = 100;

    private static readonly bool Long = Environment.GetEnvironmentVariable("GJK_LONG") == "1";

    public static int Count(int usual) => Long ? usual * LongFactor : Share(usual);

    /// <summary>For what more of would prove no more: GJK_LONG=1 asks for the count itself.</summary>
    public static int Whole(int usual) => Long ? usual : Share(usual);

    private static int Share(int usual) => (usual + QuickShare - 1) / QuickShare;
}
