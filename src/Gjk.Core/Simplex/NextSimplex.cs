using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Muratori's step of the boolean algorithm ("Implementing GJK", 2006): given a simplex whose newest vertex is A, keep
/// the part of it whose region holds the origin and say where to search next.
/// </summary>
/// <remarks>
/// Beside his drawings: AO is the vector from A to the origin, -A. Regions behind the old feature are not tested,
/// because A was found beyond it. The normal that comes back points from the origin to the kept feature, so the next
/// support is taken against it (his D is its opposite). Which way a tetrahedron is wound is known from its triangle
/// (see <see cref="Simplex"/>), where he flips.
/// </remarks>
internal static class NextSimplex
{
    /// <summary>Dispatches on the number of vertices (2 to 4).</summary>
    /// <returns>True when the tetrahedron holds the origin.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Advance(ref Simplex simplex, ref Vector3D normal)
    {
        switch (simplex.Count)
        {
            case 2:
                Line(ref simplex, ref normal);
                return false;
            case 3:
                Triangle(ref simplex, ref normal);
                return false;
            default:
                return Tetrahedron(ref simplex, ref normal);
        }
    }

    /// <summary>The origin is beside AB, or behind A.</summary>
    public static void Line(ref Simplex simplex, ref Vector3D normal)
    {
        Vector3D a = simplex.WA, ab = simplex.WB - a;
        if (Vector3D.Dot(ab, a) < 0)
            KeepEdge(ref simplex, a, ab, ref normal);
        else
            KeepVertex(ref simplex, a, ref normal);
    }

    /// <summary>The origin is beside AB or AC, behind A, above the triangle or below it.</summary>
    public static void Triangle(ref Simplex simplex, ref Vector3D normal)
    {
        Vector3D a = simplex.WA, ab = simplex.WB - a, ac = simplex.WC - a;
        Vector3D abc = Vector3D.Cross(ab, ac);
        if (Vector3D.Dot(abc, a) < 0)
        {
            (simplex.B, simplex.C) = (simplex.C, simplex.B);
            (ab, ac) = (ac, ab);
            abc = -abc;
        }

        Face(ref simplex, a, ab, ac, abc, ref normal);
    }

    /// <summary>The origin is beyond one of the faces at A, or inside.</summary>
    public static bool Tetrahedron(ref Simplex simplex, ref Vector3D normal)
    {
        Vector3D a = simplex.WA, ab = simplex.WB - a, ac = simplex.WC - a, ad = simplex.WD - a;
        Vector3D abc = Vector3D.Cross(ab, ac), acd = Vector3D.Cross(ac, ad), adb = Vector3D.Cross(ad, ab);
        if (Vector3D.Dot(abc, a) > 0)
        {
            Face(ref simplex, a, ab, ac, abc, ref normal);
        }
        else if (Vector3D.Dot(acd, a) > 0)
        {
            simplex.B = simplex.C;
            simplex.C = simplex.D;
            Face(ref simplex, a, ac, ad, acd, ref normal);
        }
        else if (Vector3D.Dot(adb, a) > 0)
        {
            simplex.C = simplex.B;
            simplex.B = simplex.D;
            Face(ref simplex, a, ad, ab, adb, ref normal);
        }
        else
        {
            return true;
        }

        return false;
    }

    /// <summary>
    /// The part of the triangle case that is left when the triangle's normal already points away from the origin.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Face(
        ref Simplex simplex, in Vector3D a, in Vector3D ab, in Vector3D ac, in Vector3D abc, ref Vector3D normal)
    {
        bool besideAC = Vector3D.Dot(Vector3D.Cross(abc, ac), a) < 0;
        if (besideAC && Vector3D.Dot(ac, a) < 0)
        {
            simplex.B = simplex.C;
            KeepEdge(ref simplex, a, ac, ref normal);
        }
        else if (besideAC || Vector3D.Dot(Vector3D.Cross(ab, abc), a) < 0)
        {
            if (Vector3D.Dot(ab, a) < 0)
                KeepEdge(ref simplex, a, ab, ref normal);
            else
                KeepVertex(ref simplex, a, ref normal);
        }
        else
        {
            simplex.Count = 3;
            normal = abc;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepEdge(ref Simplex simplex, in Vector3D a, in Vector3D ab, ref Vector3D normal)
    {
        simplex.Count = 2;
        normal = Vector3D.Cross(Vector3D.Cross(ab, a), ab);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepVertex(ref Simplex simplex, in Vector3D a, ref Vector3D normal)
    {
        simplex.Count = 1;
        normal = new Vector3D(a.X, a.Y, a.Z);
    }
}
