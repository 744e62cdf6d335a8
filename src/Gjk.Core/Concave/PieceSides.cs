namespace Gjk.Core;

/// <summary>To which side the normals of a solid's connected pieces look: a piece need not be turned as the others are,
/// and a cavity's looks into the cavity, which is out of the solid.</summary>
internal static class PieceSides
{
    /// <summary>Ratio to a triangle's longest side: 2^-24, below what tells float corners apart and well above double's
    /// rounding. Solids thinner than that have no inside to find.</summary>
    private const double StepOff = 1.0 / (1 << 24);

    /// <summary>Of each piece whether its normals look into the solid; empty where none do.</summary>
    public static bool[] LooksIn(TriangleMesh mesh)
    {
        if (!mesh.HasInside) return [];
        var winding = new WindingNumber();
        bool[] looksIn = new bool[mesh.ComponentCount];
        bool isAny = false;
        for (int piece = 0; piece < looksIn.Length; piece++)
            isAny |= looksIn[piece] = LooksIn(mesh, piece, winding);
        return isAny ? looksIn : [];
    }

    /// <summary>The solid is where the winding number is further from 0: asked on both sides of the first triangle that
    /// is no line and no wall within the solid.</summary>
    private static bool LooksIn(TriangleMesh mesh, int piece, WindingNumber winding)
    {
        for (int i = mesh.Components[piece]; i < mesh.TriangleCount; i++)
        {
            if (mesh.PieceOf(i) != piece) continue;
            mesh.GetCorners(i, out Double3 a, out Double3 b, out Double3 c);
            if (ContactCone.IsFlat(a, b, c)) continue;
            Double3 off = ContactCone.FaceOf(a, b, c) * (StepOff * ContactCone.LongestSide(a, b, c));
            Double3 middle = TriangleShape.Centroid(a, b, c);
            int front = Math.Abs(winding.About(mesh, (VectorDD)(middle + off)));
            int back = Math.Abs(winding.About(mesh, (VectorDD)(middle - off)));
            if (front != back) return front > back;
        }

        return false;
    }
}
