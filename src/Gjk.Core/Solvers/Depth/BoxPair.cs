namespace Gjk.Core;

/// <summary>Two boxes in A's frame, from A's centre, and the axis across which they are nearest to apart.</summary>
internal readonly struct BoxPair
{
    /// <summary>Count of the axes across faces, A's and then B's.</summary>
    public const int Faces = 6;

    /// <summary>Half the side lengths.</summary>
    public readonly Vector3D HalfA, HalfB;

    /// <summary>B's axes.</summary>
    public readonly Vector3D X, Y, Z;

    /// <summary>B's centre.</summary>
    public readonly Vector3D Between;

    /// <summary>
    /// The axis's number: across A's faces, across B's, and then across A's first edge and each of B's.
    /// </summary>
    public readonly int Axis;

    public BoxPair(in Vector3D halfA, in Vector3D halfB, in PairFrame frame, int axis)
    {
        HalfA = halfA;
        HalfB = halfB;
        X = new Vector3D(frame.Rotation.M00, frame.Rotation.M10, frame.Rotation.M20);
        Y = new Vector3D(frame.Rotation.M01, frame.Rotation.M11, frame.Rotation.M21);
        Z = new Vector3D(frame.Rotation.M02, frame.Rotation.M12, frame.Rotation.M22);
        Between = frame.Translation;
        Axis = axis;
    }

    /// <summary>One of B's axes.</summary>
    public Vector3D AxisOfB(int index) => index == 0 ? X : index == 1 ? Y : Z;

    /// <summary>A direction in B's axes.</summary>
    public Vector3D ToB(in Vector3D v) => new(Vector3D.Dot(X, v), Vector3D.Dot(Y, v), Vector3D.Dot(Z, v));

    /// <summary>Along which of A's axes the edge of the axis lies.</summary>
    public int EdgeOfA => (Axis - Faces) / 3;

    /// <summary>Along which of B's axes the edge of the axis lies.</summary>
    public int EdgeOfB => (Axis - Faces) % 3;

    /// <summary>The axis, turned to the side of B; of unit length across a face, and of any across edges.</summary>
    public Vector3D Outward
    {
        get
        {
            Vector3D axis = Axis < 3 ? Unit(Axis) : Axis < Faces ? AxisOfB(Axis - 3) : AcrossEdges;
            return Vector3D.Dot(axis, Between) < 0 ? -axis : axis;
        }
    }

    /// <summary>Perpendicular to A's edge without rounding.</summary>
    private Vector3D AcrossEdges
    {
        get
        {
            Vector3D b = AxisOfB(EdgeOfB);
            return EdgeOfA switch
            {
                0 => new Vector3D(0, -b.Z, b.Y),
                1 => new Vector3D(b.Z, 0, -b.X),
                _ => new Vector3D(-b.Y, b.X, 0),
            };
        }
    }

    /// <summary>One of A's axes.</summary>
    public static Vector3D Unit(int index) =>
        index == 0 ? new Vector3D(1, 0, 0) : index == 1 ? new Vector3D(0, 1, 0) : new Vector3D(0, 0, 1);
}
