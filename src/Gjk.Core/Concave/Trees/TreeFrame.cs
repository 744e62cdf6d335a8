namespace Gjk.Core;

/// <summary>The pose of tree B relative to tree A, in pair units. The pair unit is the power of two below the largest
/// of both radii, the reach (the margins around both trees) and the distance of the trees' origins, so that all lengths
/// are a few units at most.</summary>
internal struct TreeFrame
{
    /// <summary>Ratio to the radii and the distance of the origins: 2^-18, 64 units of u = 2^-24, the most that
    /// rounding to float changes a bound of <see cref="BoxLanes"/>; its header counts. Pinned by
    /// BoxLanesTests.</summary>
    public const float Slack = 1f / (1 << 18);

    /// <summary>Ratio to the positions: 2^-45, more than double rounds away where trees lie far from poses.</summary>
    private const double FarSlack = 1.0 / (1L << 45);

    /// <summary>B's axes in A's frame.</summary>
    public RotationD Rotation;

    /// <summary>A's axes in the world.</summary>
    public RotationD RotationA;

    /// <summary>From A's tree's origin to B's, in A's frame and pair units.</summary>
    public Double3 Translation;

    /// <summary>World units per pair unit.</summary>
    public double Unit;

    /// <summary>Pair units per tree unit.</summary>
    public float FactorA, FactorB;

    /// <summary>In pair units: the trees' radii.</summary>
    public double RadiusA, RadiusB;

    /// <summary>In pair units: each bound of a length is lowered by this.</summary>
    public float Room;

    /// <summary>The share of <see cref="Room"/> for rounding in double, where the trees lie far from their
    /// frames.</summary>
    public float FarRoom;

    /// <summary>In pair units: a lower bound of the squared distance, that of the balls around the trees.</summary>
    public readonly double LeastDistanceSquared
    {
        get
        {
            double gap = Math.Max(Translation.Length - RadiusA - RadiusB - Room, 0);
            return gap * gap;
        }
    }

    public static void Compose(
        PartTree a, in RigidPose poseA, PartTree b, in RigidPose poseB, double reach, out TreeFrame frame)
    {
        frame = default;
        PoseComposition.Compose(poseA, poseB, null, null, out frame.RotationA, out frame.Rotation, out _, out _);
        Double3 between = (Double3)poseB.Position - poseA.Position;
        Double3 originB = frame.Rotation.Rotate(b.Origin);
        Double3 translation = frame.RotationA.InverseRotate(between) + (originB - a.Origin);
        double far = between.SumOfMagnitudes + a.Origin.SumOfMagnitudes + b.Origin.SumOfMagnitudes;
        frame.Unit = PartTree.UnitOf(
            Math.Max(Math.Max(a.Radius, b.Radius), Math.Max(translation.SumOfMagnitudes, reach)));
        double inverse = 1 / frame.Unit;
        frame.Translation = translation * inverse;
        frame.FactorA = (float)(a.Unit * inverse);
        frame.FactorB = (float)(b.Unit * inverse);
        frame.RadiusA = a.Radius * inverse;
        frame.RadiusB = b.Radius * inverse;
        frame.FarRoom = (float)(FarSlack * far * inverse) + float.Epsilon;
        frame.Room = (float)(Slack * (frame.RadiusA + frame.RadiusB + frame.Translation.Length)) + frame.FarRoom;
    }

    /// <summary>Chooses which of two boxes is opened: the larger one, or the one that is no leaf.</summary>
    /// <param name="boxesA">A's tree's boxes.</param>
    /// <param name="a">A's box.</param>
    /// <param name="childA">The node below it; negative in a leaf.</param>
    /// <param name="boxesB">B's tree's.</param>
    /// <param name="b">B's box.</param>
    /// <param name="childB">The node below it.</param>
    /// <param name="node">The boxes below the one that is opened.</param>
    /// <param name="factor">Pair units per unit of theirs.</param>
    /// <param name="other">The other box as they see it.</param>
    /// <returns>Whether A's is opened.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly unsafe bool ChooseOpened(
        float* boxesA, int a, int childA, float* boxesB, int b, int childB, out float* node, out float factor,
        out TurnedBox other)
    {
        TurnedBox.Read(boxesA, a, FactorA, out TurnedBox boxA);
        TurnedBox.Read(boxesB, b, FactorB, out TurnedBox boxB);
        bool isA = childB < 0 || (childA >= 0 && boxA.Size >= boxB.Size);
        if (isA) SeenFromA(boxB, out other);
        else SeenFromB(boxA, out other);
        node = isA ? boxesA + childA * PartTree.Stride : boxesB + childB * PartTree.Stride;
        factor = isA ? FactorA : FactorB;
        return isA;
    }

    /// <summary>A box of A's tree in pair units, as B's tree sees it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void SeenFromB(in TurnedBox box, out TurnedBox seen)
    {
        seen.Center = Narrow(Rotation.InverseRotate((Double3)box.Center - Translation));
        seen.Half = box.Half;
        seen.U = Narrow(Rotation.InverseRotate(box.U));
        seen.V = Narrow(Rotation.InverseRotate(box.V));
        seen.W = Narrow(Rotation.InverseRotate(box.W));
    }

    /// <summary>A point of A's tree in pair units, as B's tree sees it.</summary>
    public readonly Double3 PlacedInB(in Double3 point) => Rotation.InverseRotate(point - Translation);

    /// <summary>A box of B's tree in pair units, as A's tree sees it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void SeenFromA(in TurnedBox box, out TurnedBox seen)
    {
        seen.Center = Narrow(Rotation.Rotate(box.Center) + Translation);
        seen.Half = box.Half;
        seen.U = Narrow(Rotation.Rotate(box.U));
        seen.V = Narrow(Rotation.Rotate(box.V));
        seen.W = Narrow(Rotation.Rotate(box.W));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3 Narrow(in Double3 v) => new((float)v.X, (float)v.Y, (float)v.Z);
}
