namespace Gjk.Core;

/// <summary>Which side of a mesh's triangle a ray meets.</summary>
internal static class TriangleBack
{
    /// <summary>Says of a hit that it is on the back, or passes it.</summary>
    public static void Judge(
        PartSide side, int triangle, Vector3 direction, RaySides sides, ref RayCastResult met)
    {
        if (!met.IsHit || !IsBack(side, triangle, direction)) return;
        met = sides.Has(RaySides.FrontOnly)
            ? RayCastResult.Nothing(CastStatus.Miss, float.PositiveInfinity, 0)
            : met.On(back: true);
    }

    /// <summary>Whether a ray meets it from the back. Of a ray within some 1e-15 of the triangle's plane rounding
    /// decides; one in the plane meets the front.</summary>
    /// <param name="side">Of any kind; what is of no mesh or solid has no back.</param>
    /// <param name="triangle">Its number.</param>
    /// <param name="direction">In the world.</param>
    private static bool IsBack(PartSide side, int triangle, Vector3 direction)
    {
        int turn = side.HasInside ? side.OutwardOf(triangle) : side.Mesh?.Mirror ?? 0;
        if (turn == 0) return false;
        side.GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        Double3 front = Double3.Cross((b - a) * (1 / side.Tree.Unit), (c - a) * (1 / side.Tree.Unit));
        double along = Double3.Dot(new RotationD(side.Pose.Rotation).Rotate(front), direction);
        return along * turn > 0;
    }
}
