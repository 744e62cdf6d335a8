using System.IO;

namespace Gjk.Demo.View;

/// <summary>Files to be written must be neither the scene nor each other.</summary>
internal static class TargetFiles
{
    /// <exception cref="RefusedException">Two are the same file.</exception>
    public static void Check(string? scene, params (string Option, string? File)[] targets)
    {
        for (int i = 0; i < targets.Length; i++)
        {
            if (IsSame(targets[i].File, scene)) throw new RefusedException($"{targets[i].File}: {targets[i].Option} would overwrite the scene");
            for (int j = 0; j < i; j++)
            {
                if (IsSame(targets[i].File, targets[j].File))
                    throw new RefusedException($"{targets[i].File}: {targets[i].Option} would overwrite what {targets[j].Option} writes");
            }
        }
    }

    private static bool IsSame(string? a, string? b) => !string.IsNullOrEmpty(a) && !string.IsNullOrEmpty(b) && Path.GetFullPath(a) == Path.GetFullPath(b);
}
