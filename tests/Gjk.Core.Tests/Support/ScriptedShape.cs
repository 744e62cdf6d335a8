namespace Gjk.Core.Tests.Support;

/// <summary>A shape whose supports are told in advance, whatever the direction; the last is repeated. With a point as
/// the other shape it says which vertices of the Minkowski difference a solver meets, to the last bit.</summary>
internal readonly struct ScriptedShape : ISupportMap
{
    private readonly Double3[] _points;
    private readonly int _id;
    private readonly int[] _calls = new int[1];

    /// <param name="points">The support points, in order.</param>
    /// <param name="isCurved">Whether they come without ids.</param>
    /// <param name="radius">What it says of its size; by default what is true.</param>
    public ScriptedShape(Double3[] points, bool isCurved = false, double radius = 0)
    {
        _points = points;
        _id = isCurved ? -1 : 0;
        BoundingRadius = Math.Max(radius, points.Max(p => p.Length));
    }

    public Double3 Center => default;

    public double Margin => 0;

    public double BoundingRadius { get; }

    public int Support(in Double3 direction, out Double3 point)
    {
        point = _points[Math.Min(_calls[0]++, _points.Length - 1)];
        return _id;
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    public bool TryGetVertex(int id, out Double3 point)
    {
        point = default;
        return false;
    }
}
