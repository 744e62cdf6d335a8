namespace Gjk.Core;

/// <remarks>What only a trace asks for.</remarks>
internal unsafe partial struct Polytope
{
    /// <summary>How many faces are part of the surface.</summary>
    public readonly int FacesThere => _faceCount - _freeCount;

    /// <summary>How many vertices were taken; not all need be on the surface.</summary>
    public readonly int VertexCount => _vertexCount;

    /// <summary>How many vertices there is room for.</summary>
    public readonly int Room => _mostVertices;

    /// <summary>The least of a face's offsets from the origin along its normal.</summary>
    public readonly double Height(int face) => _heights[face];
}
