namespace Gjk.Core;

/// <summary>Where a query of the signed distance ended, as contacts need it, in the pair's frame. Places across the
/// normal are measured from the deepest point, so that no length is larger than the shapes.</summary>
internal struct ContactPlane
{
    /// <summary>The pair.</summary>
    public PairFrame Frame;

    /// <summary>From A to B, of unit length; 0 where nothing but the result says where the contact is.</summary>
    public Double3 Normal;

    /// <summary>The point of A's core that is deepest or closest.</summary>
    public Double3 OnA;

    /// <summary>How far the cores are apart along the normal; negative when they overlap.</summary>
    public double CoreDistance;

    /// <summary>Whether A here is B of the query (<see cref="PairOrder"/>).</summary>
    public bool IsExchanged;

    /// <summary>Of the pair: what lengths are relative to.</summary>
    public double Size;

    private PlaneBasis _basis;
    private double _factor;

    /// <summary>How far the shapes are apart, margins included.</summary>
    public readonly double Distance => CoreDistance - Frame.Margins;

    /// <summary>Fills it where it is to be: a copy would cost as much as what it is for.</summary>
    public void Set(in PairFrame frame, in SolverState state)
    {
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        Frame = frame;
        Normal = state.Feature.Normal * -scale;
        OnA = state.Simplex.WitnessOnA(state.Weights);
        CoreDistance = state.Feature.Height * scale;
        Size = state.Size.Value;
    }

    /// <summary>The same where A's centre is the deepest point.</summary>
    public void Set(in Double3 normal, double coreDistance, double size) =>
        (Normal, OnA, CoreDistance, Size) = (normal, default, coreDistance, size);

    /// <summary>From A to B of the query, in the world.</summary>
    public readonly Double3 NormalOfQuery =>
        IsExchanged ? -Frame.RotationA.Rotate(Normal) : Frame.RotationA.Rotate(Normal);

    /// <summary>Whether no deepest point is known along the normal.</summary>
    public readonly bool IsOpen => double.IsNegativeInfinity(CoreDistance);

    /// <summary>Looks along another normal, along which no deepest point is known.</summary>
    public void SetAlong(in Double3 normal)
    {
        Normal = normal;
        CoreDistance = double.NegativeInfinity;
    }

    /// <summary>Finds its axes, without which nothing can be seen along the normal.</summary>
    public void Span()
    {
        _basis = new PlaneBasis(Normal);
        _factor = 1 / Frame.Unit;
    }

    /// <summary>A vector from its parts along the plane's axes and along the normal.</summary>
    public readonly Double3 Direction(double u, double v, double height) =>
        _basis.U * u + _basis.V * v + Normal * height;

    /// <summary>A point of a shape, given from its centre in its frame and units, from the deepest point.</summary>
    public readonly Double3 Of(in Double3 point, bool isOfA)
    {
        Double3 p = point * _factor;
        return (isOfA ? p : Frame.Rotation.Rotate(p) + Frame.Translation) - OnA;
    }

    /// <summary>What the core of A or of B is widened by.</summary>
    public readonly double MarginOf(bool isOfA) => isOfA ? Frame.MarginA : Frame.MarginB;

    /// <summary>The face or edge that a shape shows.</summary>
    /// <param name="corners">From its centre, in its frame.</param>
    /// <param name="isOfA">Whether the shape is A; B reaches against the normal.</param>
    /// <param name="memory">Gets the corners.</param>
    public readonly unsafe FlatFeature Project(in FaceCorners corners, bool isOfA, FlatCorner* memory)
    {
        double sign = isOfA ? 1 : -1;
        for (int i = 0; i < corners.Count; i++)
        {
            Double3 p = Of(corners[i], isOfA);
            ref FlatCorner corner = ref memory[i];
            corner.U = Double3.Dot(p, _basis.U);
            corner.V = Double3.Dot(p, _basis.V);
            corner.Height = Double3.Dot(p, Normal) * sign;
            corner.Id = corners.IdOf(i);
        }

        return new FlatFeature(memory, corners, MarginOf(isOfA), _factor, Size);
    }
}
