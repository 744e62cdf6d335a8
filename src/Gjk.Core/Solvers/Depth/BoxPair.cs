namespace Gjk.Core;

/// <summary>Two boxes in A's frame, from A's centre, and the axis across which they are nearest to apart.</summary>
internal readonly struct BoxPair
{
    /// <summary>Count of the axes across faces, A's and then B's.</summary>
    public const int Faces = 6;

    /// <summary>Half the side lengths.</summary>
    public readonly Double3 HalfA, HalfB;

    /// <summary>B's axes.</summary>
    public readonly Double3 X, Y, Z;

    /// <summary>B's centre.</summary>
    public readonly Double3 Between;

    /// <summary>The axis's number: across A's faces, across B's, and then across A's first edge and each of
    /// B's.</summary>
    public readonly int Axis;

    public BoxPair(in Double3 halfA, in Double3 halfB, in PairFrame frame, int axis)
    {
        HalfA = halfA;
        HalfB = halfB;
        X = new Double3(frame.Rotation.M00, frame.Rotation.M10, frame.Rotation.M20);
        Y = new Double3(frame.Rotation.M01, frame.Rotation.M11, frame.Rotation.M21);
        Z = new Double3(frame.Rotation.M02, frame.Rotation.M12, frame.Rotation.M22);
        Between = frame.Translation;
        Axis = axis;
    }

    /// <summary>One of B's axes.</summary>
    public Double3 AxisOfB(int index) => index == 0 ? X : index == 1 ? Y : Z;

    /// <summary>A direction in B's axes.</summary>
    public Double3 ToB(in Double3 v) => new(Double3.Dot(X, v), Double3.Dot(Y, v), Double3.Dot(Z, v));

    /// <summary>Along which of A's axes the edge of the axis lies.</summary>
    public int EdgeOfA => (Axis - Faces) / 3;

    /// <summary>Along which of B's axes the edge of the axis lies.</summary>
    public int EdgeOfB => (Axis - Faces) % 3;

    /// <summary>The axis, turned to the side of B; of unit length across a face, and of any across edges.</summary>
    public Double3 Outward
    {
        get
        {
            Double3 axis = Axis < 3 ? Unit(Axis) : Axis < Faces ? AxisOfB(Axis - 3) : AcrossEdges;
            return Double3.Dot(axis, Between) < 0 ? -axis : axis;
        }
    }

    /// <summary>Perpendicular to A's edge without rounding.</summary>
    private Double3 AcrossEdges
    {
        get
        {
            Double3 b = AxisOfB(EdgeOfB);
            return EdgeOfA switch
            {
                0 => new Double3(0, -b.Z, b.Y),
                1 => new Double3(b.Z, 0, -b.X),
                _ => new Double3(-b.Y, b.X, 0),
            };
        }
    }

    /// <summary>One of A's axes.</summary>
    public static Double3 Unit(int index) =>
        index == 0 ? new Double3(1, 0, 0) : index == 1 ? new Double3(0, 1, 0) : new Double3(0, 0, 1);
}
