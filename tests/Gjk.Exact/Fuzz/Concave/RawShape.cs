namespace Gjk.Exact.Fuzz.Concave;

/// <summary>A shape by the numbers that it is made of: what the library is given, and what the oracle reads.
/// Immutable.</summary>
internal sealed record RawShape
{
    private RawShape()
    {
    }

    /// <summary>The triangles of a surface or solid, else null.</summary>
    public TriangleSoup? Triangles { get; private init; }

    public bool IsSolid { get; private init; }

    /// <summary>The height field that the triangles are of, else null.</summary>
    public RawField? Field { get; private init; }

    /// <summary>The parts of a compound, or a convex shape; else empty.</summary>
    public IReadOnlyList<RawPart> Parts { get; private init; } = [];

    public bool IsConvex { get; private init; }

    /// <summary>Factors of the whole.</summary>
    public Vector3 Scale { get; private init; } = Vector3.One;

    public int PartCount => Triangles?.Count ?? Parts.Count;

    public static RawShape Surface(TriangleSoup triangles) => new() { Triangles = triangles };

    public static RawShape Compound(IReadOnlyList<RawPart> parts) => new() { Parts = parts };

    public static RawShape Convex(RawPart part) =>
        new() { Parts = [part with { Pose = RigidPose.Identity }], IsConvex = true };

    /// <summary>With the triangles that a height field promises.</summary>
    public static RawShape Heights(RawField field) => new() { Triangles = field.List(), Field = field };

    /// <summary>The same with its inside, where the library finds one.</summary>
    public RawShape AsSolid() =>
        Triangles is not null && Triangles.Build().HasInside ? this with { IsSolid = true } : this;

    public RawShape Scaled(Vector3 factors) => this with { Scale = factors };

    /// <summary>Made of other numbers: as floats, each times a factor.</summary>
    public RawShape Larger(float factor) => this with
    {
        Triangles = Triangles?.Moved(p => p * factor),
        Field = null,
        Parts = [.. Parts.Select(p => p.Larger(factor) with { Pose = new(p.Pose.Rotation, p.Pose.Position * factor) })],
    };

    public RawShape Moved(Func<Vector3, Vector3> to) => this with { Triangles = Triangles!.Moved(to), Field = null };

    /// <summary>Without some parts in a row; a solid becomes a surface.</summary>
    public RawShape Without(int first, int count) => Triangles is null
        ? this with { Parts = [.. Parts.Take(first), .. Parts.Skip(first + count)] }
        : this with { Triangles = Triangles.Without(first, count), Field = null, IsSolid = false };

    /// <summary>As the library takes it.</summary>
    public AnyShape Build()
    {
        if (IsConvex) return AnyShape.Of(Scale == Vector3.One ? Parts[0].Build() : Parts[0].Build().Scaled(Scale));
        if (Triangles is null)
        {
            var compound = new CompoundShape([.. Parts.Select(p => new CompoundPart(p.Build(), p.Pose))]);
            return AnyShape.Of(Scale == Vector3.One ? compound : compound.Scaled(Scale));
        }

        TriangleMesh mesh = Field?.Build() ?? Triangles.Build();
        if (Scale != Vector3.One) mesh = mesh.Scaled(Scale);
        return IsSolid ? AnyShape.Solid(mesh) : AnyShape.Surface(mesh);
    }

    /// <summary>Each part as a convex shape of its own, from the numbers alone.</summary>
    public ConvexShape[] ListParts() =>
    [
        .. Enumerable.Range(0, PartCount).Select(i =>
        {
            ConvexShape part = Triangles is { } t
                ? ConvexShape.Triangle(t.Corner(i, 0), t.Corner(i, 1), t.Corner(i, 2))
                : IsConvex ? Parts[i].Build() : Parts[i].Build().Placed(Parts[i].Pose);
            return Scale == Vector3.One ? part : part.Scaled(Scale);
        }),
    ];

    /// <summary>The corners of a part, exactly; null where it is curved or placed, which rounds them.</summary>
    public Double3[]? CornersOf(int part)
    {
        Vector3[]? corners = Triangles is { } t ? [t.Corner(part, 0), t.Corner(part, 1), t.Corner(part, 2)]
            : !IsConvex ? null
            : Parts[0].Kind switch
            {
                ShapeKind.Point or ShapeKind.Sphere when Scale == Vector3.One => [Vector3.Zero],
                ShapeKind.Box => Clouds.Box(Parts[0].Sizes[0]),
                ShapeKind.Triangle or ShapeKind.Mesh => Parts[0].Sizes,
                _ => null,
            };
        return corners is null ? null : Array.ConvertAll(corners, p => Double3.Multiply(p, Scale));
    }

    /// <summary>The corners of all triangles, three each.</summary>
    public Double3[] AllCorners() => [.. Enumerable.Range(0, PartCount).SelectMany(i => CornersOf(i)!)];

    /// <summary>One triangle of each connected piece of a surface, and every part of a compound.</summary>
    public IEnumerable<int> Pieces()
    {
        if (Triangles is not { } t) return Enumerable.Range(0, PartCount);
        int[] root = [.. Enumerable.Range(0, t.Count)];
        int Find(int i) => root[i] == i ? i : root[i] = Find(root[i]);
        var at = new Dictionary<Vector3, int>();
        for (int i = 0; i < 3 * t.Count; i++)
        {
            Vector3 corner = t.Points[t.Indices[i]] + Vector3.Zero;
            if (!at.TryAdd(corner, i / 3)) root[Find(i / 3)] = Find(at[corner]);
        }

        return Enumerable.Range(0, t.Count).Where(i => Find(i) == i);
    }
}
