namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    /// <summary>Volume, mass, centre of mass and inertia, in the shape's frame: of polyhedra to a few roundings of
    /// double, of the others in closed form. Nothing is sampled.</summary>
    /// <param name="density">Mass in a unit of volume; at least 0 and finite.</param>
    /// <returns>Points, segments, triangles, and whatever else is flat have volume, mass and inertia 0. A mesh takes
    /// time in proportion to its triangles; keep the result.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The density is negative, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">This is a half-space, a shape of the caller's own, a <c>default</c>
    /// struct, or rounded: an ellipsoid, a mesh, cylinder, cone or capsule of either kind that was scaled unevenly
    /// before, or anything that was placed and scaled before. There is no closed form here.</exception>
    public MassProperties GetMassProperties(float density = 1)
    {
        Guard.NonNegative(density, nameof(density));
        CheckIsShape();
        return PlacedMass().Times(density);
    }

    /// <summary>At density 1.</summary>
    private MassProperties PlacedMass()
    {
        MassProperties body = _parts.Layer is null ? ScaledMass() : LayerMass();
        Placement? at = _parts.Placement;
        return at is null ? body : body.Turned(at.Rotation, at.Center + at.Outward(body.Center - _center));
    }

    private MassProperties LayerMass() => _parts.Layer is ScaledLayer layer && _parts.Rounding == 0
        ? layer.Inner.PlacedMass().Stretched(layer.Factors)
        : throw NoMass(_parts.Layer is ScaledLayer ? "A shape that was rounded after it was scaled" : "A custom shape");

    private MassProperties ScaledMass()
    {
        ShapeScale? scaling = _parts.Scaling;
        if (scaling is null) return CenteredMass(_parts.Rounding);
        if (_parts.Rounding > 0 && !scaling.Axes.KeepsBalls)
            throw NoMass("A shape that was rounded after it was scaled unevenly");
        return CenteredMass(_parts.Rounding / scaling.Axes.Largest).Stretched(scaling.Axes.Factors);
    }

    /// <summary>Before the scale, with a rounding, and with a centre where there is no volume.</summary>
    private MassProperties CenteredMass(double rounding)
    {
        MassProperties body = CoreMass(rounding);
        return body.Volume > 0 ? body : new MassProperties(0, CoreCenter(_parts), default);
    }

    private MassProperties CoreMass(double rounding) => _parts.Kind switch
    {
        ShapeKind.Point or ShapeKind.Sphere => MassForms.Ball(_parts.InnerMargin + rounding, default),
        ShapeKind.Segment or ShapeKind.Capsule => MassForms.Capsule(_parts.A, _parts.B, _parts.InnerMargin + rounding),
        ShapeKind.Box => MassForms.Box(_parts.A, rounding),
        ShapeKind.HalfSpace => throw NoMass("A half-space"),
        ShapeKind.Triangle => rounding > 0 ? TriangleMass(_parts.A, _parts.B, _parts.C, rounding) : default,
        ShapeKind.Mesh => HullMass(_parts.Hull!, rounding),
        _ => _parts.Curve is null ? throw NoMass($"A shape of kind {Kind}") : _parts.Curve.GetMass(rounding),
    };

    /// <summary>A triangle widened by a radius; what is straight is a capsule.</summary>
    private static MassProperties TriangleMass(in Double3 a, in Double3 b, in Double3 c, double rounding) =>
        HullMass(new ConvexHull([(Vector3)a, (Vector3)b, (Vector3)c]), rounding);

    private static MassProperties HullMass(ConvexHull hull, double rounding)
    {
        if (!(rounding > 0)) return HullMass(hull);
        hull.GetVertex(0, out Double3 first);
        hull.GetVertex(hull.VertexCount - 1, out Double3 last);
        if (hull.Dimension < 2) return MassForms.Capsule(first, last, rounding);
        var layer = new RoundedLayer(hull.Center, rounding);
        var normals = new Double3[hull.Neighbors.Length];
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int p, out int q, out int r);
            hull.GetVertex(p, out Double3 a);
            hull.GetVertex(q, out Double3 b);
            hull.GetVertex(r, out Double3 c);
            layer.AddFace(a, b, c, out Double3 normal);
            normals[EdgeOf(hull, p, q)] = normals[EdgeOf(hull, q, r)] = normals[EdgeOf(hull, r, p)] = normal;
        }

        for (int p = 0; p < hull.VertexCount; p++)
        {
            hull.GetVertex(p, out Double3 a);
            if (hull.NeighborCount(p) > 0) layer.AddBall(a, 2 * Math.PI);
            for (int i = hull.NeighborStart[p]; i < hull.NeighborStart[p + 1]; i++)
            {
                int q = hull.Neighbors[i];
                hull.GetVertex(q, out Double3 b);
                if (p < q) layer.AddEdge(a, b, normals[i], normals[EdgeOf(hull, q, p)]);
            }
        }

        return hull.Dimension < 3 ? layer.ToMass() : HullMass(hull) + layer.ToMass();
    }

    /// <summary>Where among all neighbours the one vertex is as the other's.</summary>
    private static int EdgeOf(ConvexHull hull, int from, int to) => Array.BinarySearch(
        hull.Neighbors, hull.NeighborStart[from], hull.NeighborStart[from + 1] - hull.NeighborStart[from], to);

    private static MassProperties HullMass(ConvexHull hull)
    {
        var sum = new TetrahedronSum(hull.Center);
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int p, out int q, out int r);
            hull.GetVertex(p, out Double3 a);
            hull.GetVertex(q, out Double3 b);
            hull.GetVertex(r, out Double3 c);
            sum.Add(a, b, c);
        }

        return sum.ToMass();
    }

    internal static InvalidOperationException NoMass(string what) =>
        new($"{what} has no mass properties: there is no closed form for them.");
}
