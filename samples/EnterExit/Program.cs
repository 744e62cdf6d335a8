using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using Gjk.Core;

namespace EnterExit;

/// <summary>Says which of some moving objects meet and part, and measures that this allocates nothing.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        int frames = Carousel.RoundFrames;
        bool isGood = args.Length == 0
            || (args.Length == 1 && int.TryParse(args[0], CultureInfo.InvariantCulture, out frames) && frames > 0);
        if (!isGood)
        {
            Console.Error.WriteLine("usage: EnterExit [FRAMES], a whole number, at least 1");
            return 2;
        }

        var scene = new CollisionScene();
        var carousel = new Carousel(scene);
        var events = new OverlapEvents(scene);
        var log = new List<(string Verb, ObjectPair Pair)>();
        events.Entered += pair => log.Add(("enter", pair));
        events.Exited += pair => log.Add(("exit", pair));

        // The first round is the warm-up: every buffer gets the size that it needs in any round.
        int enters = 0, exits = 0;
        long mostBytes = 0;
        TimeSpan time = TimeSpan.Zero;
        for (int frame = -Carousel.RoundFrames; frame < frames; frame++)
        {
            long bytes = GC.GetAllocatedBytesForCurrentThread(), start = Stopwatch.GetTimestamp();
            log.Clear();
            carousel.MoveTo(frame);
            events.Update();
            TimeSpan elapsed = Stopwatch.GetElapsedTime(start);
            bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
            if (frame < 0) continue;

            mostBytes = Math.Max(mostBytes, bytes);
            time += elapsed;
            foreach ((string verb, ObjectPair pair) in log)
            {
                if (verb == "enter") enters++;
                else exits++;
                Console.WriteLine(
                    $"frame {frame,4}  {verb,-5}  {Carousel.NameOf(pair.A)}, {Carousel.NameOf(pair.B)}");
            }
        }

        Console.WriteLine(
            $"{frames} frames, {enters} enters, {exits} exits, {time.TotalMicroseconds / frames:F1} us per frame, "
            + $"at most {mostBytes} bytes allocated in a frame");
        return mostBytes == 0 ? 0 : 1;
    }
}
