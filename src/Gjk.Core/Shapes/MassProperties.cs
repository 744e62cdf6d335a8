namespace Gjk.Core;

/// <summary>Volume, mass, centre of mass and inertia of a body whose density is the same everywhere.</summary>
/// <remarks>Immutable. Units are the caller's: with metres and kilograms per cubic metre a mass is in kilograms and an
/// inertia in kg·m². The frame is that of the shape; <see cref="At"/> gives the same in the world.</remarks>
public readonly struct MassProperties
{
    /// <summary>Count: a backstop; some ten turns leave nothing but rounding.</summary>
    private const int MostTurns = 32;

    /// <summary>Ratio of a product to the spread: 2^-52; less is rounding. Pinned by PrincipalInertiaTests.</summary>
    private const double NoProduct = 1.0 / (1L << 52);

    /// <summary>The integrals of x², y² and z² over the mass, and of xy, xz and yz, about the centre.</summary>
    private readonly Double3 _squares, _products;

    internal MassProperties(double volume, in Double3 center, in Double3 squares, in Double3 products = default)
        : this(volume, volume, center, squares, products)
    {
    }

    private MassProperties(
        double volume, double mass, in Double3 center, in Double3 squares, in Double3 products)
    {
        Volume = volume;
        Mass = mass;
        Center = center;
        _squares = squares;
        _products = products;
    }

    /// <summary>The volume, in units of length cubed; 0 for what is flat, straight or a point.</summary>
    public double Volume { get; }

    /// <summary>The volume times the density.</summary>
    public double Mass { get; }

    /// <summary>The centre of mass. Of a body without volume: the shape's own centre, which is the middle of a segment,
    /// the centroid of a triangle, or the middle of the bounds of a mesh.</summary>
    public Double3 Center { get; }

    /// <summary>The diagonal of the inertia tensor about <see cref="Center"/>, its entries xx, yy and zz: the integrals
    /// of y² + z², x² + z² and x² + y² over the mass.</summary>
    public Double3 InertiaDiagonal =>
        new(_squares.Y + _squares.Z, _squares.X + _squares.Z, _squares.X + _squares.Y);

    /// <summary>The rest of the inertia tensor about <see cref="Center"/>: its entries xy, xz and yz, which are minus
    /// the integrals of these products over the mass.</summary>
    public Double3 InertiaProducts => -_products;

    /// <summary>The principal moments of inertia about <see cref="Center"/>, and the axes that they are about: the
    /// form in which physics engines take an inertia.</summary>
    /// <param name="moments">The moments about the x, y and z axis of the rotated frame, each to a few roundings of the
    /// largest.</param>
    /// <param name="axes">The rotation of that frame in this one. An inertia tensor without products keeps its axes:
    /// the identity, also where moments are equal. Else the moments are in no order.</param>
    /// <remarks>Jacobi's method ("Über ein leichtes Verfahren ...", 1846): the largest product is turned away until
    /// none is left. Each step turns the tensor as it was given, so no rounding adds up.</remarks>
    public void GetPrincipalInertia(out Double3 moments, out Quaternion axes)
    {
        QuaternionD turn = QuaternionD.Identity;
        MassProperties body = this;
        for (int i = 0; i < MostTurns && body.TryJacobiRotation(out QuaternionD next); i++)
        {
            turn *= next;
            turn *= 1 / Math.Sqrt(turn.LengthSquared);
            body = Turned(turn.Conjugate, Center);
        }

        moments = body.InertiaDiagonal;
        axes = new Quaternion((float)turn.X, (float)turn.Y, (float)turn.Z, (float)turn.W);
    }

    /// <summary>The turn of the axes that leaves nothing of the largest product.</summary>
    /// <returns>False where it is rounding.</returns>
    private bool TryJacobiRotation(out QuaternionD turn)
    {
        Double3 p = _products, s = _squares;
        double xy = Math.Abs(p.X), xz = Math.Abs(p.Y), yz = Math.Abs(p.Z);
        bool isZ = xy >= xz && xy >= yz, isX = !isZ && yz >= xz;
        double product = isZ ? p.X : isX ? p.Z : p.Y;
        double apart = isZ ? s.X - s.Y : isX ? s.Y - s.Z : s.Z - s.X, spread = s.SumOfMagnitudes;
        turn = QuaternionD.Identity;
        if (!(Math.Abs(product) > NoProduct * spread)) return false;

        // The tangent of twice the angle is 2 product / apart. Roots have the same bits on every target, arcs have not.
        double across = 2 * product / spread, along = Math.Abs(apart) / spread;
        double length = Math.Sqrt(across * across + along * along);
        double cosine = Math.Sqrt(0.5 + 0.5 * along / length), half = Math.Sqrt(0.5 + 0.5 * cosine);
        double sine = across / (4 * length * cosine * half) * (apart < 0 ? -1 : 1);
        turn = new QuaternionD(isX ? sine : 0, isX || isZ ? 0 : sine, isZ ? sine : 0, half);
        return true;
    }

    /// <summary>Mass, volume, centre and inertia, for people.</summary>
    public override string ToString() =>
        FormattableString.Invariant($"mass {Mass:G6}, volume {Volume:G6}, centre {Center.ToText()}, ")
        + $"inertia {InertiaDiagonal.ToText()} and {InertiaProducts.ToText()}";

    /// <summary>Two bodies as one; what lies in both counts twice. Where neither has a mass, the centre is that of the
    /// first.</summary>
    public static MassProperties operator +(in MassProperties a, in MassProperties b)
    {
        double mass = a.Mass + b.Mass, share = mass > 0 ? b.Mass / mass : 0, lever = a.Mass * share;
        Double3 apart = b.Center - a.Center;
        Double3 crossed = new(apart.X * apart.Y, apart.X * apart.Z, apart.Y * apart.Z);
        return new(
            a.Volume + b.Volume, mass, a.Center + apart * share,
            a._squares + b._squares + Double3.Multiply(apart, apart) * lever,
            a._products + b._products + crossed * lever);
    }

    /// <summary>Of the same body at a pose, with the inertia along the axes of the world.</summary>
    /// <param name="pose">Where the body is.</param>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    public MassProperties At(in RigidPose pose)
    {
        Guard.Pose(pose, nameof(pose));
        return Turned(pose.Rotation, (Double3)VectorDD.ToWorld(pose, Center));
    }

    /// <summary>The same body, turned, with its centre elsewhere.</summary>
    internal MassProperties Turned(in QuaternionD rotation, in Double3 center)
    {
        var turn = new RotationD(rotation);
        Double3 x = turn.Rotate(new Double3(_squares.X, _products.X, _products.Y));
        Double3 y = turn.Rotate(new Double3(_products.X, _squares.Y, _products.Z));
        Double3 z = turn.Rotate(new Double3(_products.Y, _products.Z, _squares.Z));
        Double3 first = turn.Rotate(new Double3(x.X, y.X, z.X)), second = turn.Rotate(new Double3(x.Y, y.Y, z.Y));
        Double3 third = turn.Rotate(new Double3(x.Z, y.Z, z.Z));
        return new(
            Volume, Mass, center, new Double3(first.X, second.Y, third.Z),
            new Double3(first.Y, first.Z, second.Z));
    }

    /// <summary>The same body scaled about the local origin, of the same density.</summary>
    internal MassProperties Stretched(in Double3 factors)
    {
        double change = Math.Abs(factors.X * factors.Y * factors.Z);
        Double3 crossed = new(factors.X * factors.Y, factors.X * factors.Z, factors.Y * factors.Z);
        return new(
            Volume * change, Mass * change, Double3.Multiply(Center, factors),
            Double3.Multiply(_squares, Double3.Multiply(factors, factors)) * change,
            Double3.Multiply(_products, crossed) * change);
    }

    /// <summary>The same body, heavier.</summary>
    internal MassProperties Times(double density) =>
        new(Volume, Mass * density, Center, _squares * density, _products * density);
}
