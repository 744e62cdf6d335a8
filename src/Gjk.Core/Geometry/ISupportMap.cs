namespace Gjk.Core;

/// <summary>A convex shape as GJK sees it: the furthest point in a direction. Implement it with a readonly struct, and
/// every query of the library works on your shape.</summary>
/// <remarks>The shape is the core (what <see cref="Support"/> describes) widened by <see cref="Margin"/>: a sphere is a
/// point with a margin, a capsule a segment with one. All values are in the shape's local frame, and points are
/// measured from <see cref="Center"/>: so a shape far from its local origin loses no accuracy. A result on a shape is
/// as exact as its support is, so compute it in double. One that computes in float leaves a band of some 1e-7 of the
/// size around contact in which <c>Overlaps</c> and <c>Distance</c> may disagree.</remarks>
public interface ISupportMap
{
    /// <summary>A point in the middle of the core, or near it. Where it is the local origin, return that.</summary>
    Double3 Center { get; }

    /// <summary>How far the shape reaches beyond the core, from 0 to 1e150, in local units.</summary>
    double Margin { get; }

    /// <summary>The radius of a ball about <see cref="Center"/> that holds the whole shape, margin included. It may be
    /// generous: it only serves to reject pairs early, and no tolerance depends on it. From 0 to 1e150, as all lengths;
    /// a negative or larger one, or NaN, gives <see cref="GjkStatus.InvalidInput"/>.</summary>
    double BoundingRadius { get; }

    /// <summary>The point of the core that is furthest in a direction.</summary>
    /// <param name="direction">Finite, not zero, of any length.</param>
    /// <param name="point">The furthest point, measured from <see cref="Center"/>; any of them where there are
    /// several.</param>
    /// <returns>The id of the vertex, at least 0, or -1 where the shape has no vertices (a curved core).</returns>
    int Support(in Double3 direction, out Double3 point);

    /// <summary>Shows the face, edge or corner of the core that lies furthest in a direction, for <c>Contacts</c>; may
    /// be left empty, and then the contact is the one pair of deepest points, as it is of a round side.</summary>
    /// <remarks>The built-in shapes show a face that is tilted by up to 60 degrees against the direction; where there
    /// is none, an edge that is level to within 30 degrees; else a corner.</remarks>
    /// <param name="direction">Finite, not zero, of any length.</param>
    /// <param name="corners">Empty; to be filled with the corners of a flat convex face in order, either way round,
    /// with the two ends of an edge, with a corner, or with nothing. They hold the support point, as far as the shape
    /// has corners.</param>
    void GetFace(in Double3 direction, ref FaceCorners corners);

    /// <summary>The core's vertex with the given id, for warm starts: false when there is none with that id.</summary>
    /// <param name="id">Any number; a stale one must be refused, not trusted.</param>
    /// <param name="point">The vertex, exactly as <see cref="Support"/> returns it.</param>
    bool TryGetVertex(int id, out Double3 point);
}
