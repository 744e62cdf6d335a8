using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Gjk.Core.Tests;

public class NextSimplexTests
{
    /// <summary>Lines and triangles in every region with A; tetrahedra from each face at A, so near that the origin sees that face only, and from inside.</summary>
    public static IEnumerable<object[]> Regions() =>
        new[] { 2, 3, 4 }.SelectMany(SimplexCase.All).Where(c => ((int)c[1] & 1) != 0 && ((int)c[0] < 4 || (BitOperations.PopCount((uint)(int)c[1]) >= 3 && (double)c[2] < 1)));

    [Theory]
    [MemberData(nameof(Regions))]
    public void Keeps_the_region_of_the_origin(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Vector3D[] v = c.Vertices;
        if (n == 4 && Vector3D.Dot(Vector3D.Cross(v[2] - v[1], v[3] - v[1]), v[1]) < 0) v = [v[0], v[1], v[3], v[2]];
        if (n == 4 && Vector3D.Dot(Vector3D.Cross(v[2] - v[1], v[3] - v[1]), v[0] - v[1]) >= 0) return;

        Simplex simplex = default;
        foreach (Vector3D w in v.Reverse()) simplex.Push(w, w, w, -1, -1);
        Vector3D normal = default;
        bool inside = NextSimplex.Advance(ref simplex, ref normal);
        Assert.Equal(subset == 15, inside);
        if (inside) return;
        Assert.Equal(BitOperations.PopCount((uint)subset), simplex.Count);
        Assert.Equal(0, (normal * (1 / normal.Length) - c.Normal).Length, distance < 1e-3 ? 1e-8 : 1e-12);
    }
}
