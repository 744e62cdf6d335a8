namespace Gjk.Core;

/// <summary>A box with axes of its own.</summary>
internal struct TurnedBox
{
    public Vector3 Center, Half, U, V, W;

    /// <summary>The sum of the half sides: which of two boxes is opened first.</summary>
    public readonly float Size => Half.X + Half.Y + Half.Z;

    /// <summary>Reads a lane of a tree.</summary>
    /// <param name="boxes">The tree's.</param>
    /// <param name="reference">Eight times the node, and the lane.</param>
    /// <param name="factor">A power of two, for the lengths.</param>
    /// <param name="box">The box.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Read(float* boxes, int reference, float factor, out TurnedBox box)
    {
        float* p = boxes + (reference >> 3) * PartTree.Stride + (reference & 7);
        box.Center = new Vector3(p[0] * factor, p[8] * factor, p[16] * factor);
        box.Half = new Vector3(p[24] * factor, p[32] * factor, p[40] * factor);
        box.U = new Vector3(p[48], p[56], p[64]);
        box.V = new Vector3(p[72], p[80], p[88]);
        box.W = new Vector3(p[96], p[104], p[112]);
    }
}
