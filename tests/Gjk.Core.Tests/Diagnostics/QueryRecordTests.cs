namespace Gjk.Core.Tests.Diagnostics;

/// <summary>A query as one line of text comes back to the last bit, and what is no record is refused with a message
/// that names the word.</summary>
public class QueryRecordTests
{
    private const string Sphere = "gjk1 point 1 @ 0 0 0 1 0 0 0 point 0.5 @ 0 0 0 1 3 0 0";

    private static readonly string[] Kinds = [.. Generators.AllKinds, "bigHull"];

    [Fact]
    public void TheFormIsAsDocumented()
    {
        var a = ConvexShape.Sphere(1);
        var b = ConvexShape.Cylinder(0.5f, 2).Scaled(new Vector3(1, 2, -0.25f));
        var record = new QueryRecord(a, RigidPose.Identity, b, new RigidPose(new Vector3(3, -0f, 1e-45f)));
        Assert.Equal(
            "gjk1 point 1 @ 0 0 0 1 0 0 0 cylinder 0.5 2 0 * 1 2 -0.25 @ 0 0 0 1 3 -0 1.40129846E-45",
            record.ToString());
    }

    [Fact]
    public void TheResultIsThatOfTheQuery()
    {
        QueryRecord record = QueryRecord.Parse(Sphere);
        Assert.Equal(1.5f, record.Distance().Distance);
        Assert.Equal(ShapeKind.Sphere, record.A.Kind);
        Assert.Equal(0.5, record.B.Margin);
        Assert.Equal(new Vector3(3, 0, 0), record.PoseB.Position);
        Assert.Equal(RigidPose.Identity, record.PoseA);
    }

    /// <summary>A motion stands behind the pose of its shape; a shape at rest has none.</summary>
    [Fact]
    public void MotionsComeBackAndAreCast()
    {
        const string Moving = "gjk1 point 1 @ 0 0 0 1 0 0 0 point 0.5 @ 0 0 0 1 3 0 0 ~ -3 0 0 0 0.100000001 1E-45";
        QueryRecord record = QueryRecord.Parse(Moving);
        Assert.Equal(Moving.Replace("1E-45", "1.40129846E-45"), record.ToString());
        Assert.Equal((Vector3.Zero, Vector3.Zero), (record.MotionA.Velocity, record.MotionA.AngularVelocity));
        Assert.Equal(new Vector3(-3, 0, 0), record.MotionB.Velocity);
        Assert.Equal(new Vector3(0, 0.1f, float.Epsilon), record.MotionB.AngularVelocity);
        Assert.Equal((CastStatus.Hit, 0.5f), (record.Cast().Status, record.Cast().Fraction));

        var both = new QueryRecord(
            record.A, new RigidMotion(record.PoseA, new Vector3(1, -2, 1e-38f)), record.B, record.MotionB);
        QueryRecord back = QueryRecord.Parse(both.ToString());
        Assert.Equal(both.ToString(), back.ToString());
        Assert.Equal(both.MotionA.Velocity, back.MotionA.Velocity);
        Assert.Equal(Sphere, new QueryRecord(record.A, record.PoseA, record.B, record.PoseB).ToString());
    }

    [Fact]
    public void WhiteSpaceOfAnyKindSeparates() =>
        Assert.Equal(Sphere, QueryRecord.Parse("  " + Sphere.Replace(" ", "\t \r\n") + "\n").ToString());

    [Fact]
    public void EveryKindComesBackToTheLastBit()
    {
        foreach (string kind in Kinds)
        {
            for (ulong seed = 0; seed < (ulong)Budget.Count(20); seed++)
            {
                TestPair pair = Generators.Pair(seed, [kind, "scaledHull", "scaledCapsule"]);
                AssertRoundTrip($"{kind}, seed {seed}", pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB);
            }
        }
    }

