namespace Gjk.Core;

/// <summary>Tells which side of a mesh's triangle a ray meets.</summary>
internal static class TriangleBack
{
    /// <summary>Marks a hit on the back of a triangle, or turns it into a miss if only fronts are met.</summary>
    public static void ApplySides(
        PartSide side, int triangle, Vector3 direction, RaySides sides, ref RayCastResult met)
    {
        if (!met.IsHit || !IsBack(side, triangle, direction)) return;
        met = sides.Has(RaySides.FrontOnly)
            ? RayCastResult.Nothing(CastStatus.Miss, float.PositiveInfinity, 0)
            : met.On(back: true);
    }

    /// <summary>Whether a ray meets a triangle from the back. Within some 1e-15 of the triangle's plane rounding
    /// decides; a ray in the plane meets the front.</summary>
    /// <param name="side">Of any kind. A part of no mesh or solid has no back.</param>
    /// <param name="triangle">Its number.</param>
    /// <param name="direction">In the world.</param>
    private static bool IsBack(PartSide side, int triangle, Vector3 direction)
    {
        int turn = side.HasInside ? side.OutwardOf(triangle) : side.Mesh?.Mirror ?? 0;
        if (turn == 0) return false;
        side.GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        Double3 front = Double3.Cross((b - a) * (1 / side.Tree.Unit), (c - a) * (1 / side.Tree.Unit));
        double along = Double3.Dot(side.ToWorldDirection(front), direction);
        return along * turn > 0;
    }
}
