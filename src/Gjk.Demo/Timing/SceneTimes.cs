using System.Text.Json;

namespace Gjk.Demo.Timing;

/// <summary>The times measured on one scene, in nanoseconds per pair. A time is null if there was nothing to measure.
/// With surfaces or compounds there are no warm starts, no batches and no depths; the moving pairs are asked without
/// starts.</summary>
/// <remarks>The line has the properties in the order in which they stand here.</remarks>
internal sealed class SceneTimes
{
    private static readonly JsonSerializerOptions Format = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower,
    };

    /// <summary>The name of the file, without its ending.</summary>
    public string Scene { get; set; } = "";

    public int Pairs { get; init; }

    public int Overlapping { get; set; }

    /// <summary>The fastest pass through the list, without warm starts.</summary>
    public double? ColdNs { get; set; }

    /// <summary>The median pass, without warm starts.</summary>
    public double? ColdMedianNs { get; set; }

    public double? WarmNs { get; set; }

    public double? MovingNs { get; set; }

    public double? BoolNs { get; set; }

    /// <summary>The mean iterations of the queries without warm starts.</summary>
    public double? Iterations { get; set; }

    public double? BytesPerCall { get; set; }

    /// <summary>The whole list in one call of <see cref="Core.PairBatch"/>, on one thread.</summary>
    public double? BatchNs { get; set; }

    /// <inheritdoc cref="BatchNs"/>
    public double? BatchWarmNs { get; set; }

    /// <inheritdoc cref="BatchNs"/>
    public double? BatchBoolNs { get; set; }

    /// <summary>The signed distance of the pairs that overlap, without warm starts. Null if none does.</summary>
    public double? DepthNs { get; set; }

    /// <summary>The casts of all pairs over one frame, without warm starts. Null if no object has a velocity, and if
    /// one turns, which a cast does not.</summary>
    public double? CastNs { get; set; }

    /// <summary>Writes one line of JSON and flushes it.</summary>
    public void Write(Stream stream)
    {
        JsonSerializer.Serialize(stream, this, Format);
        stream.WriteByte((byte)'\n');
        stream.Flush();
    }
}
