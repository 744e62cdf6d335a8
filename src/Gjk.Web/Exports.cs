using System.Runtime.InteropServices;
using System.Runtime.InteropServices.JavaScript;
using Gjk.Core.Diagnostics;
using Gjk.Demo.View;

namespace Gjk.Web;

/// <summary>The functions that a page calls. Bodies and answers are exchanged in place: the page asks once where the
/// arrays lie and then writes and reads the program's memory.</summary>
internal static partial class Exports
{
    private static readonly Bodies Bodies = new();

    private static ShapeMesh? _surface;

    /// <summary>Makes room for bodies and pairs.</summary>
    /// <returns>The addresses of <see cref="Web.Bodies.ShapeOf"/>, of the motions, the pairs and the answers.</returns>
    [JSExport]
    internal static int[] Reserve(int bodies, int pairs)
    {
        Bodies.Reserve(bodies, pairs);
        return
        [
            Address(Bodies.ShapeOf), Address(Bodies.Motions), Address(Bodies.Pairs), Address(Bodies.Answers),
        ];
    }

    /// <summary>Adds a shape: that of the first body of a record.</summary>
    /// <returns>The shape's index.</returns>
    /// <exception cref="FormatException">The text is no record.</exception>
    [JSExport]
    internal static int AddShape(string record) => Bodies.Add(QueryRecord.Parse(record).A);

    /// <summary>Answers the first pairs of the list.</summary>
    [JSExport]
    internal static void Answer(int question, int count) => Answering.Run(Bodies, (Question)question, count);

    /// <summary>Answers the pairs of the first bodies that are this near, without asking every pair.</summary>
    /// <returns>Body A, body B and the numbers of an answer, pair after pair.</returns>
    [JSExport]
    internal static double[] PairsWithin(int bodies, double distance) =>
        Answering.PairsWithin(Bodies, bodies, (float)distance);

    /// <summary>Two bodies as a record.</summary>
    [JSExport]
    internal static string Record(int a, int b) =>
        new QueryRecord(Bodies.ShapeAt(a), Bodies.MotionAt(a), Bodies.ShapeAt(b), Bodies.MotionAt(b)).ToString();

    /// <summary>A record in its usual form, and so a check of one that a user gave.</summary>
    /// <exception cref="FormatException">The text is no record.</exception>
    [JSExport]
    internal static string Checked(string record) => QueryRecord.Parse(record).ToString();

    /// <summary>The normal, then each contact point on A with its gap.</summary>
    [JSExport]
    internal static double[] Contacts(int a, int b, double maxGap)
    {
        ContactManifold manifold = default;
        ConvexQuery.Contacts(
            Bodies.ShapeAt(a), Bodies.PoseAt(a), Bodies.ShapeAt(b), Bodies.PoseAt(b), (float)maxGap,
            out manifold);
        var numbers = new List<double> { manifold.Normal.X, manifold.Normal.Y, manifold.Normal.Z };
        for (int i = 0; i < manifold.Count; i++)
        {
            Vector3 p = manifold[i].PointA;
            numbers.AddRange([p.X, p.Y, p.Z, manifold[i].Gap]);
        }

        return numbers.ToArray();
    }

    /// <summary>Every step of a distance query; see <see cref="StepNumbers"/>.</summary>
    [JSExport]
    internal static double[] Explain(int a, int b)
    {
        var steps = new StepNumbers([]);
        ConvexQuery.Explain(
            Bodies.ShapeAt(a), Bodies.PoseAt(a), Bodies.ShapeAt(b), Bodies.PoseAt(b), ref steps);
        return steps.Numbers.ToArray();
    }

    /// <summary>Makes the surface of a shape, in its own frame.</summary>
    /// <returns>Dimension, 1 if smooth, number of triangle corners, these corners, the ends of the edges.</returns>
    [JSExport]
    internal static int[] ShapeSurface(int shape) => Keep(ShapeMesh.Of(Bodies.Shape(shape)));

    /// <summary>Makes the surface of A - B in A's frame, without the distance between the two positions.</summary>
    [JSExport]
    internal static int[] DifferenceSurface(int a, int b, bool isCoarse) => Keep(Difference.Of(
        Bodies.ShapeAt(a), Bodies.PoseAt(a), Bodies.ShapeAt(b), Bodies.PoseAt(b), isCoarse));

    /// <summary>The vertices of the last surface.</summary>
    [JSExport]
    internal static double[] SurfaceVertices()
    {
        ReadOnlySpan<Vector3> vertices = _surface is null ? [] : _surface.Vertices;
        var numbers = new double[3 * vertices.Length];
        ReadOnlySpan<float> floats = MemoryMarshal.Cast<Vector3, float>(vertices);
        for (int i = 0; i < numbers.Length; i++) numbers[i] = floats[i];
        return numbers;
    }

    private static int[] Keep(ShapeMesh surface)
    {
        _surface = surface;
        return
        [
            surface.Dimension, surface.IsSmooth ? 1 : 0, surface.Triangles.Length,
            .. surface.Triangles, .. surface.Edges,
        ];
    }

    private static unsafe int Address<T>(T[] pinned)
        where T : unmanaged
    {
        fixed (T* first = pinned) return (int)first;
    }
}
