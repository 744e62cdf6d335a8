namespace Gjk.Core;

/// <summary>
/// How a pair is seen along its contact normal: places across it are measured from the deepest point, so that no length
/// is larger than the shapes.
/// </summary>
internal readonly ref struct ContactView
{
    /// <summary>Where the contact is.</summary>
    public readonly ContactPlane Plane;

    private readonly PlaneBasis _basis;
    private readonly double _factor;

    public ContactView(in ContactPlane plane)
    {
        Plane = plane;
        _basis = new PlaneBasis(plane.Normal);
        _factor = 1 / plane.Frame.Unit;
    }

    /// <summary>A vector from its parts along the plane's axes and along the normal.</summary>
    public Vector3D Direction(double u, double v, double height) =>
        _basis.U * u + _basis.V * v + Plane.Normal * height;

    /// <summary>A point of A, given from its centre in its own units, from the deepest point.</summary>
    public Vector3D OfA(in Vector3D point) => point * _factor - Plane.OnA;

    /// <summary>A point of B, given from its centre in its own frame and units.</summary>
    public Vector3D OfB(in Vector3D point) =>
        Plane.Frame.Rotation.Rotate(point * _factor) + Plane.Frame.Translation - Plane.OnA;

    /// <summary>The face or edge that A shows.</summary>
    /// <param name="corners">From A's centre.</param>
    /// <param name="memory">Gets its corners.</param>
    public unsafe FlatFeature SeeA(in FaceCorners corners, FlatCorner* memory)
    {
        for (int i = 0; i < corners.Count; i++) memory[i] = See(OfA(corners[i]), 1, corners.IdOf(i));
        return new FlatFeature(memory, corners, Plane.Frame.MarginA, _factor, Plane.Size);
    }

    /// <summary>The face or edge that B shows, which reaches against the normal.</summary>
    /// <param name="corners">From B's centre in B's frame.</param>
    /// <param name="memory">Gets its corners.</param>
    public unsafe FlatFeature SeeB(in FaceCorners corners, FlatCorner* memory)
    {
        for (int i = 0; i < corners.Count; i++) memory[i] = See(OfB(corners[i]), -1, corners.IdOf(i));
        return new FlatFeature(memory, corners, Plane.Frame.MarginB, _factor, Plane.Size);
    }

    private FlatCorner See(in Vector3D p, double sign, int id) => new()
    {
        U = Vector3D.Dot(p, _basis.U),
        V = Vector3D.Dot(p, _basis.V),
        Height = Vector3D.Dot(p, Plane.Normal) * sign,
        Id = id,
    };
}
