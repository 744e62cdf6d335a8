using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>All promises about concave shapes, those first that the others build on.</summary>
internal static class ConcavePromises
{
    public static IReadOnlyList<Promise<ConcavePair>> All { get; } =
    [
        new("the distance is the least of all parts, and the named parts have it", LeastOfParts.Distance),
        new("the distance is the exact one, rounded, and no bound is above it", LeastOfParts.Exact),
        new("Overlaps and a largest distance say the same", LeastOfParts.Limits),
        new("all pairs of parts within a distance are found, sorted", LeastOfParts.Within),
        new("the depths are those of the parts that overlap", LeastOfParts.Depths),
        new("the answer depends on the pair alone", SameConcave.Again),
        new("a warm start does not change the distance", SameConcave.Warm),
        new("exchanging A and B mirrors the answer", SameConcave.Swapped),
        new("moved vertices and parts are answered like new ones", SameConcave.Refit),
        new("a ray meets the parts in their order", FirstOfParts.Rays),
        new("a cast finds the first touch of any parts", FirstOfParts.Casts),
        new("a time of impact is the least of all parts", FirstOfParts.Impacts),
        new("a point is as near and as far inside as the parts say", PointsOfParts.Broken),
        new("contacts are those of the parts, or along their faces", ContactsOfParts.Broken),
        new("a scene and a batch say what the query says", ScenesOfParts.Broken),
    ];
}
