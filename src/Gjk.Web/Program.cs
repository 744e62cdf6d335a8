using System.Runtime.Versioning;

[assembly: SupportedOSPlatform("browser")]

namespace Gjk.Web;

/// <summary>The entry that the runtime's loader looks for. A page calls <see cref="Exports"/> instead.</summary>
internal static class Program
{
    private static void Main()
    {
    }
}
