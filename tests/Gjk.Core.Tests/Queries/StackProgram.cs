namespace Gjk.Core.Tests.Queries;

/// <summary>Does everything that the library does for a caller on threads with little stack, and measures how much it
/// took. A program of its own: a thread that runs out of stack ends its process.</summary>
internal static class StackProgram
{
    public const string Command = "stack";

    /// <summary>Bytes: what the thread has, and what a call may take of it (contract 15).</summary>
    public const int Thread = 128 << 10, Most = 64 << 10;

    private const int Objects = 60;

    /// <summary>Prints each piece of work before it is done, and how many bytes it took.</summary>
    public static int Run()
    {
        bool isWithin = true;
        foreach ((string name, Action work) in Works())
        {
            Console.Write(name + " ");
            int used = StackUse.Least(work, Most);
            Console.WriteLine(used);
            StackUse.On(Thread, work);
            isWithin &= used <= Most;
        }

        return isWithin ? 0 : 1;
    }

    private static IEnumerable<(string Name, Action Work)> Works()
    {
        foreach (string kind in Generators.AllKinds)
        {
            TestPair[] pairs = [.. Generators.AllKinds.Select((other, i) => Pair((ulong)i, kind, other))];
            yield return (kind, Together(pairs.SelectMany(Verbs)));
        }

        TestPair[] extreme = [.. Generators.AllKinds.Select((k, i) => Pair((ulong)i, k, k).Resized(1e25f))];
        yield return ("extreme sizes", Together(extreme.SelectMany(Verbs)));
        foreach ((string name, ConvexShape a, ConvexShape b) in Concentric())
            yield return (name, Together(Turned(a, b)));
        yield return ("types", Together(Typed()));
        using var workers = new Workers(2);
        foreach (BroadPhaseKind kind in Enum.GetValues<BroadPhaseKind>())
        {
            yield return ($"scene {kind}", EveryFrame.Of(kind, null, Objects));
            yield return ($"scene {kind}, two threads", EveryFrame.Of(kind, workers, Objects));
        }
    }

    private static TestPair Pair(ulong seed, string a, string b)
    {
        var rng = new Rng(seed);
        return new TestPair(
            $"{a} {b}", Generators.Shape(rng, a), Generators.Pose(rng, default), Generators.Shape(rng, b),
            Generators.Pose(rng, rng.Vector(-0.3, 0.3)));
    }

    private static Action[] Verbs(TestPair p) => EveryVerb.Of(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB);

    private static Action Together(IEnumerable<Action> calls)
    {
        Action[] all = [.. calls];
        return () =>
        {
            foreach (Action call in all) call();
        };
    }

    /// <summary>Where the searches for a depth need all the room that there is.</summary>
    private static IEnumerable<(string Name, ConvexShape A, ConvexShape B)> Concentric()
    {
        var uv = ConvexShape.Mesh(RoundHulls.Uv(45, 90));
        var ico = ConvexShape.Mesh(RoundHulls.Ico(3));
        yield return ("4,000 corners", uv, uv);
        yield return ("642 corners", ico, ico);
        yield return ("spiral", ConvexShape.Mesh(RoundHulls.Spiral(4000)), uv);
        yield return ("rounded", ico.Rounded(0.1f), uv.Rounded(0.1f));
        yield return ("scaled", ico.Scaled(new Vector3(1, -2, 3)), uv.Scaled(new Vector3(1, 2, 0.5f)));
        yield return ("placed", ico.Placed(new RigidPose(new Vector3(0.1f))).Scaled(new Vector3(1, 2, 1)), uv);
        yield return ("in a cylinder", ConvexShape.Cylinder(1, 1), uv);
        yield return ("in an ellipsoid", ConvexShape.Ellipsoid(new Vector3(1, 1.01f, 0.99f)), ico);
        var flattened = ConvexShape.Ellipsoid(new(1, 0.99f, 0.98f));
        yield return ("nearly round", flattened, flattened);
    }

    private static Action[] Turned(ConvexShape a, ConvexShape b)
    {
        var rng = new Rng(7);
        return
        [
            .. EveryVerb.Of(a, RigidPose.Identity, b, RigidPose.Identity),
            .. EveryVerb.Of(a, Generators.Pose(rng, default), b, Generators.Pose(rng, new Vector3(1e-3f))),
            .. EveryVerb.Of(a, Generators.Pose(rng, default), b, Generators.Pose(rng, new Vector3(0.5f))),
        ];
    }

    /// <summary>Shapes by their own types, whose queries are compiled for them alone.</summary>
    private static Action[] Typed()
    {
        var rng = new Rng(8);
        RigidPose at = Generators.Pose(rng, default), to = Generators.Pose(rng, rng.Vector(-0.3, 0.3));
        var ball = new ConvexMesh(RoundHulls.Ico(3));
        var cylinder = new CylinderShape(0.5f, 1);
        var placed = new Placed<Scaled<ConvexMesh>>(new Scaled<ConvexMesh>(ball, new Vector3(1, 2, 1)), to);
        var round = new Rounded<Placed<Scaled<BoxShape>>>(
            new Placed<Scaled<BoxShape>>(new Scaled<BoxShape>(new BoxShape(new(0.5f)), new Vector3(1, 2, 3)), to),
            0.1f);
        return
        [
            .. EveryVerb.Of(ball, at, ball, at), .. EveryVerb.Of(ball, at, placed, to),
            .. EveryVerb.Of(placed, at, round, to), .. EveryVerb.Of(round, at, cylinder, to),
            .. EveryVerb.Of(new CapsuleShape(0.5f, 1), at, new ConeShape(0.5f, 1), to),
            .. EveryVerb.Of(new EllipsoidShape(new(0.5f, 1, 0.7f)), at, new SphereShape(0.5f), to),
            .. EveryVerb.Of(
                new SegmentShape(default, new(1)), at, new TriangleShape(default, new(1), new(1, 0, 0)), to),
            .. EveryVerb.Of(new PointShape(), at, cylinder, at),
        ];
    }
}
