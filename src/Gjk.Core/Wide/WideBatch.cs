#if NET
namespace Gjk.Core;

/// <summary>A part of a batch: its pairs by kind, four at a time where that is faster, else one by one.</summary>
/// <param name="shapes">The shapes.</param>
/// <param name="poses">One for each shape.</param>
/// <param name="pairs">The part's pairs.</param>
/// <param name="answered">Whether each pair has its answer already; a null reference where none has.</param>
internal readonly unsafe ref struct WideBatch(
    ConvexShape[] shapes, RigidPose[] poses, ref ObjectPair pairs, ref bool answered)
{
    /// <summary>Count of pairs in a part at most.</summary>
    public const int MostPairs = 256;

    /// <summary>Count: fewer pairs of a kind than this are asked one by one, since four cost as much as two alone. A
    /// matter of speed only.</summary>
    private const int LeastPairs = 3;

    /// <summary>Count: kinds of pairs, by their routes and the kinds of their cores.</summary>
    private const int OneKinds = 5, CoreKinds = OneKinds * OneKinds, Kinds = 3 * CoreKinds;

    /// <summary>Stands for the kind of a pair that was answered when it was sorted.</summary>
    private const int Answered = Kinds;

    private readonly ref ConvexShape _shapes = ref MemoryMarshal.GetArrayDataReference(shapes);
    private readonly ref RigidPose _poses = ref MemoryMarshal.GetArrayDataReference(poses);
    private readonly ref ObjectPair _pairs = ref pairs;
    private readonly ref bool _answered = ref answered;

    /// <summary>Whether four pairs can be solved at once on this machine.</summary>
    public static bool IsSupported => Avx2.IsSupported;

    public ref ConvexShape ShapeA(int pair) => ref Unsafe.Add(ref _shapes, Unsafe.Add(ref _pairs, pair).A);

    public ref ConvexShape ShapeB(int pair) => ref Unsafe.Add(ref _shapes, Unsafe.Add(ref _pairs, pair).B);

    public ref RigidPose PoseA(int pair) => ref Unsafe.Add(ref _poses, Unsafe.Add(ref _pairs, pair).A);

    public ref RigidPose PoseB(int pair) => ref Unsafe.Add(ref _poses, Unsafe.Add(ref _pairs, pair).B);

    /// <summary>Reads the centres, margins and radii of four pairs.</summary>
    public void ReadSizes(int* index, ref WidePairs s)
    {
        ref ConvexShape a0 = ref ShapeA(index[0]), a1 = ref ShapeA(index[1]);
        ref ConvexShape a2 = ref ShapeA(index[2]), a3 = ref ShapeA(index[3]);
        ReadSizes(a0, a1, a2, a3, out s.CenterA, out s.MarginA, out s.RadiusA);
        ref ConvexShape b0 = ref ShapeB(index[0]), b1 = ref ShapeB(index[1]);
        ref ConvexShape b2 = ref ShapeB(index[2]), b3 = ref ShapeB(index[3]);
        ReadSizes(b0, b1, b2, b3, out s.CenterB, out s.MarginB, out s.RadiusB);
    }

    /// <summary>The lanes of the pairs of which one shape is placed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> ArePlaced(int* index)
    {
        FormKind any = (ShapeA(index[0]).Core | ShapeB(index[0]).Core | ShapeA(index[1]).Core | ShapeB(index[1]).Core
            | ShapeA(index[2]).Core | ShapeB(index[2]).Core | ShapeA(index[3]).Core | ShapeB(index[3]).Core)
            & FormKind.Moved;
        return any == 0 ? Vector256<double>.Zero : Vector256.Create(
            IsPlaced(index[0]), IsPlaced(index[1]), IsPlaced(index[2]), IsPlaced(index[3])).AsDouble();
    }

    private long IsPlaced(int pair) => ((ShapeA(pair).Core | ShapeB(pair).Core) & FormKind.Moved) == 0 ? 0 : -1;

    /// <summary>How the cores are turned in the frames of four first shapes.</summary>
    public WideQuaternion CoreRotationsOfA(int* index) =>
        WideQuaternion.FromShapes(ShapeA(index[0]), ShapeA(index[1]), ShapeA(index[2]), ShapeA(index[3]));

    /// <summary>How the cores are turned in the frames of four second shapes.</summary>
    public WideQuaternion CoreRotationsOfB(int* index) =>
        WideQuaternion.FromShapes(ShapeB(index[0]), ShapeB(index[1]), ShapeB(index[2]), ShapeB(index[3]));

    /// <summary>Runs a question over the part's pairs.</summary>
    /// <param name="count">How many there are.</param>
    /// <param name="question">What to ask, and where the answers go.</param>
    public void Run<TQuestion>(int count, ref TQuestion question)
        where TQuestion : struct, IWideQuestion, allows ref struct
    {
        int* byKind = stackalloc int[MostPairs];
        int* starts = stackalloc int[Kinds + 1];
        Sort(count, byKind, starts, ref question);
        for (int kind = 0; kind < Kinds; kind++)
        {
            int length = starts[kind + 1] - starts[kind];
            int* index = byKind + starts[kind];
            if (length > 0) RunKind(kind, index, length, ref question);
        }
    }

    /// <summary>Runs it over pairs of one kind.</summary>
    private void RunKind<TQuestion>(int kind, int* index, int count, ref TQuestion question)
        where TQuestion : struct, IWideQuestion, allows ref struct
    {
        var kindA = (FormKind)(kind % CoreKinds / OneKinds);
        if (kindA == FormKind.Box) RunKind<WideBoxes, TQuestion>(kind, index, count, ref question);
        else if (kindA == FormKind.Hull) RunKind<WideHulls, TQuestion>(kind, index, count, ref question);
        else if (kindA == FormKind.Segment) RunKind<WideSegments, TQuestion>(kind, index, count, ref question);
        else RunKind<WideTriangles, TQuestion>(kind, index, count, ref question);
    }

    /// <summary>The same where the kind of the first shapes is known.</summary>
    private void RunKind<TA, TQuestion>(int kind, int* index, int count, ref TQuestion question)
        where TA : struct, IWideSide
        where TQuestion : struct, IWideQuestion, allows ref struct
    {
        var kindB = (FormKind)(kind % OneKinds);
        if (kindB == FormKind.Box) Run<TA, WideBoxes, TQuestion>(index, count, ref question);
        else if (kindB == FormKind.Hull) Run<TA, WideHulls, TQuestion>(index, count, ref question);
        else if (kindB == FormKind.Segment) Run<TA, WideSegments, TQuestion>(index, count, ref question);
        else Run<TA, WideTriangles, TQuestion>(index, count, ref question);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private void Run<TA, TB, TQuestion>(int* index, int count, ref TQuestion question)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
        where TQuestion : struct, IWideQuestion, allows ref struct
    {
        Unsafe.SkipInit(out WidePairs pairs);
        TA a = default;
        TB b = default;
        int* four = stackalloc int[4];
        for (int begin = 0; begin < count; begin += 4)
        {
            int lanes = count - begin < 4 ? count - begin : 4;
            uint done = 0;
            for (int i = 0; i < 4; i++) four[i] = index[begin + (i < lanes ? i : 0)];
            if (lanes >= LeastPairs)
            {
                for (int i = 0; i < 4; i++)
                {
                    a.Load(i, ShapeA(four[i]));
                    b.Load(i, ShapeB(four[i]));
                }

                WideFrame.Begin(this, four, question.Reach, ref pairs);
                done = question.SolveFour(ref a, ref b, this, ref pairs, four, lanes);
            }

            for (int i = 0; i < lanes; i++)
                if ((done >> i & 1) == 0) question.SolveAlone(this, four[i]);
        }
    }

    /// <summary>Answers the pairs that are not for lanes, and puts the indices of the others in the order of their
    /// kinds.</summary>
    private void Sort<TQuestion>(int count, int* byKind, int* starts, ref TQuestion question)
        where TQuestion : struct, IWideQuestion, allows ref struct
    {
        byte* kinds = stackalloc byte[MostPairs];
        for (int i = 0; i <= Kinds; i++) starts[i] = 0;
        for (int i = 0; i < count; i++)
        {
            int ahead = i + Prefetch.PairsAhead;
            if (ahead < count && !IsAnswered(ahead)) Prefetch.Objects(ref ShapeB(ahead), ref PoseB(ahead));
            int kind = IsAnswered(i) ? Answered : KindOf(i, ref question);
            kinds[i] = (byte)kind;
            if (kind != Answered) starts[kind + 1]++;
        }

        for (int i = 0; i < Kinds; i++) starts[i + 1] += starts[i];
        int* next = stackalloc int[Kinds];
        for (int i = 0; i < Kinds; i++) next[i] = starts[i];
        for (int i = 0; i < count; i++)
            if (kinds[i] != Answered) byKind[next[kinds[i]]++] = i;
    }

    private bool IsAnswered(int pair) => !Unsafe.IsNullRef(ref _answered) && Unsafe.Add(ref _answered, pair);

    /// <summary>The kind of a pair; one that is not for lanes is answered.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int KindOf<TQuestion>(int pair, ref TQuestion question)
        where TQuestion : struct, IWideQuestion, allows ref struct
    {
        WideRoute route = question.Route(this, pair);
        if (route == WideRoute.Answered) return Answered;
        ref ConvexShape a = ref ShapeA(pair), b = ref ShapeB(pair);
        FormKind kindA = a.Core & ~FormKind.Moved, kindB = b.Core & ~FormKind.Moved;
        if (route != WideRoute.Alone && kindA != 0 && kindB != 0 && !Balls.AreBalls(ref a, ref b))
            return OneKinds * (int)kindA + (int)kindB + CoreKinds * (route - WideRoute.Cold);
        question.SolveAlone(this, pair);
        return Answered;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ReadSizes(
        in ConvexShape a, in ConvexShape b, in ConvexShape c, in ConvexShape d, out WideVector centers,
        out Vector256<double> margins, out Vector256<double> radii)
    {
        centers = WideVector.Of(a.CenterInCore, b.CenterInCore, c.CenterInCore, d.CenterInCore);
        margins = Vector256.Create(a.Margin, b.Margin, c.Margin, d.Margin);
        radii = Vector256.Create(a.RadiusOfCore, b.RadiusOfCore, c.RadiusOfCore, d.RadiusOfCore);
    }
}
#endif
