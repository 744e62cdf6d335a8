using System.Runtime.InteropServices;

namespace Gjk.Demo.View;

/// <summary>The contact points of the pairs that overlap, in the order of the frames and then of the pairs. Pairs that
/// are apart have no entry, and a point no normal of its own: it is that of its pair.</summary>
internal sealed class SceneContacts
{
    /// <summary>Numbers in a point: A's point, then the gap. B's point is A's plus the gap times the normal.</summary>
    public const int PointSize = 4;

    /// <summary>The count of a pair whose points were left out, because the page already holds
    /// <see cref="MostPoints"/>.</summary>
    public const byte LeftOut = byte.MaxValue;

    /// <summary>The most points that a page holds. A page needs 22 bytes for each, so about 22 MB.</summary>
    private const int MostPoints = 1_000_000;

    /// <summary>Points whose gap is at most this share of the smaller shape's radius are shown. So a box that stands on
    /// another and is tilted by half a degree still shows all its corners. A wider gap is one that the eye sees as
    /// open.</summary>
    private const double MostGap = 0.01;

    private readonly List<byte> _counts = [];
    private readonly List<float> _points = [];

    /// <summary>How many points each overlapping pair has, or <see cref="LeftOut"/>.</summary>
    public ReadOnlySpan<byte> Counts => CollectionsMarshal.AsSpan(_counts);

    /// <summary><see cref="PointSize"/> numbers for each point.</summary>
    public ReadOnlySpan<float> Points => CollectionsMarshal.AsSpan(_points);

    /// <summary>The most gap of a pair, in world units.</summary>
    public static float MostGapOf(in ConvexShape a, in ConvexShape b) =>
        (float)(MostGap * Math.Min(a.BoundingRadius, b.BoundingRadius));

    /// <summary>Adds the next overlapping pair.</summary>
    public void Add(in ContactManifold manifold)
    {
        if (_points.Count + manifold.Count * PointSize > MostPoints * PointSize)
        {
            _counts.Add(LeftOut);
            return;
        }

        _counts.Add((byte)manifold.Count);
        for (int i = 0; i < manifold.Count; i++)
        {
            Vector3 onA = manifold[i].PointA;
            _points.AddRange([onA.X, onA.Y, onA.Z, manifold[i].Gap]);
        }
    }
}
