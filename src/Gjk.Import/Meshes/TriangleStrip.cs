namespace Gjk.Import;

/// <summary>Triangles that share an edge with the one before; each second one turns the other way.</summary>
internal static class TriangleStrip
{
    public static void Append(ReadOnlySpan<int> strip, List<int> triangles)
    {
        for (int i = 0; i + 2 < strip.Length; i++)
        {
            bool isOdd = i % 2 == 1;
            triangles.Add(strip[i]);
            triangles.Add(strip[isOdd ? i + 2 : i + 1]);
            triangles.Add(strip[isOdd ? i + 1 : i + 2]);
        }
    }
}