    /// <summary>The product of two floats has 48 bits: it is no float, and nine digits would lose it.</summary>
    [Fact]
    public void NumbersThatAScaleWasMultipliedIntoComeBack()
    {
        var odd = new Vector3(0.1f, 1.1f, -2.3f);
        ConvexShape[] shapes =
        [
            ConvexShape.Box(new Vector3(0.1f, 0.7f, 1.3f)).Scaled(odd),
            ConvexShape.Segment(new Vector3(0.1f), new Vector3(-0.7f)).Scaled(odd),
            ConvexShape.Triangle(new Vector3(0.1f), odd, Vector3.UnitX).Scaled(odd),
            ConvexShape.Ellipsoid(new Vector3(0.1f, 0.7f, 1.3f)).Scaled(odd),
            ConvexShape.Sphere(0.1f).Scaled(new Vector3(-1.1f)),
            ConvexShape.Sphere(0.1f).Scaled(odd),
            ConvexShape.Capsule(0.1f, 0.7f).Scaled(new Vector3(1.1f)),
            ConvexShape.Capsule(0.1f, 0.7f).Scaled(odd),
            ConvexShape.Cylinder(0.1f, 0.7f).Scaled(odd),
            ConvexShape.Cone(0.1f, 0.7f).Scaled(odd),
            ConvexShape.Point().Scaled(odd),
        ];
        Assert.NotEqual(shapes[0].Parts.A.X, (float)shapes[0].Parts.A.X);
        foreach (ConvexShape shape in shapes)
            AssertRoundTrip(shape.Kind.ToString(), shape, RigidPose.Identity, shape, new RigidPose(odd));
    }

    [Fact]
    public void TheLeastAndTheGreatestNumbersComeBack()
    {
        Vector3[] corners =
        [
            new(float.MaxValue, float.Epsilon, -0f), new(-1e-38f, 1e-45f, 16_777_217f),
            new(0.1f, 1f / 3, -float.MaxValue),
        ];
        ConvexShape mesh = ConvexShape.Mesh(corners);
        var pose = new RigidPose(
            new Quaternion(1e-45f, -0f, 1f / 3, 0.94280905f), new Vector3(float.MaxValue, -float.Epsilon, -0f));
        AssertRoundTrip("mesh", mesh, pose, ConvexShape.Segment(corners[0], corners[2]), pose);
        AssertRoundTrip(
            "scaled", mesh.Scaled(new Vector3(float.Epsilon, -float.MaxValue, 1)), pose,
            ConvexShape.Sphere(float.MaxValue).Scaled(new Vector3(float.MaxValue)), pose);
    }

    [Theory]
    [InlineData("", "The record ends where 'gjk1' should be.")]
    [InlineData(" \n", "The record ends where 'gjk1' should be.")]
    [InlineData("gjk2 point 1", "Word 1, 'gjk2', should be 'gjk1'.")]
    [InlineData("gjk1", "The record ends where a shape should be.")]
    [InlineData("gjk1 ball 1", "Word 2, 'ball', is no shape.")]
    [InlineData("gjk1 none 0 0 0", "Word 2, 'none', is no shape.")]
    [InlineData("gjk1 Point 1", "Word 2, 'Point', is no shape.")]
    [InlineData("gjk1 point", "The record ends where a number should be.")]
    [InlineData("gjk1 point x", "Word 3, 'x', should be a finite number.")]
    [InlineData("gjk1 point 1,5", "Word 3, '1,5', should be a finite number.")]
    [InlineData("gjk1 point NaN", "Word 3, 'NaN', should be a finite number.")]
    [InlineData("gjk1 point Infinity", "Word 3, 'Infinity', should be a finite number.")]
    [InlineData("gjk1 point 1e400", "Word 3, '1e400', should be a finite number.")]
    [InlineData("gjk1 point -1 @", "Word 3, '-1', should not be negative.")]
    [InlineData("gjk1 segment 0 0 0 1 1 1 -1 @", "Word 9, '-1', should not be negative.")]
    [InlineData("gjk1 box 1 1 -1 @", "Word 5, '-1', ends a shape with a negative size.")]
    [InlineData("gjk1 cone -1 1 0 @", "Word 5, '0', ends a shape with a negative size.")]
    [InlineData("gjk1 mesh 0 @", "Word 3, '0', should be the number of points that follow.")]
    [InlineData("gjk1 mesh -1 @", "Word 3, '-1', should be the number of points that follow.")]
    [InlineData("gjk1 mesh 2147483647 1 1 1", "Word 3, '2147483647', should be the number of points that follow.")]
    [InlineData("gjk1 mesh 1 1 1 1e39 @", "Word 6, '1e39', should be a finite number.")]
    [InlineData("gjk1 point 1 * 1 0 1 @", "Word 7, '1', ends a scale with a factor of 0.")]
    [InlineData("gjk1 point 1 0 0 0 1", "Word 4, '0', should be '@'.")]
    [InlineData("gjk1 point 1 @ 0 0 0 1e39 0 0 0", "Word 8, '1e39', should be a finite number.")]
    [InlineData("gjk1 point 1 @ 0 0 0 1 0 0", "The record ends where a number should be.")]
    [InlineData(Sphere + " ~ 1 2 3", "The record ends where a number should be.")]
    [InlineData(Sphere + " ~ 1 2 3 0 0 NaN", "Word 28, 'NaN', should be a finite number.")]
    [InlineData("gjk1 point 1 @ 0 0 0 1 0 0 0 ~ 1 0 0", "The record ends where a number should be.")]
    [InlineData(Sphere + " 1", "Word 22, '1', comes after the end of the record.")]
    public void WhatIsNoRecordIsRefused(string text, string message)
    {
        Assert.Equal(message, Assert.Throws<FormatException>(() => QueryRecord.Parse(text)).Message);
        Assert.False(QueryRecord.TryParse(text, out QueryRecord record, out string? reason));
        Assert.Equal(message, reason);
        Assert.Equal(ShapeKind.None, record.A.Kind);
    }

