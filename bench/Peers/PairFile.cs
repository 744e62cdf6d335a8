namespace Gjk.Bench.Peers;

/// <summary>Pairs in the binary form that <c>peers/peer.hpp</c> reads: little-endian integers and floats.</summary>
internal static class PairFile
{
    private const int Magic = 0x31504a47;
    private const int Sphere = 0, Capsule = 1, Box = 2, Hull = 3, Surface = 4;

    /// <exception cref="NotSupportedException">A shape has no form there.</exception>
    public static void Write(string file, BenchScene scene)
    {
        using var output = new BinaryWriter(File.Create(file));
        output.Write(Magic);
        output.Write(scene.Shapes.Length);
        foreach (ConvexShape shape in scene.Shapes) Write(output, shape);
        output.Write(scene.Pairs.Length);
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            output.Write(pair.A);
            output.Write(pair.B);
            Write(output, scene.Poses[pair.A]);
            Write(output, scene.Poses[pair.B]);
        }
    }

    /// <inheritdoc cref="Write(string, BenchScene)"/>
    public static void Write(string file, ConcaveScene scene)
    {
        using var output = new BinaryWriter(File.Create(file));
        output.Write(Magic);
        output.Write(2);
        Write(output, scene.A);
        Write(output, scene.B);
        output.Write(scene.Poses.Length);
        foreach (RigidPose pose in scene.Poses)
        {
            output.Write(0);
            output.Write(1);
            Write(output, RigidPose.Identity);
            Write(output, pose);
        }
    }

    private static void Write(BinaryWriter output, in AnyShape shape)
    {
        if (shape.Mesh is not { } mesh)
        {
            Write(output, shape.Convex);
            return;
        }

        Write(output, Surface, Vector3.Zero, mesh.VertexCount, mesh.GetVertex, mesh.TriangleCount, mesh.GetTriangle);
    }

    private static void Write(BinaryWriter output, in ConvexShape shape)
    {
        if (shape.IsDecorated) throw new NotSupportedException("The other engines know no decorated shapes.");
        shape.Support(new Double3(1, 1, 1), out Double3 corner);
        switch (shape.Kind)
        {
            case ShapeKind.Sphere:
                Write(output, Sphere, new Vector3((float)shape.Margin, 0, 0));
                break;
            case ShapeKind.Capsule:
                Write(output, Capsule, new Vector3((float)shape.Margin, (float)corner.Y, 0));
                break;
            case ShapeKind.Box:
                Write(output, Box, (Vector3)corner);
                break;
            case ShapeKind.Mesh:
                ConvexHull hull = shape.Hull!;
                Write(
                    output, Hull, Vector3.Zero, hull.VertexCount, hull.GetVertex, hull.TriangleCount, hull.GetTriangle);
                break;
            default:
                throw new NotSupportedException($"The other engines know no {shape.Kind}.");
        }
    }

    private delegate void TriangleGetter(int index, out int a, out int b, out int c);

    private static void Write(
        BinaryWriter output, int kind, Vector3 size, int vertices = 0, Func<int, Vector3>? vertex = null,
        int triangles = 0, TriangleGetter? triangle = null)
    {
        output.Write(kind);
        Write(output, size);
        output.Write(vertices);
        for (int i = 0; i < vertices; i++) Write(output, vertex!(i));
        output.Write(triangles);
        for (int i = 0; i < triangles; i++)
        {
            triangle!(i, out int a, out int b, out int c);
            output.Write(a);
            output.Write(b);
            output.Write(c);
        }
    }

    private static void Write(BinaryWriter output, in RigidPose pose)
    {
        output.Write(pose.Rotation.X);
        output.Write(pose.Rotation.Y);
        output.Write(pose.Rotation.Z);
        output.Write(pose.Rotation.W);
        Write(output, pose.Position);
    }

    private static void Write(BinaryWriter output, Vector3 v)
    {
        output.Write(v.X);
        output.Write(v.Y);
        output.Write(v.Z);
    }
}
