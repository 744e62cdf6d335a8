using System;
using System.Text;

namespace Gjk.Core;

/// <summary>
/// One query as one line of text, and back, to the last bit: what to paste into a bug report or a test when an answer
/// looks wrong.
/// </summary>
/// <remarks>
/// The line is <c>gjk1</c>, then each shape with its pose: a kind with its numbers; for a scaled shape <c>*</c> and
/// three factors, for a rounded one <c>+</c> and the radius, for a placed one <c>&gt;</c>, the rotation (x y z w) and
/// the position, in the order in which they apply; then <c>@</c>, the pose's rotation and position. A mesh is written
/// as its hull's corners. Numbers are in invariant culture and read back as the same bits. Immutable.
/// </remarks>
public readonly struct QueryRecord
{
    private const string Tag = "gjk1";

    /// <summary>Makes a record of a query.</summary>
    public QueryRecord(in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
    {
        A = a;
        PoseA = poseA;
        B = b;
        PoseB = poseB;
    }

    /// <summary>The first shape.</summary>
    public ConvexShape A { get; }

    /// <summary>Where it is.</summary>
    public RigidPose PoseA { get; }

    /// <summary>The second shape.</summary>
    public ConvexShape B { get; }

    /// <summary>Where it is.</summary>
    public RigidPose PoseB { get; }

    /// <summary>Reads a record.</summary>
    /// <exception cref="ArgumentNullException">The text is null.</exception>
    /// <exception cref="FormatException">The text is no record; the message names the word.</exception>
    public static QueryRecord Parse(string text)
    {
        var words = new RecordReader(Guard.NotNull(text, nameof(text)));
        words.Expect(Tag);
        ConvexShape a = ShapeText.Read(words);
        RigidPose poseA = PoseAfterAt(words);
        ConvexShape b = ShapeText.Read(words);
        RigidPose poseB = PoseAfterAt(words);
        words.ExpectEnd();
        return new QueryRecord(a, poseA, b, poseB);
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

    /// <summary>Runs the query.</summary>
    public DistanceResult Distance() => ConvexQuery.Distance(A, PoseA, B, PoseB);

    /// <summary>The line.</summary>
    public override string ToString()
    {
        var text = new StringBuilder(Tag);
        ShapeText.Write(text, A);
        ShapeText.Add(text.Append(" @"), PoseA);
        ShapeText.Write(text, B);
        ShapeText.Add(text.Append(" @"), PoseB);
        return text.ToString();
    }

    private static RigidPose PoseAfterAt(RecordReader words)
    {
        words.Expect("@");
        return ShapeText.ReadPose(words);
    }
}
