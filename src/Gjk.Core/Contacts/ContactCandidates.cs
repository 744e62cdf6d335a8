using System;

namespace Gjk.Core;

/// <summary>
/// Where two faces or edges lie opposite each other, seen along the normal: the corners of each that lie within the
/// other, and where their outlines cross. These are the corners of the overlap of two convex polygons.
/// </summary>
/// <remarks>
/// Faces clipped against each other are what physics engines make contacts of (Gregorius, "Robust contact creation for
/// physics simulation", GDC 2015; Gottschalk, "Separating axis theorem", 1996, for which features meet). They clip by
/// one side after the other; here all corners and crossings are asked instead, which needs no order, gives each point a
/// name of its own, and for the few corners of a face costs the same.
/// </remarks>
internal unsafe ref struct ContactCandidates
{
    /// <summary>Count: every corner of both faces, and two crossings for each edge of one.</summary>
    public const int Capacity = 4 * FaceCorners.Capacity + 1;

    /// <summary>
    /// Length, as a fraction of the size: a corner that lies beside an edge by less is on it, so that equal faces and
    /// parallel edges meet whatever rounding says, and places that are closer are one. Pinned by ContactTests.
    /// </summary>
    public const double Slack = 4e-7;

    private readonly Candidate* _candidates;
    private readonly double _slack, _mostGap;

    /// <param name="memory">Room for <see cref="Capacity"/> candidates.</param>
    /// <param name="size">Of the pair.</param>
    /// <param name="mostGap">Of the cores, above which there is no contact.</param>
    public ContactCandidates(Candidate* memory, double size, double mostGap)
    {
        _candidates = memory;
        _slack = Slack * size;
        _mostGap = mostGap;
        Count = 0;
    }

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>A candidate.</summary>
    public readonly ref Candidate this[int index] => ref _candidates[index];

    /// <summary>Brings a candidate forward to a place; those between keep their order.</summary>
    public readonly void MoveTo(int from, int place)
    {
        Candidate moved = _candidates[from];
        for (int i = from; i > place; i--) _candidates[i] = _candidates[i - 1];
        _candidates[place] = moved;
    }

    /// <summary>Exchanges two candidates.</summary>
    public readonly void Swap(int i, int k) => (_candidates[i], _candidates[k]) = (_candidates[k], _candidates[i]);

    /// <summary>
    /// Adds a place, unless the gap is too wide; where one is there already, the one with the smaller gap stays.
    /// </summary>
    /// <param name="place">The place, with A's height.</param>
    /// <param name="heightB">B's height there.</param>
    /// <param name="id">The point's name.</param>
    public void Add(in FlatCorner place, double heightB, long id)
    {
        if (!(heightB - place.Height <= _mostGap) || Count == Capacity) return;
        for (int i = 0; i < Count; i++)
        {
            double u = _candidates[i].U - place.U, v = _candidates[i].V - place.V;
            if (!(u * u + v * v <= _slack * _slack)) continue;
            if (heightB - place.Height < _candidates[i].Gap)
                _candidates[i] = new Candidate(place, heightB, _candidates[i].Id);
            return;
        }

        _candidates[Count++] = new Candidate(place, heightB, id);
    }

    /// <summary>Finds all places where the features lie opposite each other.</summary>
    public void Find(ref FlatFeature a, ref FlatFeature b)
    {
        double* insideB = stackalloc double[a.Count * b.Count];
        double* insideA = stackalloc double[a.Count * b.Count];
        for (int i = 0; i < a.Count; i++)
        {
            ref FlatCorner corner = ref a[i];
            if (b.Holds(corner, _slack, insideB + i * b.Count))
                Add(corner, b.HeightAt(corner), ContactFeature.Of(ContactFeature.Corner(corner.Id), 0));
        }

        for (int i = 0; i < b.Count; i++)
        {
            FlatCorner corner = b[i];
            if (!a.Holds(corner, _slack, insideA + i * a.Count)) continue;
            double height = corner.Height;
            corner.Height = a.HeightAt(corner);
            Add(corner, height, ContactFeature.Of(0, ContactFeature.Corner(corner.Id)));
        }

        for (int i = 0; i < a.EdgeCount; i++)
        {
            double* from = insideB + i * b.Count;
            double* to = insideB + (i + 1 < a.Count ? i + 1 : 0) * b.Count;
            for (int j = 0; j < b.EdgeCount; j++)
            {
                // Edges that do not part by more than the slack have their corners on one another.
                if ((from[j] < 0) == (to[j] < 0) || Math.Abs(from[j] - to[j]) <= 2 * _slack) continue;
                int next = j + 1 < b.Count ? j + 1 : 0;
                double begin = insideA[j * a.Count + i], end = insideA[next * a.Count + i];
                if ((begin < 0) == (end < 0)) continue;
                AddCrossing(ref a, i, from[j] / (from[j] - to[j]), ref b, j, begin / (begin - end));
            }
        }
    }

    private void AddCrossing(ref FlatFeature a, int edgeA, double partA, ref FlatFeature b, int edgeB, double partB)
    {
        ref FlatCorner p = ref a[edgeA], q = ref a.After(edgeA), r = ref b[edgeB], s = ref b.After(edgeB);
        var place = new FlatCorner
        {
            U = p.U + (q.U - p.U) * partA,
            V = p.V + (q.V - p.V) * partA,
            Height = p.Height + (q.Height - p.Height) * partA,
        };
        Add(
            place, r.Height + (s.Height - r.Height) * partB,
            ContactFeature.Of(ContactFeature.Edge(p.Id), ContactFeature.Edge(r.Id)));
    }
}

/// <summary>A place where both shapes have a surface.</summary>
internal readonly struct Candidate
{
    /// <summary>In the plane across the normal.</summary>
    public readonly double U, V;

    /// <summary>Along the normal, of each core.</summary>
    public readonly double HeightA, HeightB;

    /// <summary>The point's name.</summary>
    public readonly long Id;

    public Candidate(in FlatCorner place, double heightB, long id)
    {
        U = place.U;
        V = place.V;
        HeightA = place.Height;
        HeightB = heightB;
        Id = id;
    }

    /// <summary>How far apart the cores are here.</summary>
    public double Gap => HeightB - HeightA;
}
