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
    /// struct, or a rounded triangle, cylinder, cone, ellipsoid or mesh, as a sphere or capsule is that was rounded
    /// after it was scaled unevenly: there is no closed form here.</exception>
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

    private MassProperties CoreMass(double rounding)
    {
        Double3 a = _parts.A;
        return _parts.Kind switch
        {
            ShapeKind.Point or ShapeKind.Sphere => MassForms.Ball(_parts.InnerMargin + rounding, default),
            ShapeKind.Segment or ShapeKind.Capsule => MassForms.Capsule(a, _parts.B, _parts.InnerMargin + rounding),
            ShapeKind.TaperedCapsule => MassForms.TaperedCapsule(a.X + rounding, a.Y + rounding, a.Z),
            ShapeKind.Box => MassForms.Box(a, rounding),
            ShapeKind.HalfSpace => throw NoMass("A half-space"),
            _ when rounding > 0 => throw NoMass($"A rounded {_parts.Kind}"),
            ShapeKind.Triangle => default,
            ShapeKind.Cylinder => MassForms.Cylinder(a.X, a.Y),
            ShapeKind.Cone => MassForms.Cone(a.X, a.Y),
            ShapeKind.Ellipsoid => MassForms.Ellipsoid(a),
            _ => HullMass(_parts.Hull!),
        };
    }

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

    private static InvalidOperationException NoMass(string what) =>
        new($"{what} has no mass properties: there is no closed form for them.");
}
