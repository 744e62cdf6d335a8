using Gjk.Exact.Fuzz.Families;

namespace Gjk.Exact.Fuzz.Blocks;

/// <summary>The pairs of a block, one after the other. Its shapes are made once, and each pair follows from the one
/// before, so that a pair costs little: what the last answer said is used to place B where the next one is
/// hard.</summary>
internal sealed class BlockPairs
{
    private const int ShapeCount = 96;

    /// <summary>Positions beyond it are drawn again: sums of two must stay floats.</summary>
    private const double Largest = 1e37;

    private readonly Rng _random;
    private readonly ConvexShape[] _shapes = new ConvexShape[ShapeCount];
    private ConvexShape _a, _b;
    private Quaternion _turnA, _turnB;
    private Double3 _centers, _toldCenters;
    private DistanceResult _told;
    private Vector3 _offset;
    private bool _isFar;

    /// <param name="seed">Of the block.</param>
    public BlockPairs(ulong seed)
    {
        _random = new Rng(seed);
        float unit = _random.OneIn(4) ? (float)_random.Magnitude(1e-12, 1e12) : 1;
        for (int i = 0; i < ShapeCount; i++) _shapes[i] = Sized(Decorated(Shape()), unit);
    }

    /// <summary>The first shape.</summary>
    public ref readonly ConvexShape A => ref _a;

    /// <summary>The second shape.</summary>
    public ref readonly ConvexShape B => ref _b;

    /// <summary>Where the first shape is.</summary>
    public RigidPose PoseA { get; private set; }

    /// <summary>Where the second shape is.</summary>
    public RigidPose PoseB { get; private set; }

    /// <summary>Both bounding radii.</summary>
    public double Size { get; private set; }

    /// <summary>Goes to the next pair.</summary>
    public void Next()
    {
        int step = _a.Kind == ShapeKind.None ? 0 : _random.Below(10);
        if (step < 3) Draw();
        else if (step < 7) Touch();
        else if (step == 7) _turnB = _random.OneIn(2) ? Rotations.Nudged(_random, _turnB) : Aligned();
        else if (step == 8) _centers += _random.Direction() * (Size * _random.Magnitude(1e-9, 1));
        else _centers *= _random.OneIn(4) ? 0 : _random.Unit();
        if (TryPlace()) return;
        Draw();
        TryPlace();
    }

    /// <summary>Takes an answer about the pair at hand, to place others by.</summary>
    public void Tell(in DistanceResult answer) => (_told, _toldCenters) = (answer, _centers);

    /// <summary>How the pair might move, from touching nothing to running into each other.</summary>
    /// <param name="velocityA">Of the first shape.</param>
    /// <param name="velocityB">Of the second shape.</param>
    public void DrawMotion(out Vector3 velocityA, out Vector3 velocityB)
    {
        double size = Size > 0 ? Size : 1;
        Double3 normal = _told.Normal, aside = _random.Direction(), way = _random.Below(6) switch
        {
            0 => aside * (size * _random.Range(0, 3)),
            1 => aside * (size * _random.Magnitude(1e-6, 1e4)),
            2 => (aside - normal * Double3.Dot(aside, normal)) * (size * _random.Range(0, 3)),
            3 => normal * (-_told.Distance * _random.Range(0.5, 3)),
            _ => aside * (size * _random.Unit()) - _centers * _random.Range(0.3, 2),
        };
        if (!(way.Length < Largest)) way = default;
        velocityA = _random.OneIn(2) ? default : _random.Vector(size);
        velocityB = (Vector3)(velocityA + way);
    }

    /// <summary>A ray towards the first shape, from near or far.</summary>
    /// <param name="origin">Where it begins.</param>
    /// <param name="direction">Of any length.</param>
    public void DrawRay(out Vector3 origin, out Vector3 direction)
    {
        double radius = _a.BoundingRadius > 0 ? _a.BoundingRadius : 1;
        Double3 center = PoseA.Position + Turned(_turnA, _a.Center);
        Double3 aim = _random.OneIn(3) ? _told.PointA : center + _random.Direction() * (radius * _random.Unit());
        Double3 from = aim + _random.Direction() * (radius * _random.Magnitude(0.1, _random.OneIn(4) ? 1e4 : 4));
        if (!(aim.IsFinite && from.Length < Largest)) (aim, from) = (center, center + new Double3(radius, 0, 0));
        origin = (Vector3)from;
        direction = (Vector3)((aim - origin) * (1 / radius));
        if (direction == default) direction = Vector3.UnitX;
    }

    /// <summary>A point on the surface of the first shape, near it, or anywhere.</summary>
    public Vector3 DrawPoint()
    {
        Double3 point = _random.OneIn(2) ? _told.PointA : (Double3)PoseA.Position + Turned(_turnA, _a.Center);
        if (_random.OneIn(2)) point += _random.Direction() * (_a.BoundingRadius * _random.Magnitude(1e-7, 2));
        return point.Length < Largest ? (Vector3)point : PoseA.Position;
    }

