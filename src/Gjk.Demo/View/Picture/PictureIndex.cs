namespace Gjk.Demo.View;

/// <summary>Finds the bodies that may hide a part of a ball, without a look at all bodies. Each body is a box in a
/// tree: the rectangle that the eye sees, and how near it is.</summary>
internal sealed class PictureIndex
{
    /// <summary>Larger coordinates count as this one. It is far outside of any picture.</summary>
    private const double Furthest = 1e30;

    /// <summary>By this share, and by this much, every box is larger than its ball. It covers all rounding.</summary>
    private const double Slack = 1e-6;

    private readonly PictureCamera _camera;
    private readonly DynamicAabbTree _tree = new();

    public PictureIndex(PictureCamera camera, PictureBody[] bodies)
    {
        _camera = camera;
        for (int i = 0; i < bodies.Length; i++)
        {
            double near = bodies[i].EyeDistance - bodies[i].Radius;
            _tree.Add(i, Box(bodies[i].Center, bodies[i].Radius, near, near));
        }
    }

    /// <summary>How many bodies were found so far, in all searches.</summary>
    public long Found { get; private set; }

    /// <summary>Lists the bodies that may be seen before a ball, or overlapping it, in the order of their
    /// numbers.</summary>
    public void Collect(in Double3 center, double radius, List<int> bodies)
    {
        double far = (center - _camera.Eye).Length + radius;
        _tree.CollectInBox(Box(center, radius, -Furthest, far), bodies);
        Found += bodies.Count;
    }

    private Aabb Box(in Double3 center, double radius, double near, double far)
    {
        (double left, double right, double bottom, double top) = _camera.Bounds(center, radius);
        return new Aabb(
            new Vector3(Below(left), Below(bottom), Below(near)), new Vector3(Above(right), Above(top), Above(far)));
    }

    private static float Below(double value) => (float)Math.Max(value - Slack * (1 + Math.Abs(value)), -Furthest);

    private static float Above(double value) => (float)Math.Min(value + Slack * (1 + Math.Abs(value)), Furthest);
}
