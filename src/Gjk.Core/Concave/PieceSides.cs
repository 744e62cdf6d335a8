namespace Gjk.Core;

/// <summary>Finds the side to which the normals of a solid's connected pieces point. Pieces may be oriented
/// differently. Those of a cavity point into the cavity, which is out of the solid.</summary>
internal static class PieceSides
{
    /// <summary>Ratio to a triangle's longest side: 2^-24, less than the spacing of float corners, and well above the
    /// rounding of double. Thinner solids have no inside to find.</summary>
    private const double StepOff = 1.0 / (1 << 24);

    /// <summary>For each piece, whether its normals point into the solid; empty where none do.</summary>
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

    /// <summary>The solid is on the side with the winding number further from 0. Both sides are tested, at the first
    /// triangle that has area and is no wall within the solid.</summary>
    private static bool LooksIn(TriangleMesh mesh, int piece, WindingNumber winding)
    {
        for (int i = mesh.Components[piece]; i < mesh.TriangleCount; i++)
        {
            if (mesh.PieceOf(i) != piece) continue;
            mesh.GetCorners(i, out Double3 a, out Double3 b, out Double3 c);
            if (ContactCone.IsFlat(a, b, c)) continue;
            Double3 off = ContactCone.UnitNormalOf(a, b, c) * (StepOff * ContactCone.LongestSide(a, b, c));
            Double3 middle = TriangleShape.Centroid(a, b, c);
            int front = Math.Abs(winding.About(mesh, (VectorDD)(middle + off)));
            int back = Math.Abs(winding.About(mesh, (VectorDD)(middle - off)));
            if (front != back) return front > back;
        }

        return false;
    }
}
