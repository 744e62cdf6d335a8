using System.IO;
using System.Text.Json;

namespace Gjk.Demo.Timing;

/// <summary>
/// The times measured on one scene, in nanoseconds per pair. A time is null if there was nothing to measure.
/// </summary>
internal sealed class SceneTimes
{
    public int Pairs { get; init; }

    public int Overlapping { get; set; }

    /// <summary>The fastest pass through the list, without warm starts.</summary>
    public double? ColdNs { get; set; }

    /// <summary>The median pass, without warm starts.</summary>
    public double? ColdMedianNs { get; set; }

    public double? WarmNs { get; set; }

    public double? MovingNs { get; set; }

    public double? BooleanNs { get; set; }

    /// <summary>The mean iterations of the queries without warm starts.</summary>
    public double? Iterations { get; set; }

    public double? BytesPerCall { get; set; }

    /// <summary>The whole list in one call of <see cref="Core.PairBatch"/>, on one thread.</summary>
    public double? BatchNs { get; set; }

    /// <inheritdoc cref="BatchNs"/>
    public double? BatchWarmNs { get; set; }

    /// <inheritdoc cref="BatchNs"/>
    public double? BatchBooleanNs { get; set; }

    /// <summary>The signed distance of the pairs that overlap, without warm starts. Null if none does.</summary>
    public double? DepthNs { get; set; }

    /// <summary>
    /// The casts of all pairs over one frame, without warm starts. Null if no object has a velocity, and if one turns,
    /// which a cast does not.
    /// </summary>
    public double? CastNs { get; set; }

    /// <summary>Writes one line of JSON and flushes it.</summary>
    public void Write(Stream stream, string scene)
    {
        using (var json = new Utf8JsonWriter(stream))
        {
            json.WriteStartObject();
            json.WriteString("scene", scene);
            json.WriteNumber("pairs", Pairs);
            json.WriteNumber("overlapping", Overlapping);
            Write(json, "cold_ns", ColdNs);
            Write(json, "cold_median_ns", ColdMedianNs);
            Write(json, "warm_ns", WarmNs);
            Write(json, "moving_ns", MovingNs);
            Write(json, "bool_ns", BooleanNs);
            Write(json, "iterations", Iterations);
            Write(json, "bytes_per_call", BytesPerCall);
            Write(json, "batch_ns", BatchNs);
            Write(json, "batch_warm_ns", BatchWarmNs);
            Write(json, "batch_bool_ns", BatchBooleanNs);
            Write(json, "depth_ns", DepthNs);
            Write(json, "cast_ns", CastNs);
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
        stream.Flush();
    }

    private static void Write(Utf8JsonWriter json, string name, double? value)
    {
        if (value is null) json.WriteNull(name);
        else json.WriteNumber(name, value.Value);
    }
}
