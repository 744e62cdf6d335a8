namespace Gjk.Core.Diagnostics;

/// <summary>Takes what a solver sees out of its units and out of the axes of A's core, to A's frame.</summary>
internal readonly struct TraceAxes
{
    private readonly QuaternionD? _turn;
    private readonly double _unit;

    public TraceAxes(in PairFrame frame)
    {
        _turn = frame.TurnOfA;
        _unit = frame.Unit;
    }

    public double Length(double length) => length * _unit;

    public Double3 Direction(in Double3 direction) => _turn is null ? direction : _turn.Value.Rotate(direction);

    public Double3 Vector(in Double3 v) => Direction(v * _unit);
}
