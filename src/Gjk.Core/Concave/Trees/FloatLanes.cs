#if NET
using Floats = System.Runtime.Intrinsics.Vector256<float>;
#endif

namespace Gjk.Core;

#if !NET
/// <summary>One lane, where there is no wide register. Each operation is rounded to float, as in a register.</summary>
internal readonly struct Floats(float value)
{
    public readonly float Value = value;

    // The square of 24 bits fits into 53, so that double and then float rounds as float alone.
    public static Floats operator +(Floats a, Floats b) => new((float)((double)a.Value + b.Value));

    public static Floats operator -(Floats a, Floats b) => new((float)((double)a.Value - b.Value));

    public static Floats operator *(Floats a, Floats b) => new((float)((double)a.Value * b.Value));

    public static Floats operator /(Floats a, Floats b) => new((float)((double)a.Value / b.Value));
}
#endif

/// <summary>The arithmetic that prunes: eight floats at once in .NET, one after another in the netstandard builds.
/// Nothing is fused and every step is rounded to float, so that the lanes are the same bits everywhere.</summary>
internal static unsafe class FloatLanes
{
#if NET
    /// <summary>How many lanes one operation has; a node has eight.</summary>
    public const int Count = 8;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats Load(float* at) => Vector256.Load(at);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Floats lanes, float* at) => lanes.Store(at);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats All(float value) => Vector256.Create(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats Abs(Floats a) => Vector256.Abs(a);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats Max(Floats a, Floats b) => Vector256.ConditionalSelect(Vector256.GreaterThan(a, b), a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats Min(Floats a, Floats b) => Vector256.ConditionalSelect(Vector256.LessThan(a, b), a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats Sqrt(Floats a) => Vector256.Sqrt(a);

    /// <summary>Per lane: a &lt; b ? x : y.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats IfLess(Floats a, Floats b, Floats x, Floats y) =>
        Vector256.ConditionalSelect(Vector256.LessThan(a, b), x, y);
#else
    public const int Count = 1;

    public static Floats Load(float* at) => new(*at);

    public static void Store(Floats lanes, float* at) => *at = lanes.Value;

    public static Floats All(float value) => new(value);

    public static Floats Abs(Floats a) => new(Math.Abs(a.Value));

    public static Floats Max(Floats a, Floats b) => a.Value > b.Value ? a : b;

    public static Floats Min(Floats a, Floats b) => a.Value < b.Value ? a : b;

    public static Floats Sqrt(Floats a) => new((float)Math.Sqrt(a.Value));

    public static Floats IfLess(Floats a, Floats b, Floats x, Floats y) => a.Value < b.Value ? x : y;
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Floats Dot(Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz) =>
        ax * bx + ay * by + az * bz;
}

/// <summary>Three vectors' lanes.</summary>
#if NET
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
internal readonly struct Lanes3(Floats x, Floats y, Floats z)
{
    public readonly Floats X = x, Y = y, Z = z;

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    public static Lanes3 operator -(in Lanes3 a, in Lanes3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    public static Lanes3 operator +(in Lanes3 a, in Lanes3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    public static Floats Dot(in Lanes3 a, in Lanes3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#endif
    public static Lanes3 Cross(in Lanes3 a, in Lanes3 b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}
