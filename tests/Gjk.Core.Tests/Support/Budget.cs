namespace Gjk.Core.Tests.Support;

/// <summary>How much a test tries: a default that keeps the whole suite short, and a hundred times that with
/// GJK_LONG=1.</summary>
internal static class Budget
{
    private const int LongFactor = 100, QuickShare = 3;

    private static readonly bool Long = Environment.GetEnvironmentVariable("GJK_LONG") == "1";

    public static int Count(int usual) => Long ? usual * LongFactor : usual;

    /// <summary>For what takes seconds: the quick tier tries a third of the count.</summary>
    public static int Few(int usual) => Long ? usual * LongFactor : Share(usual);

    /// <summary>For what more of would prove no more: the long tier tries the count itself.</summary>
    public static int Whole(int usual) => Long ? usual : Share(usual);

    private static int Share(int usual) => (usual + QuickShare - 1) / QuickShare;
}
