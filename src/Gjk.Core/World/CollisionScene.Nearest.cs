using System;
using System.Collections.Generic;
using System.Numerics;

namespace Gjk.Core;

public sealed partial class CollisionScene
{
    /// <summary>
    /// Ratio: by how much the search for the nearest object widens while it finds none. A matter of speed only.
    /// </summary>
    private const float SearchGrowth = 4;

    private readonly List<int> _near = [];

    /// <summary>
    /// The object nearest to one, of those that it is tested against (<see cref="ObjectSettings"/>); of several the one
    /// with the least id.
    /// </summary>
    /// <param name="id">The object.</param>
    /// <param name="other">The nearest other object, or -1 where there is none.</param>
    /// <param name="result">
    /// The distance from the object (A) to the other (B), as <see cref="ConvexQuery"/> has it.
    /// </param>
    /// <returns>False when there is no such object.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public bool TryFindNearest(int id, out int other, out DistanceResult result)
    {
        CheckNotVisiting();
        int slot = _objects.Checked(id, nameof(id));
        other = -1;
        result = default;
        if (_objects.Count == 1) return false;

        int best = -1;
        float reach = (float)Math.Min(Math.Max(_objects.Bounds[slot].Radius, float.Epsilon), float.MaxValue);
        NearestWithin(slot, reach, ref best, ref result);
        while (best < 0 && _near.Count < _objects.Count)
        {
            reach *= SearchGrowth;
            NearestWithin(slot, reach, ref best, ref result);
        }

        if (best < 0) return false;

        // What lies nearer than the one found may be outside the box in which it was found.
        if (result.Distance > reach) NearestWithin(slot, result.Distance, ref best, ref result);
        other = _objects.Ids[best];
        return true;
    }

    /// <summary>Improves the nearest object found so far by those whose bounds are within reach.</summary>
    private void NearestWithin(int slot, float reach, ref int best, ref DistanceResult result)
    {
        _phase.CollectInBox(Widened(_objects.Bounds[slot].BoxAt(_objects.Poses[slot]), reach), _near);
        for (int i = 0; i < _near.Count; i++)
        {
            int other = _near[i];
            if (other == slot || !_objects.AreTested(slot, other)) continue;

            // A little more than the best, so that equals are found and the one of several does not depend on the order
            // of the search.
            float limit = best < 0 ? float.PositiveInfinity : result.Distance * MarginSlack + float.Epsilon;
            DistanceResult found = ConvexQuery.Distance(
                _objects.Shapes[slot], _objects.Poses[slot], _objects.Shapes[other], _objects.Poses[other], limit);
            bool better = best < 0 || found.Distance < result.Distance
                || (found.Distance == result.Distance && other < best);
            if (!better) continue;
            best = other;
            result = found;
        }
    }

    private static Aabb Widened(in Aabb box, float reach)
    {
        var widening = new Vector3(reach * MarginSlack);
        var limit = new Vector3(float.MaxValue);
        return new Aabb(Vector3.Max(box.Min - widening, -limit), Vector3.Min(box.Max + widening, limit));
    }
}
