namespace Gjk.Exact.Answers;

/// <summary>A hash of every field of results, iterations and the signs of zeros too; all NaN count as one. Equal hashes
/// mean that two runs took the same way to the same bits. <see cref="ResultHash"/>, which programs print, leaves some
/// out.</summary>
public struct BitHash
{
    private const uint NotANumber = 0x7FC00000;

    private Fnv1a _hash = new();

    public BitHash()
    {
    }

    public void Add(int number) => _hash.Add((uint)number);

    public void Add(in DistanceResult result)
    {
        Add((int)result.Status);
        Add(result.Distance);
        Add(result.LowerBound);
        Add(result.PointA);
        Add(result.PointB);
        Add(result.Normal);
        Add(result.LocalPointA);
        Add(result.LocalPointB);
        Add(result.Iterations);
    }

    public void Add(in CastResult result)
    {
        Add((int)result.Status);
        Add(result.Fraction);
        Add(result.Point);
        Add(result.Normal);
        Add(result.Iterations);
    }

    public void Add(in RayCastResult result)
    {
        Add((int)result.Status);
        Add(result.Distance);
        Add(result.Point);
        Add(result.Normal);
        Add(result.Iterations);
    }

    public void Add(in ContactManifold manifold)
    {
        Add(manifold.Count);
        Add(manifold.Normal);
        for (int i = 0; i < manifold.Count; i++)
        {
            ManifoldPoint point = manifold[i];
            Add(point.PointA);
            Add(point.PointB);
            Add(point.LocalPointA);
            Add(point.LocalPointB);
            Add(point.Gap);
            Add((int)(point.FeatureId >> 32));
            Add((int)point.FeatureId);
        }
    }

    public void Add(in MassProperties mass)
    {
        Add(mass.Volume);
        Add(mass.Mass);
        Add(mass.Center);
        Add(mass.InertiaDiagonal);
        Add(mass.InertiaProducts);
    }

    /// <summary>16 lowercase hexadecimal digits.</summary>
    public override readonly string ToString() => _hash.ToString();

    private void Add(Vector3 v)
    {
        Add(v.X);
        Add(v.Y);
        Add(v.Z);
    }

    private void Add(in Double3 v)
    {
        Add(v.X);
        Add(v.Y);
        Add(v.Z);
    }

    private void Add(double x)
    {
        long bits = BitConverter.DoubleToInt64Bits(x);
        Add((int)(bits >> 32));
        Add((int)bits);
    }

    private unsafe void Add(float x) => _hash.Add(float.IsNaN(x) ? NotANumber : *(uint*)&x);
}
