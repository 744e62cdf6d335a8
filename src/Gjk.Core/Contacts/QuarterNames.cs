namespace Gjk.Core;

/// <summary>The names of the four points that stay of a round outline. They are those of the corners that begin the
/// quarters of the round face, or of both faces where both are round. Rounding alone decides which corners of such an
/// outline span the largest area, so a point stands for a quarter of the rim, wherever in it the shapes
/// touch.</summary>
internal static unsafe class QuarterNames
{
    /// <summary>Count: a face with this many corners is round; a disc is shown by as many. Pinned by
    /// NameTests.</summary>
    private const int Round = FaceCorners.Capacity / FaceCorners.DiscStep;

    /// <summary>Ratio: how far beyond its corner, towards the next one, a quarter begins. Points that lie half way
    /// between two corners, as the shapes' symmetry has it, then belong to the first of them, and not to either by
    /// rounding. Four times more or less is as good.</summary>
    private const double Beyond = 0.35;

    /// <summary>Finds the beginnings of the quarters.</summary>
    /// <param name="a">What A shows.</param>
    /// <param name="b">What B shows.</param>
    /// <param name="quarters">Gets four places, in order around the face, with their names.</param>
    /// <returns>False where neither face is round.</returns>
    public static bool TryFind(ref FlatFeature a, ref FlatFeature b, Candidate* quarters)
    {
        bool ofA = a.Count >= Round, ofB = b.Count >= Round;
        if (ofA) Find(ref a, true, quarters);
        else if (ofB) Find(ref b, false, quarters);
        if (!ofA || !ofB) return ofA || ofB;
        Candidate* others = stackalloc Candidate[ContactManifold.Capacity];
        Find(ref b, false, others);
        Match(others, quarters, out int turn, out int step);
        for (int i = 0; i < ContactManifold.Capacity; i++)
        {
            ref Candidate p = ref quarters[i], q = ref others[At(i, turn, step)];
            quarters[i] = new Candidate((p.U + q.U) / 2, (p.V + q.V) / 2, 0, 0, p.Id | q.Id);
        }

        return true;
    }

    /// <summary>Finds which of four places belongs to which of four others, as both run around.</summary>
    /// <param name="places">Places.</param>
    /// <param name="others">The first of these belongs to the place at the turn.</param>
    /// <param name="turn">Where to begin.</param>
    /// <param name="step">1, or 3 where the two run in opposite directions.</param>
    public static void Match(Candidate* places, Candidate* others, out int turn, out int step)
    {
        step = Area(places) < 0 == Area(others) < 0 ? 1 : 3;
        turn = 0;
        double least = double.PositiveInfinity;
        for (int t = 0; t < ContactManifold.Capacity; t++)
        {
            double sum = 0;
            for (int i = 0; i < ContactManifold.Capacity; i++) sum += places[At(i, t, step)].SquaredTo(others[i]);
            if (!(sum < least)) continue;
            least = sum;
            turn = t;
        }
    }

    /// <summary>The place that belongs to one of the others.</summary>
    public static int At(int index, int turn, int step) => (turn + index * step) % ContactManifold.Capacity;

    private static void Find(ref FlatFeature feature, bool isOfA, Candidate* quarters)
    {
        for (int i = 0; i < ContactManifold.Capacity; i++)
        {
            int first = i * feature.Count / ContactManifold.Capacity;
            ref FlatCorner corner = ref feature[first], next = ref feature.After(first);
            uint name = ContactFeature.Corner(corner.Id);
            long id = isOfA
                ? ContactFeature.Of(name, ContactFeature.None)
                : ContactFeature.Of(ContactFeature.None, name);
            double u = corner.U + (next.U - corner.U) * Beyond, v = corner.V + (next.V - corner.V) * Beyond;
            quarters[i] = new Candidate(u, v, 0, 0, id);
        }
    }

    private static double Area(Candidate* four) =>
        Candidate.Area(four[0], four[1], four[2]) + Candidate.Area(four[0], four[2], four[3]);
}
