using System.Diagnostics;
using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>Shows bars on a terminal, and nothing elsewhere. It draws between frames, on the measuring thread, so that
/// it does not disturb the measured times.</summary>
internal sealed class ProgressBar
{
    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(0.1);

    private readonly ProgressContext? _context;
    private long _lastDrawn;

    private ProgressBar(ProgressContext? context) => _context = context;

    /// <summary>Shows bars on standard error while the work runs, and removes them at the end. Standard output stays
    /// for the results.</summary>
    public static void Show(Action<ProgressBar> work)
    {
        if (OutputConsole.ForProgress() is not { } console) work(new ProgressBar(null));
        else console.Progress().AutoRefresh(false).AutoClear(true).Start(context => work(new ProgressBar(context)));
    }

    /// <summary>Adds a bar. The returned action takes the completed share, from 0 to 1.</summary>
    public Action<double> Add(string title)
    {
        if (_context is null) return _ => { };
        ProgressTask task = _context.AddTask(Markup.Escape(PlainText.Of(title)), maxValue: 1);
        _context.Refresh();
        return done =>
        {
            task.Value = done;
            if (done < 1 && Stopwatch.GetElapsedTime(_lastDrawn) < Interval) return;
            _lastDrawn = Stopwatch.GetTimestamp();
            _context.Refresh();
        };
    }
}
