namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    /// <summary>The same shape scaled about the local origin. Factors of an earlier call are multiplied.</summary>
    /// <param name="scale">Along the local axes; negative factors mirror. Uneven factors make an ellipsoid of a sphere
    /// and of every margin.</param>
    /// <exception cref="ArgumentOutOfRangeException">A factor is 0, NaN or infinite, or leaves the range of float when
    /// it is multiplied with an earlier one.</exception>
    /// <exception cref="InvalidOperationException">This is a <c>default</c> struct.</exception>
    public ConvexShape Scaled(Vector3 scale)
    {
        Guard.Scale(scale, nameof(scale));
        CheckIsShape();
        Double3 factors = scale;
        if (Kind == ShapeKind.HalfSpace) return Make(AsHalfSpace.Stretched(factors));
        var change = new AxisScale(factors);
        ShapeParts parts = _parts;
        if (parts.Layer is not null || parts.Placement is not null || (parts.Rounding > 0 && !change.KeepsBalls))
        {
            var layer = new ScaledLayer(new Scaled<ConvexShape>(this, scale));
            return new(new ShapeParts { Kind = Kind, Layer = layer });
        }

        parts.Rounding *= change.Largest;
        if (parts.Kind is ShapeKind.Point or ShapeKind.Sphere && !change.KeepsBalls)
        {
            parts.Kind = parts.InnerMargin > 0 ? ShapeKind.Ellipsoid : parts.Kind;
            parts.A = Absolute(factors) * parts.InnerMargin;
            parts.InnerMargin = 0;
            return new(parts);
        }

        if (!_isPlain || !IsMultipliedIn(change))
        {
            parts.Scale = Double3.Multiply(parts.Scale, factors);
            Guard.Scale((Vector3)parts.Scale, nameof(scale));
            return new(parts);
        }

        if (parts.Kind is ShapeKind.Box or ShapeKind.Ellipsoid) factors = Absolute(factors);
        parts.A = Double3.Multiply(factors, parts.A);
        parts.B = Double3.Multiply(factors, parts.B);
        parts.C = Double3.Multiply(factors, parts.C);
        parts.InnerMargin = change.Margin(parts.InnerMargin);
        return new(parts);
    }

    /// <summary>The same shape widened by a radius: its Minkowski sum with a ball. Radii of earlier calls are
    /// added.</summary>
    /// <param name="radius">In local units.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">This is a <c>default</c> struct.</exception>
    public ConvexShape Rounded(float radius)
    {
        Guard.NonNegative(radius, nameof(radius));
        CheckIsShape();
        if (Kind == ShapeKind.HalfSpace) return Make(AsHalfSpace.Widened(radius));
        ShapeParts parts = _parts;
        if (parts.Layer is null && parts.Scaling is null && TryRoundedKind(parts.Kind, out ShapeKind rounded))
        {
            parts.Kind = rounded;
            parts.InnerMargin += radius;
        }
        else
        {
            parts.Rounding += radius;
        }

        return new(parts);
    }

    /// <summary>The same shape turned and moved inside the local frame: a capsule along x, say.</summary>
    /// <param name="pose">Where this shape is in the frame of the new one.</param>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    /// <exception cref="InvalidOperationException">This is a <c>default</c> struct.</exception>
    public ConvexShape Placed(in RigidPose pose)
    {
        Guard.Pose(pose, nameof(pose));
        CheckIsShape();
        if (pose == RigidPose.Identity) return this;
        if (Kind == ShapeKind.HalfSpace) return Make(AsHalfSpace.Moved(pose));
        return new(this, new Placement(pose, _parts.Placement, _center));
    }

    /// <summary>What was placed at a pose last, placed at another one instead.</summary>
    internal ConvexShape PlacedAnew(in RigidPose from, in RigidPose to) =>
        (from == RigidPose.Identity ? this : new ConvexShape(this, _parts.Placement!.Before)).Placed(to);

    /// <summary>The same shape with its y axis along z, as FCL, coal, Drake and MuJoCo have their cylinders, capsules
    /// and cones: what lies along x, y and z comes to lie along y, z and x. That turn is exact.</summary>
    /// <exception cref="InvalidOperationException">This is a <c>default</c> struct.</exception>
    public ConvexShape AlongZ() => Placed(new RigidPose(new Quaternion(0.5f, 0.5f, 0.5f, 0.5f), Vector3.Zero));

    private void CheckIsShape()
    {
        if (_parts.Kind == ShapeKind.None)
            throw new InvalidOperationException(
                "A default ConvexShape is no shape; make one with a method such as ConvexShape.Box.");
    }

    /// <summary>Whether the shape's own numbers can take a scale, without rounding.</summary>
    private bool IsMultipliedIn(in AxisScale change) => _parts.Kind switch
    {
        ShapeKind.Point or ShapeKind.Segment or ShapeKind.Triangle or ShapeKind.Box or ShapeKind.Ellipsoid => true,
        ShapeKind.Sphere or ShapeKind.Capsule => change.KeepsBalls || _parts.InnerMargin == 0,
        _ => false,
    };

    /// <summary>What a ball's sum with a shape is called, where the shape's own margin can hold the radius.</summary>
    private static bool TryRoundedKind(ShapeKind kind, out ShapeKind rounded)
    {
        rounded = kind is ShapeKind.Point or ShapeKind.Sphere ? ShapeKind.Sphere : ShapeKind.Capsule;
        return kind is ShapeKind.Point or ShapeKind.Sphere or ShapeKind.Segment or ShapeKind.Capsule;
    }

    private static Double3 Absolute(in Double3 v) => new(Math.Abs(v.X), Math.Abs(v.Y), Math.Abs(v.Z));
}
