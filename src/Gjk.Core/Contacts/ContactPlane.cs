using System;

namespace Gjk.Core;

/// <summary>Where a query of the signed distance ended, as contacts need it, in the pair's frame.</summary>
internal readonly struct ContactPlane
{
    /// <summary>The pair.</summary>
    public readonly PairFrame Frame;

    /// <summary>From A to B, of unit length.</summary>
    public readonly Vector3D Normal;

    /// <summary>The point of A's core that is deepest or closest.</summary>
    public readonly Vector3D OnA;

    /// <summary>How far the cores are apart along the normal; negative when they overlap.</summary>
    public readonly double CoreDistance;

    /// <summary>How far the shapes are apart, margins included.</summary>
    public double Distance => CoreDistance - Frame.Margins;

    /// <summary>Of the pair: what lengths are relative to.</summary>
    public readonly double Size;

    public ContactPlane(in PairFrame frame, in SolverState state)
    {
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        Frame = frame;
        Normal = state.Feature.Normal * -scale;
        OnA = state.Simplex.PointOnA(state.Weights).ToVector3D();
        CoreDistance = state.Feature.Height * scale;
        Size = state.Size.Value;
    }
}
