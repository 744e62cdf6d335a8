using System.Threading;

namespace Gjk.Core.Tests.Support;

/// <summary>How much stack a piece of work takes on the thread that does it.</summary>
internal static unsafe class StackUse
{
    private const int Painted = 384 << 10, ThreadStack = 1 << 20, Attempts = 3;

    private const byte Paint = 0xA5;

    /// <summary>The fewest bytes of several runs, since the runtime interrupts a thread on its own stack now and then.
    /// The first run compiles, which takes stack too. A run that takes no more than is allowed is the last.</summary>
    public static int Least(Action work, int allowed = 0)
    {
        int least = int.MaxValue;
        On(ThreadStack, work);
        for (int attempt = 0; attempt < Attempts && least > allowed; attempt++)
        {
            On(ThreadStack, () =>
            {
                byte* lowest = PaintBelow();
                work();
                int clean = 0;
                while (clean < Painted && lowest[clean] == Paint) clean++;
                least = Math.Min(least, Painted - clean);
            });
        }

        return least;
    }

    /// <summary>Does the work on a thread with so many bytes of stack.</summary>
    public static void On(int bytes, Action work)
    {
        var thread = new Thread(() => work(), bytes);
        thread.Start();
        thread.Join();
    }

    /// <summary>Paints the stack that the caller's next call will use; its lowest byte.</summary>
    private static byte* PaintBelow()
    {
        byte* memory = stackalloc byte[Painted];
        new Span<byte>(memory, Painted).Fill(Paint);
        return memory;
    }
}
