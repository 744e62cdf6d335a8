namespace Gjk.Core.Tests.Support;

/// <summary>Seeded draws for the tests; directions and rotations are spread evenly by the normal
/// distribution.</summary>
internal sealed class Rng(ulong seed) : SplitMix64(seed)
{
    /// <summary>Evenly spread over the exponents.</summary>
    public float LogFloat(double low, double high) => (float)Magnitude(low, high);

    public double Gauss() => Math.Sqrt(-2 * Math.Log(1 - Unit())) * Math.Cos(2 * Math.PI * Unit());

    public Vector3 Vector(double low, double high) => new(Float(low, high), Float(low, high), Float(low, high));

    public Vector3 Direction()
    {
        while (true)
        {
            double x = Gauss(), y = Gauss(), z = Gauss(), length = Math.Sqrt(x * x + y * y + z * z);
            if (length > 0.1) return new Vector3((float)(x / length), (float)(y / length), (float)(z / length));
        }
    }

    public Quaternion Rotation()
    {
        while (true)
        {
            double x = Gauss(), y = Gauss(), z = Gauss(), w = Gauss();
            double length = Math.Sqrt(x * x + y * y + z * z + w * w);
            if (length > 0.1)
            {
                return new Quaternion(
                    (float)(x / length), (float)(y / length), (float)(z / length), (float)(w / length));
            }
        }
    }
}
