namespace Gjk.Core;

/// <summary>A static object that a body touches, and what is around it.</summary>
internal readonly struct Ground(SceneObjects objects, int slot)
{
    private readonly Aabb _box = objects.Bounds[slot].BoxAt(objects.Poses[slot]);
    private readonly double _place = ((Double3)objects.Poses[slot].Position).SumOfMagnitudes;

    public int Slot => slot;

    /// <summary>Whether it may hold a point that is no further from a box, whose magnitudes are given.</summary>
    public bool IsNear(in PartBox box, double place, double lift)
    {
        Double3 below = box.Min - _box.Max, above = (Double3)_box.Min - box.Max;
        double size = below.SumOfMagnitudes + above.SumOfMagnitudes + _place + place;
        double room = lift + 2 * CoveredSides.Room * size;
        return Math.Max(Math.Max(below.X, above.X), Math.Max(below.Y, above.Y)) <= room
            && Math.Max(below.Z, above.Z) <= room;
    }
}
