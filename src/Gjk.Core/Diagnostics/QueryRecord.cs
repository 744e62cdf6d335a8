using System;
using System.Globalization;
using System.Text;

namespace Gjk.Core;

/// <summary>
/// One query as one line of text, and back, to the last bit: what to paste into a bug report or a test when an answer looks wrong.
/// </summary>
/// <remarks>
/// The line is <c>gjk1</c>, then each shape with its pose: a kind with its numbers, for a scaled shape <c>*</c> and three factors, then <c>@</c>, the rotation
/// (x y z w) and the position. A mesh is written as its hull's corners. Numbers are in invariant culture and read back as the same bits. Immutable.
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
        RigidPose poseA = ReadPose(words);
        ConvexShape b = ShapeText.Read(words);
        RigidPose poseB = ReadPose(words);
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
        WritePose(text, PoseA);
        ShapeText.Write(text, B);
        WritePose(text, PoseB);
        return text.ToString();
    }

    private static void WritePose(StringBuilder text, in RigidPose pose)
    {
        text.Append(" @");
        foreach (float number in new[] { pose.Rotation.X, pose.Rotation.Y, pose.Rotation.Z, pose.Rotation.W, pose.Position.X, pose.Position.Y, pose.Position.Z })
            text.Append(' ').Append(number.ToString("G9", CultureInfo.InvariantCulture));
    }

    private static RigidPose ReadPose(RecordReader words)
    {
        words.Expect("@");
        var rotation = new System.Numerics.Quaternion(words.Float(), words.Float(), words.Float(), words.Float());
        var position = new System.Numerics.Vector3(words.Float(), words.Float(), words.Float());
        return words.Build(() => new RigidPose(rotation, position));
    }
}
