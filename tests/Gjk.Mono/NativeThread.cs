using System;
using System.Runtime.InteropServices;

namespace Gjk.Targets;

/// <summary>Runs code on a thread that Mono did not make, with the x87 unit in extended precision, as it is on a thread
/// that native code of Linux starts. Mono computes <see cref="Math.Sqrt"/> there, and rounds it twice.</summary>
internal static class NativeThread
{
    private const ushort PrecisionBits = 0x300, Extended = 0x300;

    private delegate void Callback();

    /// <exception cref="InvalidOperationException">The thread has another precision.</exception>
    public static void Run(Action action)
    {
        Exception? problem = null;
        Callback callback = () =>
        {
            // An exception must not pass through the frames of C.
            try
            {
                ushort word = control_word();
                if ((word & PrecisionBits) != Extended)
                    throw new InvalidOperationException($"The x87 control word is {word:X}.");
                action();
            }
            catch (Exception e)
            {
                problem = e;
            }
        };
        if (run_on_native_thread(callback) != 0) throw new InvalidOperationException("There is no thread.");
        GC.KeepAlive(callback);
        if (problem is not null) throw new InvalidOperationException("On the native thread.", problem);
    }

    [DllImport("native_thread")]
    private static extern int run_on_native_thread(Callback call);

    [DllImport("native_thread")]
    private static extern ushort control_word();
}
