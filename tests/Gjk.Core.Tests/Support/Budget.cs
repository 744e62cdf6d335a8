namespace Gjk.Core.Tests.Support;

/// <summary>How much a test tries: a default that keeps the whole suite short, and a hundred times that with
/// GJK_LONG=1.</summary>
internal static class Budget
{
    private const int LongFactor = 100, QuickShare = 3;

    /// <summary>Whether this is the long tier.</summary>
    public static readonly bool IsLong = Environment.GetEnvironmentVariable("GJK_LONG") == "1";

    public static int Count(int usual) => IsLong ? usual * LongFactor : usual;

    /// <summary>For what takes seconds: the quick tier tries a third of the count.</summary>
    public static int Few(int usual) => IsLong ? usual * LongFactor : Share(usual);

    /// <summary>For what more of would prove no more: the long tier tries the count itself.</summary>
    public static int Whole(int usual) => IsLong ? usual : Share(usual);

    private static int Share(int usual) => (usual + QuickShare - 1) / QuickShare;
}
