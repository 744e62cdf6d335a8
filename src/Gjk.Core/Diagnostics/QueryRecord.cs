using System.Text;

namespace Gjk.Core.Diagnostics;

/// <summary>One query as one line of text, and back, to the last bit: what to paste into a bug report or a test when an
/// answer looks wrong.</summary>
/// <remarks>The line is <c>gjk1</c>, then each shape with its pose: a kind with its numbers; for a scaled shape
/// <c>*</c> and three factors, for a rounded one <c>+</c> and the radius, for a placed one <c>&gt;</c>, the rotation (x
/// y z w) and the position, in the order in which they apply; then <c>@</c>, the pose's rotation and position; then,
/// for a shape that moves, <c>~</c>, its velocity and its angular velocity. A mesh is written as its hull's corners.
/// Numbers are in invariant culture and read back as the same bits. Immutable.</remarks>
public readonly struct QueryRecord
{
    private const string Tag = "gjk1";

    /// <summary>Makes a record of a query of two shapes at rest.</summary>
    public QueryRecord(in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
        : this(a, new RigidMotion(poseA, default), b, new RigidMotion(poseB, default))
    {
    }

    /// <summary>Makes a record of a query of two shapes that move.</summary>
    public QueryRecord(in ConvexShape a, in RigidMotion motionA, in ConvexShape b, in RigidMotion motionB)
    {
        A = a;
        MotionA = motionA;
        B = b;
        MotionB = motionB;
    }

    /// <summary>The first shape.</summary>
    public ConvexShape A { get; }

    /// <summary>Pose of A in the world; where it moves, at the start.</summary>
    public RigidPose PoseA => MotionA.Pose;

    /// <summary>Where it begins and how it moves.</summary>
    public RigidMotion MotionA { get; }

    /// <summary>The second shape.</summary>
    public ConvexShape B { get; }

    /// <summary>Pose of B in the world; where it moves, at the start.</summary>
    public RigidPose PoseB => MotionB.Pose;

    /// <summary>Where it begins and how it moves.</summary>
    public RigidMotion MotionB { get; }

    /// <summary>Reads a record.</summary>
    /// <exception cref="ArgumentNullException">The text is null.</exception>
    /// <exception cref="FormatException">The text is no record; the message names the word.</exception>
    public static QueryRecord Parse(string text)
    {
        var words = new RecordReader(Guard.NotNull(text, nameof(text)));
        words.Expect(Tag);
        ConvexShape a = ShapeText.Read(words);
        RigidMotion motionA = MotionAfterAt(words);
        ConvexShape b = ShapeText.Read(words);
        RigidMotion motionB = MotionAfterAt(words);
        words.ExpectEnd();
        return new QueryRecord(a, motionA, b, motionB);
    }

    /// <summary>Reads a record, or says why it cannot.</summary>
    /// <param name="text">The text.</param>
    /// <param name="record">The record, or <c>default</c>.</param>
    /// <param name="reason">Null, or what is wrong with the text.</param>
    /// <returns>True when the text is a record.</returns>
    public static bool TryParse(string? text, out QueryRecord record, out string? reason)
    {
        try
        {
            record = Parse(text ?? "");
            reason = null;
            return true;
        }
        catch (FormatException exception)
        {
            record = default;
            reason = exception.Message;
            return false;
        }
    }

    /// <summary>Runs the query of the distance, where the shapes begin.</summary>
    public DistanceResult Distance() => ConvexQuery.Distance(A, PoseA, B, PoseB);

    /// <summary>Runs the query of a cast by the velocities alone: nothing turns.</summary>
    public CastResult Cast() => ConvexQuery.Cast(A, PoseA, MotionA.Velocity, B, PoseB, MotionB.Velocity);

    /// <summary>The line.</summary>
    public override string ToString()
    {
        var text = new StringBuilder(Tag);
        ShapeText.Write(text, A);
        Add(text, MotionA);
        ShapeText.Write(text, B);
        Add(text, MotionB);
        return text.ToString();
    }

    private static void Add(StringBuilder text, in RigidMotion motion)
    {
        ShapeText.Add(text.Append(" @"), motion.Pose);
        if (motion.Velocity == default && motion.AngularVelocity == default) return;
        text.Append(" ~");
        ShapeText.Add(text, motion.Velocity);
        ShapeText.Add(text, motion.AngularVelocity);
    }

    private static RigidMotion MotionAfterAt(RecordReader words)
    {
        words.Expect("@");
        RigidPose pose = ShapeText.ReadPose(words);
        if (words.Peek != "~") return new RigidMotion(pose, default);
        words.Expect("~");
        var velocity = new Vector3(words.Float(), words.Float(), words.Float());
        return new RigidMotion(pose, velocity, new Vector3(words.Float(), words.Float(), words.Float()));
    }
}