    /// <summary>Two shapes, one against itself now and then, at random or in line.</summary>
    private void Draw()
    {
        _told = default;
        _a = _shapes[_random.Below(ShapeCount)];
        _b = _random.OneIn(6) ? _a : _shapes[_random.Below(ShapeCount)];
        Size = _a.BoundingRadius + _b.BoundingRadius;
        _turnA = Rotations.Any(_random);
        _turnB = _random.OneIn(2) ? Rotations.Any(_random) : Aligned();
        Double3 along = _random.OneIn(2) ? _random.Direction() : Axis();
        Double3 aside = _random.OneIn(2) ? default : _random.Direction() * (0.3 * Size * _random.Unit());
        _centers = along * (Size * _random.Range(0, 1.3)) + aside;
        _isFar = _random.OneIn(4);
        _offset = _random.OneIn(2)
            ? _random.Vector(Size)
            : (Vector3)(_random.Direction() * (Size * _random.Magnitude(1e2, 1e6)));
    }

    /// <summary>Moves B along the normal that was told so that it is a chosen gap away, of either sign; also where it
    /// has been turned or moved since, a little.</summary>
    private void Touch()
    {
        double gap = _random.OneIn(4) ? 0 : _random.Sign() * _random.Magnitude(1e-15, 0.1) * Size;
        if (_told.Normal != default && float.IsFinite(_told.Distance))
            _centers = _toldCenters + (Double3)_told.Normal * (gap - _told.Distance);
        else
            _centers *= _random.Range(0.5, 2);
    }

    /// <summary>As A is turned, or by quarters from there.</summary>
    private Quaternion Aligned()
    {
        float half = (float)Math.Sqrt(0.5);
        return _random.Below(4) switch
        {
            0 => Rotations.Times(_turnA, new Quaternion(half, 0, 0, half)),
            1 => Rotations.Times(_turnA, new Quaternion(0, 0, half, half)),
            _ => _turnA,
        };
    }

    /// <summary>One of A's own axes in the world.</summary>
    private Double3 Axis()
    {
        double sign = _random.Sign();
        return Turned(_turnA, _random.Below(3) switch
        {
            0 => new Double3(sign, 0, 0),
            1 => new Double3(0, sign, 0),
            _ => new Double3(0, 0, sign),
        });
    }

    /// <summary>Near the origin what B's position loses by rounding is put into A's, so that the smallest gaps can be
    /// had.</summary>
    private bool TryPlace()
    {
        Double3 between = _centers + Turned(_turnA, _a.Center) - Turned(_turnB, _b.Center);
        Double3 a = _isFar ? _offset : default, b = a + between;
        if (!(a.Length < Largest && b.Length < Largest)) return false;
        var rounded = (Vector3)b;
        if (!_isFar) a = rounded - b;
        PoseA = new RigidPose(_turnA, (Vector3)a);
        PoseB = new RigidPose(_turnB, rounded);
        return true;
    }

    /// <summary>v + 2 u × (u × v + w v) / |q|².</summary>
    private static Double3 Turned(Quaternion q, in Double3 v)
    {
        var u = new Double3(q.X, q.Y, q.Z);
        double w = q.W;
        return v + Double3.Cross(u, Double3.Cross(u, v) + v * w) * (2 / (u.LengthSquared + w * w));
    }

    private FuzzShape Shape() => _random.Below(16) switch
    {
        0 or 1 or 2 => Shapes.Made(_random),
        3 => Shapes.Needle(_random),
        4 => Shapes.Degenerate(_random),
        5 => Shapes.Curved(_random),
        6 => Shapes.Scaled(_random),
        7 => MadeFamilies.Stretched(_random),
        8 => Shapes.Primitive(_random),
        9 or 10 => Shapes.LatticeCube(_random),
        11 => FuzzShape.Mesh(Clouds.OnSphere(_random, 8 + _random.Below(60))),
        _ => Shapes.Polytope(_random),
    };

    private ConvexShape Decorated(in FuzzShape shape) => _random.Below(12) switch
    {
        0 => shape.Shape.Rounded((float)_random.Magnitude(1e-4, 1)),
        1 => shape.Shape.Placed(new RigidPose(Rotations.Any(_random), _random.Vector(2))),
        _ => shape.Shape,
    };

    private ConvexShape Sized(in ConvexShape shape, float unit)
    {
        float own = _random.OneIn(6) ? unit * (float)_random.Magnitude(1e-3, 1e3) : unit;
        return own == 1 ? shape : shape.Scaled(new Vector3(own));
    }
}
