using System;
using System.Collections.Generic;
using Gjk.Core;

namespace EnterExit;

/// <summary>Says which pairs of a scene began to overlap since the last frame, and which no longer do.</summary>
internal sealed class OverlapEvents(CollisionScene scene)
{
    private List<ObjectPair> _before = [], _now = [];

    /// <summary>The two objects did not overlap in the last frame, and do now. Touching is overlapping.</summary>
    public event Action<ObjectPair>? Entered;

    /// <summary>The two objects overlapped in the last frame, and no longer do.</summary>
    public event Action<ObjectPair>? Exited;

    /// <summary>Looks at the scene as it is now, and fires the events in the order of the pairs.</summary>
    public void Update()
    {
        (_before, _now) = (_now, _before);
        scene.FindOverlaps(_now);

        // Both lists are sorted, so one walk along both finds what is in only one of them.
        int b = 0, n = 0;
        while (b < _before.Count || n < _now.Count)
        {
            int order = b == _before.Count ? 1 : n == _now.Count ? -1 : _before[b].CompareTo(_now[n]);
            if (order < 0) Exited?.Invoke(_before[b]);
            if (order > 0) Entered?.Invoke(_now[n]);
            if (order <= 0) b++;
            if (order >= 0) n++;
        }
    }
}
