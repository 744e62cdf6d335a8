using System;
using System.Runtime.InteropServices;

namespace Gjk.Targets;

/// <summary>Runs code on a thread that Mono did not make and whose x87 unit, which computes Mono's
/// <see cref="Math.Sqrt"/>, rounds to 64 bits instead of 53.</summary>
internal static class NativeThread
{
    private const int PrecisionBits = 0x300, Double = 0x200, Extended = 0x300;

    private delegate void Callback();

    /// <param name="first">Runs when Mono meets the thread, for which it sets the precision to 53 bits.</param>
    /// <param name="second">Runs after native code has set it to 64 bits once more.</param>
    /// <exception cref="InvalidOperationException">The precision is another one, or an action failed.</exception>
    public static void Run(Action first, Action second)
    {
        Exception? problem = null;
        Callback one = () => Try(first, Double, ref problem), two = () => Try(second, Extended, ref problem);
        if (run_on_native_thread(one, two) != 0) throw new InvalidOperationException("There is no thread.");
        GC.KeepAlive(one);
        GC.KeepAlive(two);
        if (problem is not null) throw new InvalidOperationException("On the native thread.", problem);
    }

    /// <summary>An exception must not pass through the frames of C.</summary>
    private static void Try(Action action, int precision, ref Exception? problem)
    {
        try
        {
            int word = control_word();
            if ((word & PrecisionBits) != precision)
                throw new InvalidOperationException($"The x87 control word is {word:X}.");
            action();
        }
        catch (Exception e)
        {
            problem = e;
        }
    }

    [DllImport("native_thread")]
    private static extern int run_on_native_thread(Callback first, Callback second);

    [DllImport("native_thread")]
    private static extern ushort control_word();
}
