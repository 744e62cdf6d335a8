namespace Gjk.Core;

/// <summary>A shape as a ray sees it: one of the bodies that have a closed form, scaled and turned. All ways to write
/// the same shape lead to the same numbers here, and so to the same bits.</summary>
internal struct RayTarget
{
    /// <summary>Which body.</summary>
    public RayForm Form;

    /// <summary>Whether <see cref="Factors"/> are to be applied, and whether <see cref="Turn"/> is.</summary>
    public bool IsScaled, IsPlaced;

    /// <summary>Whether the body has a margin that its form does not have; no ray has a closed form then.</summary>
    public bool IsRounded;

    /// <summary>Its numbers, as the form has them.</summary>
    public Double3 A, B, C;

    /// <summary>The radius of a ball or capsule.</summary>
    public double Radius;

    /// <summary>The body's centre in the shape's local frame, and what its rounding took away.</summary>
    public Double3 Center, CenterError;

    /// <summary>The scale along the body's axes, none 0, where it could not be multiplied in.</summary>
    public Double3 Factors;

    /// <summary>The rotation of the scaled body in the shape's local frame.</summary>
    public QuaternionD Turn;

    /// <summary>The hull of a body that is one.</summary>
    public ConvexHull? Hull;

    /// <summary>A ball about the centre. All makers write where the body is to be: a copy costs as much as a
    /// ray.</summary>
    public static void Ball(double radius, out RayTarget target)
    {
        target = default;
        (target.Form, target.Radius) = (RayForm.Ball, radius);
    }

    /// <summary>A segment, with a radius or without.</summary>
    public static void Capsule(
        in Double3 a, in Double3 b, in Double3 center, double radius, out RayTarget target)
    {
        target = default;
        (target.Form, target.Radius, target.Center) = (RayForm.Capsule, radius, center);
        (target.A, target.B) = (a - center, b - center);
    }

    public static void Triangle(
        in Double3 a, in Double3 b, in Double3 c, in Double3 center, out RayTarget target)
    {
        target = default;
        (target.Form, target.Center) = (RayForm.Triangle, center);
        (target.A, target.B, target.C) = (a - center, b - center, c - center);
    }

    /// <summary>A box, cylinder, cone or ellipsoid.</summary>
    public static void Of(RayForm form, in Double3 size, out RayTarget target)
    {
        target = default;
        (target.Form, target.A) = (form, size);
    }

    public static void Of(ConvexHull hull, out RayTarget target)
    {
        target = default;
        target.Center = hull.Center;
        if (hull.IsExactBox) (target.Form, target.A) = (RayForm.Box, hull.Cells.Stretch);
        else (target.Form, target.Hull) = (RayForm.Hull, hull);
    }

    /// <summary>Scales the body along its axes; the centre is the caller's to scale.</summary>
    /// <returns>False where that leaves no body of these forms.</returns>
    public bool Scale(in AxisScale scale)
    {
        if (IsPlaced) return false;
        if (IsRounded && !scale.KeepsBalls) return TrySwell(scale.Factors);
        Double3 size = new(Math.Abs(scale.Factors.X), Math.Abs(scale.Factors.Y), Math.Abs(scale.Factors.Z));
        switch (Form)
        {
            case RayForm.Ball when !scale.KeepsBalls:
                Form = RayForm.Ellipsoid;
                A = size * Radius;
                Radius = 0;
                return true;
            case RayForm.Box or RayForm.Ellipsoid:
                A = Double3.Multiply(size, A);
                return true;
            case RayForm.Cylinder or RayForm.Cone or RayForm.Hull:
            case RayForm.Capsule when IsScaled || (!scale.KeepsBalls && Radius > 0):
                Factors = IsScaled ? Double3.Multiply(Factors, scale.Factors) : scale.Factors;
                IsScaled = true;
                return true;
            default:
                A = Double3.Multiply(scale.Factors, A);
                B = Double3.Multiply(scale.Factors, B);
                C = Double3.Multiply(scale.Factors, C);
                Radius = scale.Margin(Radius);
                return true;
        }
    }

    /// <summary>Whether it is a body of revolution, its margin apart, and about which line through its centre; 0 where
    /// about any. Of any length, before the turn.</summary>
    public readonly bool TryGetAxis(out Double3 axis)
    {
        axis = Form switch
        {
            RayForm.Cylinder or RayForm.Cone => new Double3(0, 1, 0),
            RayForm.Capsule => A - B,
            RayForm.Swollen => A,
            _ => default,
        };
        if (Form == RayForm.Ellipsoid) return Keeps(A, ref axis);
        bool isRound = axis != default || Form is RayForm.Ball or RayForm.Capsule;
        return isRound && (!IsScaled || Keeps(Factors, ref axis));
    }

    /// <summary>A margin that is scaled unevenly belongs to the body, which may stay one of revolution.</summary>
    private bool TrySwell(in Double3 factors)
    {
        if (!TryGetAxis(out Double3 axis) || !Keeps(factors, ref axis)) return false;
        Form = RayForm.Swollen;
        A = axis;
        IsScaled = false;
        return true;
    }

    /// <summary>Whether factors leave a body of revolution one, and about which axis where it was about any.</summary>
    private static bool Keeps(in Double3 factors, ref Double3 axis)
    {
        double x = factors.X * factors.X, y = factors.Y * factors.Y, z = factors.Z * factors.Z;
        bool isX = y == z && axis.Y == 0 && axis.Z == 0, isY = z == x && axis.Z == 0 && axis.X == 0;
        bool isZ = x == y && axis.X == 0 && axis.Y == 0;
        if (x == y && y == z) return true;
        if (isX || isY || isZ) axis = new Double3(isX ? 1 : 0, isY ? 1 : 0, isZ ? 1 : 0);
        return isX || isY || isZ;
    }

    /// <summary>Widens the body.</summary>
    public void Round(double radius)
    {
        if (!IsScaled && (Form is RayForm.Ball or RayForm.Capsule)) Radius += radius;
        else IsRounded |= radius > 0;
    }

    /// <summary>Turns the body; the centre is the caller's to place.</summary>
    /// <returns>False where it is turned already.</returns>
    public bool Place(in QuaternionD turn)
    {
        bool wasPlaced = IsPlaced;
        Turn = turn;
        IsPlaced = true;
        return !wasPlaced;
    }
}
