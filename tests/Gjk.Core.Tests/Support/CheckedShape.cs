namespace Gjk.Core.Tests.Support;

/// <summary>A shape of a user's who trusts the promise about directions and is loud where it is broken. Everything else
/// is the shape's own.</summary>
internal readonly struct CheckedShape<T>(T inner) : ISupportMap
    where T : struct, ISupportMap
{
    private readonly T _inner = inner;

    public Double3 Center => _inner.Center;

    public double Margin => _inner.Margin;

    public double BoundingRadius => _inner.BoundingRadius;

    public int Support(in Double3 direction, out Double3 point)
    {
        Check(direction, nameof(Support));
        return _inner.Support(direction, out point);
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        Check(direction, nameof(GetFace));
        _inner.GetFace(direction, ref corners);
    }

    public bool TryGetVertex(int id, out Double3 point) => _inner.TryGetVertex(id, out point);

    private static void Check(in Double3 d, string what)
    {
        double largest = Math.Max(Math.Max(Math.Abs(d.X), Math.Abs(d.Y)), Math.Abs(d.Z));
        if (!(largest > 0 && largest <= double.MaxValue)) throw new BrokenPromiseException($"{what} towards {d}");
    }
}

internal sealed class BrokenPromiseException(string message) : Exception(message);
