using Gjk.Core;
using Gjk.Core.Diagnostics;
using Gjk.Unity;
using UnityEngine;

namespace Gjk.Samples
{
    /// <summary>Draws how the solver searches: from A's position each direction in which it asked for support points,
    /// in yellow, and about it each simplex of A - B, in blue. All is told in A's frame and drawn with A's
    /// rotation.</summary>
    internal sealed class SearchLines
    {
        public void Draw(in PosedShape a, in PosedShape b)
        {
            var trace = new Trace(a.Pose);
            ConvexQuery.Explain(a.Shape, a.Pose, b.Shape, b.Pose, ref trace);
        }

        private readonly struct Trace : IGjkTrace
        {
            private readonly RigidPose _pose;

            public Trace(in RigidPose pose) => _pose = pose;

            public bool IsOn => true;

            public void OnSupport(in TracedSupport support)
            {
                double length = support.Normal.Length;
                if (length > 0) Line(default, support.Normal * (-1 / length), Color.yellow);
            }

            public void OnReduced(in TracedSimplex simplex)
            {
                for (int i = 0; i < simplex.Count; i++)
                {
                    for (int j = i + 1; j < simplex.Count; j++) Line(simplex.Vertex(i), simplex.Vertex(j), Color.blue);
                }
            }

            private void Line(in Double3 from, in Double3 to, Color color) =>
                Debug.DrawLine(World(from), World(to), color);

            private Vector3 World(in Double3 v) => _pose.TransformPoint((System.Numerics.Vector3)v).ToUnity();
        }
    }
}
