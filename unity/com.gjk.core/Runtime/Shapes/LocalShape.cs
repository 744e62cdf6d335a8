using Gjk.Core;

namespace Gjk.Unity
{
    /// <summary>A shape with its scale, and its place in the rigid frame of its transform.</summary>
    internal struct LocalShape
    {
        public ConvexShape Shape;
        public Double3 Offset;
        public Turn Turn;
    }
}
