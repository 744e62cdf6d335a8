using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Gjk.Core.Tests;

public class NextSimplexTests
{
    /// <summary>
    /// Lines and triangles in every region with A; tetrahedra from each face at A, so near that the origin sees that
    /// face only, and from inside.
    /// </summary>
    public static IEnumerable<object[]> Regions() =>
        new[] { 2, 3, 4 }.SelectMany(SimplexCase.All).Where(c => ((int)c[1] & 1) != 0 && ((int)c[0] < 4 || IsSeen(c)));

    [Theory]
    [MemberData(nameof(Regions))]
    public void TheStepKeepsTheRegionOfTheOrigin(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Simplex simplex = default;
        foreach (Vector3D w in Wound(c.Vertices).Reverse()) simplex.Push(w, w, w, -1, -1);
        Vector3D normal = default;
        bool inside = NextSimplex.Advance(ref simplex, ref normal);
        Assert.Equal(subset == 15, inside);
        if (inside) return;
        Assert.Equal(BitOperations.PopCount((uint)subset), simplex.Count);
        Assert.Equal(0, (normal * (1 / normal.Length) - c.Normal).Length, distance < 1e-3 ? 1e-8 : 1e-12);
    }

    /// <summary>None of the kinds of simplex has lost all its cases to the preconditions.</summary>
    [Theory]
    [InlineData(2, 6)]
    [InlineData(3, 24)]
    [InlineData(4, 3)]
    public void TheStepIsTriedOnEveryKindOfSimplex(int n, int least) =>
        Assert.InRange(Regions().Count(c => (int)c[0] == n), least, int.MaxValue);

    /// <summary>From near a face or from inside, with A on the origin's side of the older vertices.</summary>
    private static bool IsSeen(object[] c)
    {
        if (BitOperations.PopCount((uint)(int)c[1]) < 3 || (double)c[2] >= 1) return false;
        Vector3D[] v = Wound(SimplexCase.Make((int)c[0], (int)c[1], (double)c[2], (int)c[3]).Vertices);
        return Vector3D.Dot(Vector3D.Cross(v[2] - v[1], v[3] - v[1]), v[0] - v[1]) < 0;
    }

    /// <summary>With the triangle of the older vertices wound away from the origin, as the solver leaves it.</summary>
    private static Vector3D[] Wound(Vector3D[] v) =>
        v.Length == 4 && Vector3D.Dot(Vector3D.Cross(v[2] - v[1], v[3] - v[1]), v[1]) < 0
            ? [v[0], v[1], v[3], v[2]]
            : v;
}
