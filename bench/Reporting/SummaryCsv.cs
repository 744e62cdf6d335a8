using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;

namespace Gjk.Bench.Reporting;

/// <summary>The figures of a whole run as one small table, which can be kept beside the code.</summary>
public static class SummaryCsv
{
    public const string Header = "benchmark,set,mean_ns,stddev_ns,ratio,allocated_bytes";

    /// <summary>
    /// The text has one row per benchmark that gave a figure. The ratio is its mean divided by the mean of its group's
    /// baseline.
    /// </summary>
    public static string Format(IEnumerable<Summary> summaries, string comment)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(comment).Append('\n').Append(Header).Append('\n');
        foreach (Summary summary in summaries)
        {
            foreach (BenchmarkReport report in summary.Reports.Where(r => r.ResultStatistics is not null))
                AppendRow(text, summary, report);
        }

        return text.ToString();
    }

    /// <summary>
    /// Writes a file beside the target first, so that a run that ends early leaves the old file complete.
    /// </summary>
    public static void Write(string path, string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        string temporary = path + ".tmp";
        File.WriteAllText(temporary, text);
        File.Move(temporary, path, overwrite: true);
    }

    private static void AppendRow(StringBuilder text, Summary summary, BenchmarkReport report)
    {
        BenchmarkCase benchmark = report.BenchmarkCase;
        double mean = report.ResultStatistics!.Mean;
        double? baseline = BaselineMean(summary, benchmark);
        string[] cells =
        [
            $"{benchmark.Descriptor.Type.Name}.{benchmark.Descriptor.WorkloadMethod.Name}",
            SetOf(benchmark),
            Number(mean, "0.###"),
            Number(report.ResultStatistics.StandardDeviation, "0.###"),
            baseline is double b ? Number(mean / b, "0.####") : "",
            report.GcStats.GetBytesAllocatedPerOperation(benchmark)?.ToString(CultureInfo.InvariantCulture) ?? "",
        ];
        text.AppendJoin(',', cells).Append('\n');
    }

    private static double? BaselineMean(Summary summary, BenchmarkCase benchmark)
    {
        string? group = summary.GetLogicalGroupKey(benchmark);
        BenchmarkCase? baseline = summary.BenchmarksCases.FirstOrDefault(c =>
            summary.IsBaseline(c) && summary.GetLogicalGroupKey(c) == group);
        return baseline is null ? null : summary[baseline]?.ResultStatistics?.Mean;
    }

    /// <summary>The parameters of a benchmark. If it has none, its category.</summary>
    private static string SetOf(BenchmarkCase benchmark) => benchmark.HasParameters
        ? string.Join(
            ' ', benchmark.Parameters.Items.Select(p => Convert.ToString(p.Value, CultureInfo.InvariantCulture)))
        : string.Join(' ', benchmark.Descriptor.Categories);

    private static string Number(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
