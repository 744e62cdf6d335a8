#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>Four pairs in the course of a walk: the <see cref="PairFrame"/>, the nearest feature and its vertices, and
/// what has become of each, as masks of lanes.</summary>
internal struct WidePairs
{
    /// <summary>As in <see cref="PairFrame"/>.</summary>
    public WideRotation Rotation, RotationA;

    /// <inheritdoc cref="Rotation"/>
    public WideVector Translation, CenterA, CenterB, PositionA;

    /// <inheritdoc cref="Rotation"/>
    public Lanes MarginA, MarginB, RadiusA, RadiusB;

    /// <summary>Mask: the pair has a placed shape, and its axes are those of the cores.</summary>
    public Lanes ArePlaced;

    /// <summary>As in <see cref="FeatureVertices"/>, and the newest vertex.</summary>
    public WideVector A, B, C, W;

    /// <summary>The slots of the vertices: A's shape's below, B's in the upper half.</summary>
    public Vector256<long> SlotsA, SlotsB, SlotsC, SlotsW;

    /// <inheritdoc cref="A"/>
    public Lanes Count, Winding;

    /// <summary>As in <see cref="ClosestFeature"/>.</summary>
    public WideVector Normal;

    /// <inheritdoc cref="Normal"/>
    public Lanes Height, NormalSquared;

    /// <summary>The feature's squared distance, and the value of the newest plane.</summary>
    public Lanes DistanceSquared, Plane;

    /// <summary>The tolerances of each pair.</summary>
    public Lanes TouchSquared, NoiseSquared, LevelSquared, ReachSquared;

    /// <summary>How many supports each took.</summary>
    public Lanes Iterations;

    /// <summary>Masks: still walking; a plane has shown the cores apart.</summary>
    public Lanes Live, Separated;

    /// <summary>Masks of the ends: the bounds have met; a plane is further than asked; the origin is inside the
    /// tetrahedron of W and the three vertices. What ended in no way is for the scalar query.</summary>
    public Lanes Closed, Beyond, Inside;

    /// <summary>The vertices of A - B made of a point of each shape, measured from its centre in its own
    /// axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly WideVector Vertex(in WideVector onA, in WideVector onB) =>
        onA - (Rotation.Rotate(onB) + Translation);

    /// <summary>B and C change places in the lanes of the mask.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void FlipFaces(Lanes turned)
    {
        WideVector b = B;
        B = WideVector.Select(turned, C, b);
        C = WideVector.Select(turned, b, C);
        Vector256<long> slots = SlotsB;
        SlotsB = WideLanes.Select(turned, SlotsC, slots);
        SlotsC = WideLanes.Select(turned, slots, SlotsC);
    }
}
#endif
