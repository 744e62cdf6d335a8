using System.Globalization;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A shape of its own type is solved like the same one as a <see cref="ConvexShape"/>, to the last bit: as A
/// and as B, meshes scaled as well. Other shapes multiply a scale in or keep it, and then agree within the accuracy
/// only.</summary>
internal static class TypedShapesGiveTheSameBits
{
    public static string? Broken(FuzzPair pair)
    {
        DistanceResult swapped = ConvexQuery.Distance(pair.B, pair.PoseB, pair.A, pair.PoseA);
        return Problem(pair.A, pair.PoseA, pair.B, pair.PoseB, pair.Answer, "A typed")
            ?? Problem(pair.B, pair.PoseB, pair.A, pair.PoseA, swapped, "B typed and first");
    }

    private static string? Problem(
        in ConvexShape typed, in RigidPose pose, in ConvexShape other, in RigidPose otherPose,
        in DistanceResult expected, string name)
    {
        if (typed.Hull is { } hull)
        {
            var mesh = new ConvexMesh(hull);
            return typed.Scale == Vector3.One
                ? Compare(mesh, pose, other, otherPose, expected, name)
                : Compare(new Scaled<ConvexMesh>(mesh, typed.Scale), pose, other, otherPose, expected, name);
        }

        return typed.Scale == Vector3.One && TryNumbers(typed, out float[] n)
            ? Primitive(typed, n, pose, other, otherPose, expected, name)
            : null;
    }

    private static string? Primitive(
        in ConvexShape typed, float[] n, in RigidPose pose, in ConvexShape other, in RigidPose otherPose,
        in DistanceResult expected, string name)
    {
        switch (typed.Kind)
        {
            case ShapeKind.Point or ShapeKind.Sphere:
                return Compare(new SphereShape(n[0]), pose, other, otherPose, expected, name);
            case ShapeKind.Segment:
                var segment = new SegmentShape(new(n[0], n[1], n[2]), new(n[3], n[4], n[5]));
                return Compare(segment, pose, other, otherPose, expected, name);
            case ShapeKind.Capsule when n[0] == 0 && n[2] == 0 && n[3] == 0 && n[5] == 0 && n[4] == -n[1] && n[1] >= 0:
                return Compare(new CapsuleShape(n[6], n[1]), pose, other, otherPose, expected, name);
            case ShapeKind.Triangle:
                var triangle = new TriangleShape(new(n[0], n[1], n[2]), new(n[3], n[4], n[5]), new(n[6], n[7], n[8]));
                return Compare(triangle, pose, other, otherPose, expected, name);
            case ShapeKind.Box:
                return Compare(new BoxShape(new Vector3(n[0], n[1], n[2])), pose, other, otherPose, expected, name);
            case ShapeKind.Cylinder:
                return Compare(new CylinderShape(n[0], n[1]), pose, other, otherPose, expected, name);
            case ShapeKind.Cone:
                return Compare(new ConeShape(n[0], n[1]), pose, other, otherPose, expected, name);
            case ShapeKind.TaperedCapsule:
                return Compare(new TaperedCapsuleShape(n[0], n[1], n[2]), pose, other, otherPose, expected, name);
            case ShapeKind.Ellipsoid:
                var ellipsoid = new EllipsoidShape(new Vector3(n[0], n[1], n[2]));
                return Compare(ellipsoid, pose, other, otherPose, expected, name);
            default:
                return null;
        }
    }

    private static string? Compare<T>(
        in T typed, in RigidPose pose, in ConvexShape other, in RigidPose otherPose,
        in DistanceResult expected, string name)
        where T : struct, ISupportMap =>
        Same.BitProblem(expected, ConvexQuery.Distance(typed, pose, other, otherPose), name);

    /// <summary>The shape's numbers; false where a scale was multiplied in and they are no floats.</summary>
    private static bool TryNumbers(in ConvexShape shape, out float[] numbers)
    {
        string[] words = [.. ShapeWords.Of(shape).Numbers];
        numbers = Array.ConvertAll(words, w => float.Parse(w, CultureInfo.InvariantCulture));
        for (int i = 0; i < words.Length; i++)
        {
            if (numbers[i] != double.Parse(words[i], CultureInfo.InvariantCulture)) return false;
        }

        return true;
    }
}
