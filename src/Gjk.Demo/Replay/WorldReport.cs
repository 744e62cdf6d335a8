namespace Gjk.Demo.Replay;

/// <summary>The result of replaying a world. Counts and hash are those of the first frames, times are those of all
/// frames.</summary>
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

    /// <summary>Vertices in the mesh as given.</summary>
    public int VerticesPerObject { get; }

    /// <summary>Vertices after deduplication.</summary>
    public int HullVertices { get; }

    public WorldSettings Settings { get; }

    /// <summary>The number of all pairs. A frame without a broad phase makes this many calls.</summary>
    public long PairsPerFrame => (long)Objects * (Objects - 1) / 2;

    /// <summary>How many frames the counts are averaged over. The hash covers the pairs of the same frames.</summary>
    public int CountedFrames { get; private set; }

    public double CallsPerFrame => (double)_calls / CountedFrames;

    public double CallsSavedPerFrame => ((double)PairsPerFrame * CountedFrames - _calls) / CountedFrames;

    /// <summary>The mean number per frame.</summary>
    public double IntersectingPairs => (double)_intersecting / CountedFrames;

    /// <summary>The pairs of the first frame.</summary>
    public ObjectPair[] FirstPairs { get; private set; } = [];

    public string Hash { get; set; } = "";

    public int Frames { get; set; }

    /// <summary>The median time to move the objects and to find candidates.</summary>
    public double BroadMs { get; set; }

    /// <summary>The median time to test which candidates intersect.</summary>
    public double NarrowMs { get; set; }

    public double MedianMs { get; set; }

    /// <summary>The 99th percentile of the frame times.</summary>
    public double P99Ms { get; set; }

    public double BytesPerFrame { get; set; }

    /// <summary>Adds the counts of the frame that was just run.</summary>
    public void Count(World world)
    {
        if (CountedFrames++ == 0) FirstPairs = world.IntersectingPairs.ToArray();
        _calls += world.Calls;
        _intersecting += world.IntersectingPairs.Length;
    }
}
