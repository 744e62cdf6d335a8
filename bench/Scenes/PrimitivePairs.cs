namespace Gjk.Bench.Scenes;

/// <summary>Random pairs of primitives. Every measurement of the generic path uses them.</summary>
public sealed class PrimitivePairs
{
    public PrimitivePairs()
    {
        Vector3[] sphere = MeshVertices.Sphere(0.3f), capsule = MeshVertices.Capsule(0.2f, 0.3f);
        Vector3[] cube = MeshVertices.Cube(0.35f);
        Spheres = new(21, _ => (new SphereShape(0.3f), sphere));
        Capsules = new(22, _ => (new CapsuleShape(0.2f, 0.3f), capsule));
        Cubes = new(23, _ => (new BoxShape(new Vector3(0.35f)), cube));
        Boxes = new(24, prng =>
        {
            var half = new Vector3(prng.Range(0.15f, 0.5f), prng.Range(0.15f, 0.5f), prng.Range(0.15f, 0.5f));
            return (new BoxShape(half), MeshVertices.Box(half));
        });
        Triangles = new(25, prng =>
        {
            Vector3 a = prng.UnitVector() * 0.5f, b = prng.UnitVector() * 0.5f, c = prng.UnitVector() * 0.5f;
            return (new TriangleShape(a, b, c), new[] { a, b, c });
        });
    }

    public TypedPairs<SphereShape> Spheres { get; }

    public TypedPairs<CapsuleShape> Capsules { get; }

    /// <summary>Boxes with equal sides.</summary>
    public TypedPairs<BoxShape> Cubes { get; }

    /// <summary>Boxes with random sides.</summary>
    public TypedPairs<BoxShape> Boxes { get; }

    public TypedPairs<TriangleShape> Triangles { get; }
}
