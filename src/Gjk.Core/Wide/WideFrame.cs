#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>Composes the frames of four pairs, as <see cref="PairFrame"/> and <see cref="PoseComposition"/> do
/// one.</summary>
internal static unsafe class WideFrame
{
    /// <summary>Reads the poses and the shapes' sizes, composes the frames, and sets the walks to their beginning. A
    /// lane that only the scalar query can solve is not live.</summary>
    /// <param name="batch">The pairs' shapes and poses.</param>
    /// <param name="index">Four indices of pairs; unused lanes repeat the first.</param>
    /// <param name="reach">The first term of <see cref="GjkDistance.CoreReach"/>: <see
    /// cref="GjkDistance.ShapeReach"/>.</param>
    /// <param name="s">The four pairs.</param>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Begin(in WideBatch batch, int* index, double reach, ref WidePairs s)
    {
        ref RigidPose a0 = ref batch.PoseA(index[0]), a1 = ref batch.PoseA(index[1]);
        ref RigidPose a2 = ref batch.PoseA(index[2]), a3 = ref batch.PoseA(index[3]);
        ref RigidPose b0 = ref batch.PoseB(index[0]), b1 = ref batch.PoseB(index[1]);
        ref RigidPose b2 = ref batch.PoseB(index[2]), b3 = ref batch.PoseB(index[3]);
        Read(a0, a1, a2, a3, out Lanes ax, out Lanes ay, out Lanes az, out Lanes aw, out s.PositionA);
        Read(b0, b1, b2, b3, out Lanes bx, out Lanes by, out Lanes bz, out Lanes bw, out WideVector positionB);
        Lanes normA = ax * ax + ay * ay + az * az + aw * aw, normB = bx * bx + by * by + bz * bz + bw * bw;
        Lanes one = Lanes.One / (normA * normB), two = Vector256.Create(2.0);
        s.ArePlaced = batch.ArePlaced(index);
        if (s.ArePlaced != Lanes.Zero)
        {
            batch.CoreRotationsOfA(index).MultiplyInto(s.ArePlaced, ref ax, ref ay, ref az, ref aw);
            batch.CoreRotationsOfB(index).MultiplyInto(s.ArePlaced, ref bx, ref by, ref bz, ref bw);
        }

        s.RotationA.Set(ax, ay, az, aw, two * normB * one);
        s.Rotation.Set(
            aw * bx - ax * bw - ay * bz + az * by,
            aw * by - ay * bw - az * bx + ax * bz,
            aw * bz - az * bw - ax * by + ay * bx,
            aw * bw + ax * bx + ay * by + az * bz,
            two * one);
        batch.ReadSizes(index, ref s);
        Lanes offset = s.CenterA.SumOfMagnitudes + s.CenterB.SumOfMagnitudes, radius = s.RadiusA + s.RadiusB;
        WideVector translation = s.RotationA.InverseRotate(positionB - s.PositionA);
        Lanes atOrigin = Vector256.Equals(offset, Lanes.Zero);
        s.Translation = WideVector.Select(
            atOrigin, translation, translation + (s.Rotation.Rotate(s.CenterB) - s.CenterA));
        Lanes margins = s.MarginA + s.MarginB;
        Lanes magnitude = radius + margins + s.Translation.SumOfMagnitudes;
        s.Live = IsUnit(normA) & IsUnit(normB) & PairFrame.AreOrdinary(magnitude)
            & Vector256.GreaterThanOrEqual(s.MarginA, Lanes.Zero) & Vector256.GreaterThanOrEqual(s.MarginB, Lanes.Zero)
            & ~Vector256.Equals(radius, margins)
            & ~Vector256.GreaterThan(offset, Vector256.Create(PairFrame.FarCenter) * radius);
        SetTolerances(reach, radius, margins, ref s);
    }

