using System.Collections.Generic;
using System.IO;
using System.Numerics;
using Gjk.Core;

namespace PartClearance;

/// <summary>A part: the convex hull of its points, which are where they are in the assembly.</summary>
internal sealed record Part(string Name, ConvexHull Hull)
{
    /// <exception cref="InvalidDataException">There are no points, or a coordinate is no finite number.</exception>
    public static Part Of(string name, IReadOnlyList<Vector3> points) =>
        ConvexHull.TryCreate(points, out ConvexHull? hull, out string? reason)
            ? new Part(name, hull)
            : throw new InvalidDataException($"{name}: {reason}");
}
