using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// A cloud without repeats, in the order of first occurrence. Two points are the same when their coordinates are equal; -0 equals 0 and is kept as 0.
/// </summary>
internal sealed class DistinctPoints
{
    /// <summary>The points, each once.</summary>
    public readonly Vector3[] Points;

    /// <summary>For each point the index of its first occurrence in the cloud; ascending.</summary>
    public readonly int[] Sources;

    public DistinctPoints(Vector3[] cloud)
    {
        // Open addressing, at most half full; a slot holds the index of a distinct point plus one.
        int slots = 16;
        while (slots < 2L * cloud.Length && slots < 1 << 30) slots *= 2;
        int[] table = new int[slots];
        var points = new Vector3[cloud.Length];
        int[] sources = new int[cloud.Length];
        int count = 0;
        for (int i = 0; i < cloud.Length; i++)
        {
            Vector3 p = WithoutNegativeZeros(cloud[i]);
            int slot = (int)(Hash(p) & (uint)(slots - 1));
            while (table[slot] != 0 && points[table[slot] - 1] != p) slot = slot + 1 & slots - 1;
            if (table[slot] != 0) continue;
            points[count] = p;
            sources[count] = i;
            table[slot] = ++count;
        }

        Array.Resize(ref points, count);
        Array.Resize(ref sources, count);
        Points = points;
        Sources = sources;
    }

    private static Vector3 WithoutNegativeZeros(Vector3 p) =>
        new(p.X == 0 ? 0 : p.X, p.Y == 0 ? 0 : p.Y, p.Z == 0 ? 0 : p.Z);

    /// <summary>Multiplications by odd constants and shifts, so that lattices, whose coordinates differ in few high bits, spread over the low bits.</summary>
    private static uint Hash(Vector3 p)
    {
        unchecked
        {
            uint h = (uint)p.X.GetHashCode() * 0x9E3779B1u;
            h = (h ^ h >> 15 ^ (uint)p.Y.GetHashCode()) * 0x85EBCA77u;
            h = (h ^ h >> 13 ^ (uint)p.Z.GetHashCode()) * 0xC2B2AE3Du;
            h = (h ^ h >> 16) * 0x27D4EB2Fu;
            return h ^ h >> 15;
        }
    }
}
