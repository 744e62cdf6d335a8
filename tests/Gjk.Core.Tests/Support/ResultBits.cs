namespace Gjk.Core.Tests.Support;

/// <summary>Compares every field of results.</summary>
internal static class ResultBits
{
    public static bool AreSame(in DistanceResult a, in DistanceResult b) => Of(a) == Of(b);

    public static string Of(in DistanceResult result)
    {
        var hash = new BitHash();
        hash.Add(result);
        return hash.ToString();
    }
}
