namespace Gjk.Core;

/// <summary>A box that grows.</summary>
internal struct PartBox
{
    public double MinX, MinY, MinZ, MaxX, MaxY, MaxZ;

    public PartBox(in Double3 min, in Double3 max)
    {
        (MinX, MinY, MinZ) = (min.X, min.Y, min.Z);
        (MaxX, MaxY, MaxZ) = (max.X, max.Y, max.Z);
    }

    /// <summary>Holds no point.</summary>
    public static PartBox Nothing { get; } = new(
        new Double3(double.MaxValue, double.MaxValue, double.MaxValue),
        new Double3(double.MinValue, double.MinValue, double.MinValue));

    /// <summary>Holds all points.</summary>
    public static PartBox Everything { get; } = new(
        new Double3(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity),
        new Double3(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity));

    /// <summary>Holds all parts.</summary>
    public static PartBox Around(IPartSource source)
    {
        PartBox all = Nothing;
        for (int i = 0; i < source.Count; i++) all.Add(new PartItem(source, i).Box);
        return all;
    }

    public readonly Double3 Min => new(MinX, MinY, MinZ);

    public readonly Double3 Max => new(MaxX, MaxY, MaxZ);

    /// <summary>Half the surface.</summary>
    public readonly double Area
    {
        get
        {
            double x = MaxX - MinX, y = MaxY - MinY, z = MaxZ - MinZ;
            return x * y + y * z + z * x;
        }
    }

    public void Add(in PartBox box)
    {
        if (box.MinX < MinX) MinX = box.MinX;
        if (box.MinY < MinY) MinY = box.MinY;
        if (box.MinZ < MinZ) MinZ = box.MinZ;
        if (box.MaxX > MaxX) MaxX = box.MaxX;
        if (box.MaxY > MaxY) MaxY = box.MaxY;
        if (box.MaxZ > MaxZ) MaxZ = box.MaxZ;
    }

    public void Add(in Double3 point) => Add(new PartBox(point, point));

    /// <summary>Twice the middle along an axis.</summary>
    public readonly double Middle(int axis) => axis == 0 ? MinX + MaxX : axis == 1 ? MinY + MaxY : MinZ + MaxZ;
}
