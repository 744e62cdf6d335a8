using static Gjk.Core.MassForms;

namespace Gjk.Core;

/// <summary>A tapered capsule along the local y axis: the hull of two balls, of which one may be larger.</summary>
/// <remarks>The radius of the smaller ball is the margin. What is left of that ball is a point, the tip, and the core
/// is the hull of it and the rest of the larger ball. Of equal balls the core is a segment, as a capsule's, and where
/// one ball holds the other, a point: these two are as exact as capsules and spheres are.</remarks>
public readonly struct TaperedCapsuleShape : ISupportMap, ICurve
{
    private readonly double _topRadius, _bottomRadius, _halfHeight, _margin;

    /// <summary>The radius of the core's ball; 0 where the core is a segment or a point.</summary>
    private readonly double _excess;

    /// <summary>Where the ball's centre is on the y axis, from the shape's centre; the tip is opposite.</summary>
    private readonly double _ball;

    private readonly double _center;

    /// <summary>Makes a tapered capsule.</summary>
    /// <param name="topRadius">Of the ball at +halfHeight.</param>
    /// <param name="bottomRadius">Of the ball at -halfHeight.</param>
    /// <param name="halfHeight">Half the distance of the balls' centres.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public TaperedCapsuleShape(float topRadius, float bottomRadius, float halfHeight)
        : this(Sizes(topRadius, bottomRadius, halfHeight))
    {
    }

    /// <summary>From a record, whose numbers may be doubles.</summary>
    internal TaperedCapsuleShape(in Double3 size)
    {
        (_topRadius, _bottomRadius, _halfHeight) = (size.X, size.Y, size.Z);
        double excess = Math.Abs(_topRadius - _bottomRadius);
        double large = _topRadius > _bottomRadius ? _halfHeight : 0 - _halfHeight;
        bool isBall = 2 * _halfHeight <= excess;
        _margin = isBall ? Math.Max(_topRadius, _bottomRadius) : Math.Min(_topRadius, _bottomRadius);
        _excess = isBall ? 0 : excess;
        _ball = isBall ? 0 : large;
        _center = isBall ? large : 0;
    }

    /// <summary>The numbers, checked.</summary>
    internal static Double3 Sizes(float topRadius, float bottomRadius, float halfHeight) =>
        new(
            Guard.NonNegative(topRadius, nameof(topRadius)), Guard.NonNegative(bottomRadius, nameof(bottomRadius)),
            Guard.NonNegative(halfHeight, nameof(halfHeight)));

    /// <summary>The radius of the ball at +HalfHeight, at least 0.</summary>
    public float TopRadius => (float)_topRadius;

    /// <summary>The radius of the ball at -HalfHeight, at least 0.</summary>
    public float BottomRadius => (float)_bottomRadius;

    /// <summary>Half the distance of the balls' centres, at least 0.</summary>
    public float HalfHeight => (float)_halfHeight;

    /// <summary>The middle of the balls' centres; where one ball holds the other, its own centre.</summary>
    public Double3 Center => new(0, _center, 0);

    /// <inheritdoc/>
    public double Margin => _margin;

    /// <inheritdoc/>
    public double BoundingRadius => _margin + _excess + Math.Abs(_ball);

    object ILibraryShape.MakeTraits() => new LibraryTraits<TaperedCapsuleShape>();

    /// <summary>Of unequal balls a body of revolution that rays meet as they do a rounded one, without a closed
    /// form.</summary>
    bool ILibraryShape.TryGetForm(out ShapeForm form)
    {
        if (_excess > 0)
        {
            ShapeForm.Of(FormKind.Swollen, new Double3(0, 1, 0), out form);
            form.IsRounded = true;
            return true;
        }

        if (_ball != 0) return ShapeForm.Capsule(Ball, Tip, default, _margin, out form);
        ShapeForm.Ball(_margin, out form);
        form.Center = Center;
        return true;
    }

    /// <summary>A frustum between the circles at which the side touches the balls, and a cap on each. The sine is that
    /// of the side's normal over the level.</summary>
    MassProperties ICurve.GetMass(double rounding)
    {
        double top = _topRadius + rounding, bottom = _bottomRadius + rounding, height = 2 * _halfHeight;
        if (height <= Math.Abs(top - bottom))
            return Ball(Math.Max(top, bottom), new Double3(0, top > bottom ? _halfHeight : -_halfHeight, 0));
        double sine = (bottom - top) / height, cosine = Math.Sqrt((1 - sine) * (1 + sine));
        MassProperties frustum = Frustum(bottom * cosine, top * cosine, height * cosine * cosine);
        return Moved(frustum, bottom * sine - _halfHeight, 1)
            + Moved(Rim(0, top, sine), _halfHeight, 1) + Moved(Rim(0, bottom, -sine), -_halfHeight, -1);
    }

    /// <summary>The tip, or the point of the ball that lies furthest: the plane that touches both divides the
    /// directions.</summary>
    public int Support(in Double3 direction, out Double3 point)
    {
        if (_excess == 0) return PrimitiveSupport.Segment(Tip, Ball, direction, out point);
        Double3 d = DirectionRange.IsSafe(direction.LengthSquared) ? direction : DirectionRange.ToUnit(direction);
        double length = d.Length;
        if (IsTip(d.Y, length)) point = Tip;
        else Ball.Plus(d, _excess / length, out point);
        return -1;
    }

    /// <summary>The furthest line of the side, if it is level; else the tip, or nothing of the ball.</summary>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        if (_excess == 0)
        {
            if (_ball != 0) PrimitiveFaces.Segment(Tip, Ball, direction, ref corners);
            return;
        }

        Double3 d = DirectionRange.ToUnit(direction);
        double length = d.Length, radial = Math.Sqrt(d.X * d.X + d.Z * d.Z);

        // The side's normal leans towards the tip by the angle of this sine.
        double sine = -_excess / (2 * _ball), cosine = Math.Sqrt(1 - sine * sine);
        bool hasSide = radial >= FaceTilt.LeastCosine * cosine * length;
        Double3 onBall = default;
        if (hasSide)
        {
            double outward = _excess * cosine / radial;
            onBall = new Double3(outward * d.X, _ball + _excess * sine, outward * d.Z);
            hasSide = FaceTilt.IsLevelEdge(corners.ToOuter(onBall - Tip), corners.OuterDirection(direction));
        }

        if (hasSide || IsTip(d.Y, length)) corners.Add(Tip, 0);
        if (!hasSide) return;
        corners.Add(onBall, 1);
        corners.Side = RoundSide.Cone;
        corners.SideRadius = _excess;
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) =>
        _excess == 0 ? PrimitiveSupport.Two(Tip, Ball, id, out point) : PrimitiveSupport.NoVertex(out point);

    private Double3 Tip => new(0, 0 - _ball, 0);

    private Double3 Ball => new(0, _ball, 0);

    /// <summary>Whether the tip lies as far in a direction as the ball does.</summary>
    private bool IsTip(double y, double length) => -2 * _ball * y >= _excess * length;
}
