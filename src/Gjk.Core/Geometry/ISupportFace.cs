namespace Gjk.Core;

/// <summary>
/// What a shape besides <see cref="ISupportMap"/> implements so that <see cref="ConvexQuery"/> finds more than one
/// contact point: it shows the face, the edge or the corner that lies furthest in a direction.
/// </summary>
/// <remarks>
/// Of a shape without this, and of a round side, the contact is the one pair of deepest points. The built-in shapes
/// show a face that is tilted by up to 60 degrees against the direction; where there is none, an edge that is level to
/// within 30 degrees; else a corner. A struct is called without boxing, but where the runtime cannot make a delegate of
/// its method: ahead-of-time compilers may box it once a query.
/// </remarks>
public interface ISupportFace
{
    /// <summary>Shows the face, edge or corner of the core that lies furthest in a direction.</summary>
    /// <param name="direction">In the local frame, finite, not zero, of any length.</param>
    /// <param name="corners">
    /// Empty; to be filled with the corners of a flat convex face in order, either way round, with the two ends of an
    /// edge, with a corner, or with nothing. They hold the support point, as far as the shape has corners.
    /// </param>
    void GetFace(in Vector3D direction, ref FaceCorners corners);
}