    /// <summary>Points of the second shapes in the world, by their own poses: as <see
    /// cref="DistanceFinish.ToWorld"/>.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static WideVector PlaceB(in WideBatch batch, int* index, in WideVector local)
    {
        Read(
            batch.PoseB(index[0]), batch.PoseB(index[1]), batch.PoseB(index[2]), batch.PoseB(index[3]), out Lanes x,
            out Lanes y, out Lanes z, out Lanes w, out WideVector position);
        WideRotation rotation = default;
        rotation.Set(x, y, z, w, Vector256.Create(2.0) / (x * x + y * y + z * z + w * w));
        return rotation.Rotate(local) + position;
    }

    private static void SetTolerances(double reach, Lanes radius, Lanes margins, ref WidePairs s)
    {
        Lanes touch = Vector256.Create(GjkTolerances.Touch) * radius;
        Lanes noise = Vector256.Create(GjkTolerances.Noise) * radius;
        Lanes level = Vector256.Create(GjkTolerances.Level) * radius;
        Lanes far = Vector256.Create(reach) + margins + Vector256.Create(GjkTolerances.SeparatedBandCurved) * radius;
        s.TouchSquared = touch * touch;
        s.NoiseSquared = noise * noise;
        s.LevelSquared = level * level;
        s.ReachSquared = far * far;
        WideVector normal = -s.Translation;
        Lanes squared = normal.LengthSquared;
        s.Normal = WideVector.Select(
            Vector256.GreaterThan(squared, Lanes.Zero), normal, new WideVector(Lanes.One, Lanes.Zero, Lanes.Zero));
        s.NormalSquared = s.Normal.LengthSquared;
        s.Count = s.Iterations = s.Separated = s.Closed = s.Beyond = s.Inside = s.Plane = Lanes.Zero;
        s.Winding = Lanes.One;
        s.DistanceSquared = Vector256.Create(double.PositiveInfinity);
        s.SlotsA = s.SlotsB = s.SlotsC = s.SlotsW = Vector256<long>.Zero;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Lanes IsUnit(Lanes squared) =>
        Vector256.GreaterThanOrEqual(squared, Vector256.Create(RigidPose.MinSquaredNorm))
            & Vector256.LessThanOrEqual(squared, Vector256.Create(RigidPose.MaxSquaredNorm));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Read(
        in RigidPose a, in RigidPose b, in RigidPose c, in RigidPose d, out Lanes x, out Lanes y, out Lanes z,
        out Lanes w, out WideVector position)
    {
        Transpose(
            Vector128.LoadUnsafe(in a.Rotation.X), Vector128.LoadUnsafe(in b.Rotation.X),
            Vector128.LoadUnsafe(in c.Rotation.X), Vector128.LoadUnsafe(in d.Rotation.X), out x, out y, out z, out w);

        // The positions lie behind w, which is read again so as not to read behind the last pose.
        Transpose(
            Vector128.LoadUnsafe(in a.Rotation.W), Vector128.LoadUnsafe(in b.Rotation.W),
            Vector128.LoadUnsafe(in c.Rotation.W), Vector128.LoadUnsafe(in d.Rotation.W), out _, out Lanes px,
            out Lanes py, out Lanes pz);
        position = new WideVector(px, py, pz);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Transpose(
        Vector128<float> a, Vector128<float> b, Vector128<float> c, Vector128<float> d, out Lanes x, out Lanes y,
        out Lanes z, out Lanes w)
    {
        Vector128<float> lowAB = Sse.UnpackLow(a, b), lowCD = Sse.UnpackLow(c, d);
        Vector128<float> highAB = Sse.UnpackHigh(a, b), highCD = Sse.UnpackHigh(c, d);
        x = Avx.ConvertToVector256Double(Sse.MoveLowToHigh(lowAB, lowCD));
        y = Avx.ConvertToVector256Double(Sse.MoveHighToLow(lowCD, lowAB));
        z = Avx.ConvertToVector256Double(Sse.MoveLowToHigh(highAB, highCD));
        w = Avx.ConvertToVector256Double(Sse.MoveHighToLow(highCD, highAB));
    }
}
#endif
