namespace Gjk.Bench.Baseline;

/// <summary>A mesh as the renderer has it, including repeated corners. A query rotates the direction into the mesh's
/// frame and the winning vertex back into the world. So moving the object costs nothing between calls.</summary>
public sealed class MeshSupportCollider : SupportCollider
{
    private readonly Vector3[] _vertices;

    public MeshSupportCollider(Vector3[] vertices, Quaternion rotation, Vector3 position)
        : base(rotation, position) => _vertices = vertices;

    public override Vector3 FindFurthestPoint(Vector3 direction)
    {
        Vector3 local = Vector3.Transform(direction, Quaternion.Conjugate(Rotation));
        Vector3 furthest = default;
        float largest = float.NegativeInfinity;
        foreach (Vector3 vertex in _vertices)
        {
            float dot = Vector3.Dot(vertex, local);
            if (dot > largest)
            {
                largest = dot;
                furthest = vertex;
            }
        }

        return Vector3.Transform(furthest, Rotation) + Position;
    }
}
