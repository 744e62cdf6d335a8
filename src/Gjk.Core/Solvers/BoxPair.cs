using System;

namespace Gjk.Core;

/// <summary>Two boxes in A's frame, from A's centre, and the axes that can separate them.</summary>
internal readonly struct BoxPair
{
    /// <summary>Count of the axes across faces, A's and then B's, and of all with those across edges.</summary>
    public const int Faces = 6, Axes = 15;

    /// <summary>Half the side lengths.</summary>
    public readonly Vector3D HalfA, HalfB;

    /// <summary>B's axes.</summary>
    public readonly Vector3D X, Y, Z;

    /// <summary>B's centre.</summary>
    public readonly Vector3D Between;

    public BoxPair(in Vector3D halfA, in Vector3D halfB, in PairFrame frame)
    {
        HalfA = halfA;
        HalfB = halfB;
        X = new Vector3D(frame.Rotation.M00, frame.Rotation.M10, frame.Rotation.M20);
        Y = new Vector3D(frame.Rotation.M01, frame.Rotation.M11, frame.Rotation.M21);
        Z = new Vector3D(frame.Rotation.M02, frame.Rotation.M12, frame.Rotation.M22);
        Between = frame.Translation;
    }

    /// <summary>One of B's axes.</summary>
    public Vector3D AxisOfB(int index) => index == 0 ? X : index == 1 ? Y : Z;

    /// <summary>The axis across a face, of unit length.</summary>
    public Vector3D FaceAxis(int index) => index >= 3 ? AxisOfB(index - 3) : Unit(index);

    /// <summary>
    /// The axis across an edge of A and one of B, of any length, and perpendicular to A's without rounding.
    /// </summary>
    public Vector3D EdgeAxis(int index)
    {
        Vector3D b = AxisOfB(EdgeOfB(index));
        return EdgeOfA(index) switch
        {
            0 => new Vector3D(0, -b.Z, b.Y),
            1 => new Vector3D(b.Z, 0, -b.X),
            _ => new Vector3D(-b.Y, b.X, 0),
        };
    }

    /// <summary>Along which of A's axes the edge of an axis lies.</summary>
    public static int EdgeOfA(int index) => (index - Faces) / 3;

    /// <summary>Along which of B's axes the edge of an axis lies.</summary>
    public static int EdgeOfB(int index) => (index - Faces) % 3;

    /// <summary>An axis, turned to the side of B.</summary>
    public Vector3D Outward(in Vector3D axis) => Vector3D.Dot(axis, Between) < 0 ? -axis : axis;

    /// <summary>How far B must move along an axis, on its side, to leave A behind, times the axis's length.</summary>
    public double Cost(in Vector3D axis)
    {
        double a = Math.Abs(axis.X) * HalfA.X + Math.Abs(axis.Y) * HalfA.Y + Math.Abs(axis.Z) * HalfA.Z;
        double b = Math.Abs(Vector3D.Dot(axis, X)) * HalfB.X + Math.Abs(Vector3D.Dot(axis, Y)) * HalfB.Y
            + Math.Abs(Vector3D.Dot(axis, Z)) * HalfB.Z;
        return a + b - Math.Abs(Vector3D.Dot(axis, Between));
    }

    /// <summary>One of A's axes.</summary>
    public static Vector3D Unit(int index) =>
        index == 0 ? new Vector3D(1, 0, 0) : index == 1 ? new Vector3D(0, 1, 0) : new Vector3D(0, 0, 1);
}
