namespace Gjk.Core.Tests.Support;

/// <summary>A compound with solids, and its leaves as shapes of their own at their places.</summary>
internal sealed class SolidChildren
{
    private SolidChildren(CompoundShape compound, List<(AnyShape Shape, RigidPose Pose)> leaves) =>
        (Compound, Leaves) = (compound, leaves);

    public CompoundShape Compound { get; }

    public AnyShape Shape => AnyShape.Of(Compound);

    /// <summary>In the compound's frame, in the order of its parts.</summary>
    public List<(AnyShape Shape, RigidPose Pose)> Leaves { get; }

    /// <summary>Draws one.</summary>
    /// <param name="random">What draws it.</param>
    /// <param name="depth">How many compounds may be in each other.</param>
    /// <param name="isAllSolid">Whether all leaves are solids.</param>
    public static SolidChildren Any(Rng random, int depth, bool isAllSolid = false)
    {
        var children = new CompoundPart[1 + random.Below(4)];
        List<(AnyShape, RigidPose)> leaves = [];
        for (int i = 0; i < children.Length; i++)
        {
            RigidPose pose = random.OneIn(4) ? RigidPose.Identity : ConcaveShapes.Pose(random, 0.6);
            if (depth > 0 && random.OneIn(3))
            {
                SolidChildren nested = Any(random, depth - 1, isAllSolid);
                children[i] = new CompoundPart(nested.Shape, pose);
                foreach ((AnyShape shape, RigidPose own) in nested.Leaves) leaves.Add((shape, Within(pose, own)));
                continue;
            }

            AnyShape leaf = Leaf(random, isAllSolid || random.OneIn(2));
            children[i] = new CompoundPart(leaf, pose);
            leaves.Add((leaf, pose));
        }

        var made = new SolidChildren(new CompoundShape(children), leaves);
        return depth > 0 && random.OneIn(3) ? made.Scaled(random.Of(0.5f, 2, 1.25f)) : made;
    }

    /// <summary>Of each seed a compound with its leaves, and another body with its own.</summary>
    public static (SolidChildren A, RigidPose PoseA, AnyShape B, RigidPose PoseB, List<(AnyShape, RigidPose)> Leaves)
        Setup(int seed)
    {
        var random = new Rng((ulong)seed);
        SolidChildren a = Any(random, seed % 3);
        RigidPose poseA = seed % 2 == 0 ? RigidPose.Identity : ConcaveShapes.Pose(random, 2);
        RigidPose near = random.OneIn(2) ? a.Leaves[random.Below(a.Leaves.Count)].Pose : RigidPose.Identity;
        RigidPose poseB = Within(
            poseA, Within(near, ConcaveShapes.Pose(random, random.Of(0.3, 1, 2))));
        if (random.OneIn(3))
        {
            SolidChildren b = Any(random, 1);
            return (a, poseA, b.Shape, poseB, b.Leaves);
        }

        AnyShape other = random.Below(4) switch
        {
            0 => AnyShape.Of(ConvexShape.Sphere(random.Of(0, 0.05f, 0.3f))),
            1 => AnyShape.Of(ConvexShape.Box(new Vector3(0.03f, 0.05f, 0.1f))),
            2 => AnyShape.Surface(ConcaveShapes.Soup(random, 3, 0.05)),
            _ => AnyShape.Solid(ConcaveShapes.Torus(5, 4, 0.1f, 0.03f)),
        };
        return (a, poseA, other, poseB, [(other, RigidPose.Identity)]);
    }

    /// <summary>A pose within another one.</summary>
    public static RigidPose Within(in RigidPose outer, in RigidPose inner) => new(
        Quaternion.Normalize(outer.Rotation * inner.Rotation), outer.TransformPoint(inner.Position));

    private SolidChildren Scaled(float factor) => new(
        Compound.Scaled(new Vector3(factor)),
        Leaves.ConvertAll(leaf => (Scaled(leaf.Shape, factor), Grown(leaf.Pose, factor))));

    private static RigidPose Grown(in RigidPose pose, float factor) => new(pose.Rotation, pose.Position * factor);

    private static AnyShape Scaled(in AnyShape shape, float factor)
    {
        var scale = new Vector3(factor);
        return shape.Kind switch
        {
            AnyShapeKind.Solid => AnyShape.Solid(shape.Mesh!.Scaled(scale)),
            AnyShapeKind.Compound => AnyShape.Of(shape.Compound!.Scaled(scale)),
            _ => AnyShape.Of(shape.Convex.Scaled(scale)),
        };
    }

    private static AnyShape Leaf(Rng random, bool isSolid)
    {
        if (!isSolid)
        {
            // A surface among others is triangles: each has two fronts, and leaves a solid by itself.
            AnyShape soup = AnyShape.Surface(ConcaveShapes.Soup(random, 5, 0.3));
            return random.OneIn(2)
                ? AnyShape.Of(new CompoundShape([new CompoundPart(soup, RigidPose.Identity)]))
                : AnyShape.Of(ConvexShape.Box(random.Vector(0.1) + new Vector3(0.2f)));
        }

        TriangleMesh mesh = random.Below(3) switch
        {
            0 => ConcaveShapes.Torus(7, 5, 0.5f, 0.2f),
            1 => ConcaveShapes.Box(random.Vector(0.2) + new Vector3(0.4f)),
            _ => ConcaveShapes.Torus(4, 3, 0.3f, 0.25f),
        };
        Vector3 mirror = random.OneIn(3) ? new Vector3(-1, 1, 1) : Vector3.One;
        return AnyShape.Solid(random.OneIn(2) ? mesh : mesh.Scaled(mirror * random.Factors(0.5, 1.5)));
    }
}