    [Fact]
    public void WhatAConstructorRefusesIsAFaultOfTheText()
    {
        string reason = Reason("gjk1 point 1 @ 0 0 0 2 0 0 0 point 1 @ 0 0 0 1 0 0 0");
        Assert.StartsWith("Before word 12: The quaternion's length must be within 1e-3 of 1.", reason);
    }

    [Fact]
    public void NullIsRefused()
    {
        Assert.Equal("text", Assert.Throws<ArgumentNullException>(() => QueryRecord.Parse(null!)).ParamName);
        Assert.Equal("The record ends where 'gjk1' should be.", Reason(null));
    }

    /// <summary>Each record cut off after each of its words is refused, and none of them throws anything
    /// else.</summary>
    [Fact]
    public void NoPartOfARecordIsARecord()
    {
        foreach (string kind in Kinds)
        {
            TestPair pair = Generators.Pair(7, [kind]);
            string[] words = new QueryRecord(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB).ToString().Split(' ');
            for (int i = 0; i < words.Length; i += 1 + words.Length / 40) Reason(string.Join(' ', words.Take(i)));
        }
    }

    private static string Reason(string? text)
    {
        Assert.False(QueryRecord.TryParse(text, out _, out string? reason), text);
        return reason!;
    }

    private static void AssertRoundTrip(
        string name, in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
    {
        var record = new QueryRecord(a, poseA, b, poseB);
        string text = record.ToString();
        Assert.DoesNotContain('\n', text);
        Assert.True(QueryRecord.TryParse(text, out QueryRecord back, out string? reason), $"{name}: {reason}");
        Assert.Equal(text, back.ToString());
        AssertSame(name, a, back.A);
        AssertSame(name, b, back.B);
        AssertSame(name, poseA, back.PoseA);
        AssertSame(name, poseB, back.PoseB);
        Assert.Equal(ResultBits.Of(record.Distance()), ResultBits.Of(back.Distance()));
    }

    private static void AssertSame(string name, in ConvexShape expected, in ConvexShape actual)
    {
        Assert.Equal(expected.Kind, actual.Kind);
        Assert.Equal(Bits(expected), Bits(actual));
        Assert.Equal(expected.Hull?.VertexCount, actual.Hull?.VertexCount);
        for (int i = 0; i < (expected.Hull?.VertexCount ?? 0); i++)
            Assert.True(expected.Hull!.GetVertex(i) == actual.Hull!.GetVertex(i), $"{name}: vertex {i}");
    }

    private static long[] Bits(in ConvexShape shape)
    {
        ShapeParts p = shape.Parts;
        double[] numbers =
        [
            p.A.X, p.A.Y, p.A.Z, p.B.X, p.B.Y, p.B.Z, p.C.X, p.C.Y, p.C.Z, p.Scale.X, p.Scale.Y, p.Scale.Z,
            p.InnerMargin, shape.Margin, shape.BoundingRadius,
        ];

        // Fields that the kind does not use may hold -0; those that it does are held to it by the text.
        return Array.ConvertAll(numbers, x => BitConverter.DoubleToInt64Bits(x == 0 ? 0 : x));
    }

    private static void AssertSame(string name, in RigidPose expected, in RigidPose actual)
    {
        Quaternion q = expected.Rotation, r = actual.Rotation;
        float[] a = [q.X, q.Y, q.Z, q.W, expected.Position.X, expected.Position.Y, expected.Position.Z];
        float[] b = [r.X, r.Y, r.Z, r.W, actual.Position.X, actual.Position.Y, actual.Position.Z];
        Assert.True(
            a.Select(BitConverter.SingleToInt32Bits).SequenceEqual(b.Select(BitConverter.SingleToInt32Bits)),
            $"{name}: pose");
    }
}
