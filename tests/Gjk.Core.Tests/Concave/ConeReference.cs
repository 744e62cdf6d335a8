namespace Gjk.Core.Tests.Concave;

/// <summary>The normal cone from the raw triangles: all are looked at for each, neighbours by their places.</summary>
internal sealed class ConeReference
{
    public ConeReference(TriangleMesh mesh, int triangle, Vector3 normal)
    {
        Double3 d = normal;
        d *= 1 / d.Length;
        Double3[] own = Corners(mesh, triangle);
        Double3 face = Double3.Cross(own[1] - own[0], own[2] - own[0]);
        face *= 1 / face.Length;
        Face = (Vector3)face;
        double tilt = Math.Sqrt(Math.Max(0, 1 - Math.Pow(Double3.Dot(face, d), 2)));
        if (Double3.Cross(face, d).Length < 4e-7)
        {
            Stays = true;
            return;
        }

        IsUnclear = tilt < 1e-5;
        int top = 0;
        for (int k = 1; k < 3; k++)
            if (Double3.Dot(own[k], d) > Double3.Dot(own[top], d)) top = k;
        int along = -1;
        for (int k = 0; k < 3; k++)
        {
            if (k == top) continue;
            Double3 edge = own[k] - own[top];
            double rise = Math.Abs(Double3.Dot(edge, d)) / edge.Length;
            if (rise < 4e-7) along = k;
            else if (rise < 1e-5) IsUnclear = true;
        }

        Stays = true;
        for (int i = 0; i < mesh.TriangleCount; i++)
            if (i != triangle) Look(Corners(mesh, i), own[top], along >= 0 ? own[along] : null, d);
    }

    public bool Stays { get; private set; }

    public bool IsUnclear { get; private set; }

    public Vector3 Face { get; }

    /// <summary>Whether another triangle at the corner, and at the edge's other end, reaches beyond them.</summary>
    private void Look(Double3[] other, Double3 top, Double3? end, in Double3 d)
    {
        bool isAtEdge = end is not null;
        if (Array.IndexOf(other, top) < 0 || (isAtEdge && Array.IndexOf(other, end!.Value) < 0)) return;
        foreach (Double3 w in other)
        {
            if (w == top || w == end) continue;
            Double3 to = w - top;
            if (end is { } far)
            {
                Double3 edge = far - top;
                to -= edge * (Double3.Dot(to, edge) / edge.LengthSquared);
            }

            double rise = Double3.Dot(to, d) / to.Length;
            if (rise > 1e-5) Stays = false;
            else if (rise > 1e-7) IsUnclear = true;
        }
    }

    private static Double3[] Corners(TriangleMesh mesh, int triangle)
    {
        mesh.GetTriangle(triangle, out int a, out int b, out int c);
        return [Place(mesh, a), Place(mesh, b), Place(mesh, c)];
    }

    private static Double3 Place(TriangleMesh mesh, int vertex) =>
        Double3.Multiply(mesh.GetVertex(vertex), mesh.Scale);
}
