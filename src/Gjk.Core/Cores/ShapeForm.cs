namespace Gjk.Core;

/// <summary>The bodies that all shapes come down to. Queries unwrap a shape to the core of one of the first
/// four.</summary>
internal enum FormKind : byte
{
    /// <summary>None of these: asked through its own type, and rays are cast as points.</summary>
    None,

    /// <summary>A box about the centre: A, half its sides. Its core is a <see cref="BoxCore"/>.</summary>
    Box,

    /// <summary>A hull, which rays meet if it has planes. Its core is a <see cref="HullCore"/>.</summary>
    Hull,

    /// <summary>A segment and a radius: its ends, measured from the centre. A <see cref="SegmentCore"/>, as is a
    /// ball.</summary>
    Segment,

    /// <summary>A triangle: its corners, measured from the centre. Its core is a <see cref="TriangleCore"/>.</summary>
    Triangle,

    /// <summary>A ball about the centre: its radius.</summary>
    Ball,

    /// <summary>A cylinder about the y axis: A, the radius and half the height.</summary>
    Cylinder,

    /// <summary>A cone about the y axis, its apex at the top: A, the radius and half the height.</summary>
    Cone,

    /// <summary>An ellipsoid: A, its radii.</summary>
    Ellipsoid,

    /// <summary>A body of revolution that no ray meets in closed form: rounded before it was scaled unevenly, or a
    /// tapered capsule. A, its axis.</summary>
    Swollen,

    /// <summary>Added to a core's kind: the core is placed in the shape's frame.</summary>
    Moved = 16,
}

/// <summary>What a shape is, however it is written: one of the bodies that have a closed form, scaled and turned. Rays
/// and the searches for a depth ask it. All ways to write the same shape lead to the same numbers here, and so to the
/// same bits.</summary>
internal struct ShapeForm
{
    /// <summary>Which body.</summary>
    public FormKind Kind;

    /// <summary>Whether <see cref="Factors"/> are to be applied, and whether <see cref="Turn"/> is.</summary>
    public bool IsScaled, IsPlaced;

    /// <summary>Whether the body has a margin that its kind does not have; no ray has a closed form then.</summary>
    public bool IsRounded;

    /// <summary>Its numbers, as the kind has them.</summary>
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

    /// <summary>No body.</summary>
    /// <returns>False; the other makers give true.</returns>
    public static bool None(out ShapeForm form) => Of(FormKind.None, default, out form) && false;

    /// <summary>A ball about the centre. All makers write where the body is to be: a copy costs as much as a
    /// ray.</summary>
    public static bool Ball(double radius, out ShapeForm form)
    {
        form = default;
        (form.Kind, form.Radius) = (FormKind.Ball, radius);
        return true;
    }

    /// <summary>A segment, with a radius or without.</summary>
    public static bool Capsule(in Double3 a, in Double3 b, in Double3 center, double radius, out ShapeForm form)
    {
        form = default;
        (form.Kind, form.Radius, form.Center) = (FormKind.Segment, radius, center);
        (form.A, form.B) = (a - center, b - center);
        return true;
    }

    public static bool Triangle(in Double3 a, in Double3 b, in Double3 c, in Double3 center, out ShapeForm form)
    {
        form = default;
        (form.Kind, form.Center) = (FormKind.Triangle, center);
        (form.A, form.B, form.C) = (a - center, b - center, c - center);
        return true;
    }

    /// <summary>A box, cylinder, cone, ellipsoid or swollen body.</summary>
    public static bool Of(FormKind kind, in Double3 size, out ShapeForm form)
    {
        form = default;
        (form.Kind, form.A) = (kind, size);
        return true;
    }

    /// <summary>A hull, or the box that it is; no body without a hull.</summary>
    public static bool Of(ConvexHull? hull, out ShapeForm form)
    {
        form = default;
        if (hull is null) return false;
        form.Center = hull.Center;
        if (hull.IsExactBox) (form.Kind, form.A) = (FormKind.Box, hull.Cells.Stretch);
        else (form.Kind, form.Hull) = (FormKind.Hull, hull);
        return true;
    }

    /// <summary>Scales the body along its axes; the centre is the caller's to scale.</summary>
    /// <returns>False where that leaves no body of these forms.</returns>
    public bool Scale(in AxisScale scale)
    {
        if (IsPlaced) return false;
        if (IsRounded && !scale.KeepsBalls) return TrySwell(scale.Factors);
        Double3 size = new(Math.Abs(scale.Factors.X), Math.Abs(scale.Factors.Y), Math.Abs(scale.Factors.Z));
        switch (Kind)
        {
            case FormKind.Ball when !scale.KeepsBalls:
                Kind = FormKind.Ellipsoid;
                A = size * Radius;
                Radius = 0;
                return true;
            case FormKind.Box or FormKind.Ellipsoid:
                A = Double3.Multiply(size, A);
                return true;
            case FormKind.Cylinder or FormKind.Cone or FormKind.Hull:
            case FormKind.Segment when IsScaled || (!scale.KeepsBalls && Radius > 0):
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
        axis = Kind switch
        {
            FormKind.Cylinder or FormKind.Cone => new Double3(0, 1, 0),
            FormKind.Segment => A - B,
            FormKind.Swollen => A,
            _ => default,
        };
        if (Kind == FormKind.Ellipsoid) return Keeps(A, ref axis);
        bool isRound = axis != default || Kind is FormKind.Ball or FormKind.Segment;
        return isRound && (!IsScaled || Keeps(Factors, ref axis));
    }

    /// <summary>A margin that is scaled unevenly belongs to the body, which may stay one of revolution.</summary>
    private bool TrySwell(in Double3 factors)
    {
        if (!TryGetAxis(out Double3 axis) || !Keeps(factors, ref axis)) return false;
        Kind = FormKind.Swollen;
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
        if (!IsScaled && (Kind is FormKind.Ball or FormKind.Segment)) Radius += radius;
        else IsRounded |= radius > 0;
    }

    /// <summary>Turns the body; the centre is the caller's to place.</summary>
    /// <returns>False where it is turned already.</returns>
    public bool Rotate(in QuaternionD turn)
    {
        bool wasPlaced = IsPlaced;
        Turn = turn;
        IsPlaced = true;
        return !wasPlaced;
    }
}
