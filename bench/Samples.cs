namespace Gjk.Bench;

/// <summary>Repeated measurements of the same thing.</summary>
public sealed class Samples
{
    private readonly List<double> _values = [];

    public double Minimum => _values.Min();

    public double Median => _values.Order().ElementAt(_values.Count / 2);

    public void Add(double value) => _values.Add(value);

    public override string ToString() => FormattableString.Invariant($"{Minimum:0.0} (median {Median:0.0})");
}
