namespace Gjk.Core.Tests.Support;

/// <summary>How much a test tries: a default that keeps the whole suite short, and a hundred times that with
/// GJK_LONG=1.</summary>
internal static class Budget
{
    private const int LongFactor = 100;

    private static readonly bool Long = Environment.GetEnvironmentVariable("GJK_LONG") == "1";

    public static int Count(int usual) => Long ? usual * LongFactor : usual;
}
