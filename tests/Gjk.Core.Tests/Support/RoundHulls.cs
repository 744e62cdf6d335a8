namespace Gjk.Core.Tests.Support;

/// <summary>Balls of many corners: inside each other, they have many ways out that are nearly equally long.</summary>
internal static class RoundHulls
{
    /// <summary>A UV sphere of radius 1; it has (rings - 1) * count + 2 corners.</summary>
    public static ConvexHull Uv(int rings, int count)
    {
        var corners = new List<Vector3> { Vector3.UnitY, -Vector3.UnitY };
        for (int i = 1; i < rings; i++)
        {
            (double radius, double y) = Math.SinCos(Math.PI * i / rings);
            for (int j = 0; j < count; j++)
            {
                (double z, double x) = Math.SinCos(2 * Math.PI * j / count);
                corners.Add(new Vector3((float)(radius * x), (float)y, (float)(radius * z)));
            }
        }

        return new ConvexHull(corners);
    }

    /// <summary>An icosphere of radius 1: 162 corners when halved twice, then 642, 2,562 and 10,242.</summary>
    public static ConvexHull Ico(int halved) => new(Icosphere.InFloat(halved));

    /// <summary>Corners along a spiral from pole to pole, no two facets alike.</summary>
    public static ConvexHull Spiral(int count) => new(SphereMeshes.Spiral(count, 1));
}
