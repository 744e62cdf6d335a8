using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>The same question again, or in other words, has the same answer.</summary>
internal static class SameConcave
{
    /// <summary>With a scratch that other queries have used, and shapes that were built again.</summary>
    public static string? Again(ConcavePair pair)
    {
        ConcaveQuery.Distance(pair.B, pair.PoseB, pair.B, pair.PoseA, pair.Scratch);
        PairDistance again = ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, pair.Scratch);
        AnyShape built = pair.RawB.Build();
        PairDistance anew = ConcaveQuery.Distance(pair.A, pair.PoseA, built, pair.PoseB, pair.Scratch);
        return Problem(pair, again, "asked again") ?? Problem(pair, anew, "built anew");
    }

    public static string? Warm(ConcavePair pair)
    {
        PairDistance r = pair.Answer;
        PartWarmStart warm = default;
        Rng random = pair.Random(4);
        Vector3 shift = pair.Motion.B * random.Float(-0.1, 0.1);
        var before = new RigidPose(Rotations.Nudged(random, pair.PoseB.Rotation), pair.PoseB.Position + shift);
        ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, before, ref warm, pair.Scratch);
        for (int i = 0; i < 2; i++)
        {
            PairDistance found = ConcaveQuery.Distance(
                pair.A, pair.PoseA, pair.B, pair.PoseB, ref warm, pair.Scratch);
            // Of curved parts the first one asked decides which of two, whose bands overlap, is the nearer.
            double band = Math.Max(pair.CurvedBandOf(r), pair.CurvedBandOf(found));
            bool IsSame(float distance) => distance == r.Distance || Math.Abs(distance - r.Distance) < band;
            if (found.Status != r.Status || !IsSame(found.Distance) || found.Result.LowerBound > r.Distance + band)
                return Say.Line($"warm {found}, bound {found.Result.LowerBound:R}, cold {r}");
            int index = pair.IndexOf(found.PartA, found.PartB);
            if (!pair.HoldsPiece && (index < 0 || !IsSame(pair.All[index].Distance)))
                return Say.Line($"warm {found} names parts that are further apart");
        }

        return null;
    }

    public static string? Swapped(ConcavePair pair)
    {
        PairDistance r = pair.Answer;
        PairDistance s = ConcaveQuery.Distance(pair.B, pair.PoseB, pair.A, pair.PoseA, pair.Scratch);
        int index = pair.IndexOf(r.PartA, r.PartB);
        double scale = index < 0 ? 0 : pair.ScaleOf(index / pair.PartsB.Length, index % pair.PartsB.Length);
        double band = 2 * Accuracy.CurvedBand(r.Distance, scale) + Accuracy.LeastFloat;
        return Math.Abs((double)r.Distance - s.Distance) <= band ? null : Say.Line($"{r}, exchanged {s}");
    }

    /// <summary>A mesh whose vertices were elsewhere, or a compound of a compound that was, and a tree that was made
    /// for those.</summary>
    public static string? Refit(ConcavePair pair)
    {
        if (pair.RawA.IsConvex || pair.RawA.IsSolid) return null;
        Rng random = pair.Random(5);
        if (pair.RawA.Triangles is not { } triangles) return Moved(pair, AnyShape.Of(Regrouped(random, pair.RawA)));
        float size = random.Float(0, 0.5);
        TriangleSoup elsewhere = triangles.Moved(p => p + size * (p - triangles.Points[0]) * random.Float(-1, 1));
        foreach (Vector3 p in elsewhere.Points)
            if (!float.IsFinite(p.LengthSquared())) return null;
        TriangleMesh mesh = elsewhere.Build().WithVertices(triangles.Points);
        if (pair.RawA.Scale != Vector3.One) mesh = mesh.Scaled(pair.RawA.Scale);
        return Moved(pair, AnyShape.Surface(mesh));
    }

    private static CompoundShape Regrouped(Rng random, RawShape shape)
    {
        CompoundPart[] parts = [.. shape.Parts.Select(p => new CompoundPart(p.Build(), p.Pose))];
        int grouped = 1 + random.Below(parts.Length);
        var elsewhere = new RigidPose(Rotations.Any(random), random.Vector(1));
        var group = new CompoundPart(AnyShape.Of(new CompoundShape(parts[..grouped])), elsewhere);
        var nested = new CompoundShape([group, .. parts[grouped..]]);
        if (shape.Scale != Vector3.One) nested = nested.Scaled(shape.Scale);
        return nested.WithPose(0, RigidPose.Identity);
    }

    private static string? Moved(ConcavePair pair, in AnyShape moved)
    {
        PairDistance found = ConcaveQuery.Distance(moved, pair.PoseA, pair.B, pair.PoseB, pair.Scratch);
        return found.Distance == pair.Answer.Distance ? null : Say.Line($"moved: {found}, new: {pair.Answer}");
    }

    private static string? Problem(ConcavePair pair, in PairDistance other, string name) =>
        other.PartA == pair.Answer.PartA && other.PartB == pair.Answer.PartB
            ? Same.BitProblem(pair.Answer.Result, other.Result, name)
            : Say.Line($"{name}: {other}; as given: {pair.Answer}");
}
