using System;
using System.Reflection;

namespace Gjk.Targets;

/// <summary>What this thread has allocated. Mono has the exact count, though the reference assemblies of net472 do not
/// name it.</summary>
internal static class AllocatedBytes
{
    private static readonly Func<long> Counter = FindCounter();

    public static long Now() => Counter();

    private static Func<long> FindCounter()
    {
        MethodInfo? exact = typeof(GC).GetMethod("GetAllocatedBytesForCurrentThread");
        return exact is null
            ? () => GC.GetTotalMemory(false)
            : (Func<long>)Delegate.CreateDelegate(typeof(Func<long>), exact);
    }
}
