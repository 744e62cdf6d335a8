using Gjk.Core;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Replay;

/// <summary>What the replay of a world found: counts and hash, which are those of the first frames, and times, which are those of all.</summary>
internal sealed class WorldReport
{
    private long _calls;
    private long _intersecting;

    public WorldReport(BuiltInScene scene, int hullVertices, WorldSettings settings)
    {
        Name = scene.Name;
        Objects = scene.Poses.Count;
        VerticesPerObject = scene.Vertices.Count;
        HullVertices = hullVertices;
        Settings = settings;
    }

    public string Name { get; }

    public int Objects { get; }

    /// <summary>As given.</summary>
    public int VerticesPerObject { get; }

    /// <summary>After deduplication.</summary>
    public int HullVertices { get; }

    public WorldSettings Settings { get; }

    /// <summary>All pairs: the calls of a frame without a broad phase.</summary>
    public long PairsPerFrame => (long)Objects * (Objects - 1) / 2;

    /// <summary>Of how many frames the counts are the means, and the hash covers the pairs.</summary>
    public int CountedFrames { get; private set; }

    public double CallsPerFrame => (double)_calls / CountedFrames;

    public double CallsSavedPerFrame => ((double)PairsPerFrame * CountedFrames - _calls) / CountedFrames;

    /// <summary>The mean number.</summary>
    public double IntersectingPairs => (double)_intersecting / CountedFrames;

    /// <summary>Those of the first frame.</summary>
    public ObjectPair[] FirstPairs { get; private set; } = [];

    public string Hash { get; set; } = "";

    public int Frames { get; set; }

    /// <summary>Moving the objects and finding candidates; the median.</summary>
    public double BroadMs { get; set; }

    /// <summary>Asking which candidates intersect; the median.</summary>
    public double NarrowMs { get; set; }

    public double MedianMs { get; set; }

    /// <summary>The 99th percentile.</summary>
    public double P99Ms { get; set; }

    public double BytesPerFrame { get; set; }

    /// <summary>Takes the counts of the frame that was just run.</summary>
    public void Count(World world)
    {
        if (CountedFrames++ == 0) FirstPairs = world.IntersectingPairs.ToArray();
        _calls += world.Calls;
        _intersecting += world.IntersectingPairs.Length;
    }
}
