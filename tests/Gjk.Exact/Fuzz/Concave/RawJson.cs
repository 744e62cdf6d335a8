using System.Globalization;
using System.Text;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>A pair as a scene file in one line: the numbers that its shapes are made of.</summary>
internal static class RawJson
{
    public static string Of(ConcavePair pair)
    {
        var meshes = new List<string>();
        string a = Object(pair.RawA, pair.PoseA, pair.Motion.A, "a", meshes);
        string b = Object(pair.RawB, pair.PoseB, pair.Motion.B, "b", meshes);
        return $"{{\"version\":1,\"meshes\":{{{string.Join(',', meshes)}}},\"objects\":[{a},{b}]}}";
    }

    public static string Number(float x) => (x + 0f).ToString("R", CultureInfo.InvariantCulture);

    public static string Of(Vector3 v) => $"[{Number(v.X)},{Number(v.Y)},{Number(v.Z)}]";

    private static string Object(
        RawShape shape, in RigidPose pose, Vector3 velocity, string name, List<string> meshes) =>
        $"{{\"shape\":{Shape(shape, name, meshes)},{Pose(pose)},\"scale\":{Of(shape.Scale)},"
            + $"\"velocity\":{Of(velocity)}}}";

    private static string Shape(RawShape shape, string name, List<string> meshes)
    {
        if (shape.Triangles is { } triangles)
        {
            var corners = new StringBuilder();
            for (int i = 0; i < triangles.Indices.Length; i += 3)
                corners.Append(Say.Line(
                    $",[{triangles.Indices[i]},{triangles.Indices[i + 1]},{triangles.Indices[i + 2]}]"));
            string list = corners.ToString(1, corners.Length - 1);
            meshes.Add($"\"{name}\":{{\"vertices\":{Points(triangles.Points)},\"triangles\":[{list}]}}");
            return $"{{\"type\":\"surface\",\"mesh\":\"{name}\"{(shape.IsSolid ? ",\"solid\":true" : "")}}}";
        }

        string[] parts = [.. shape.Parts.Select((part, i) =>
        {
            string own = Say.Line($"{name}{i}");
            if (part.Kind == ShapeKind.Mesh) meshes.Add($"\"{own}\":{Points(part.Sizes)}");
            return part.Json(own);
        })];
        if (shape.IsConvex) return parts[0];
        IEnumerable<string> placed = parts.Select((p, i) => $"{{\"shape\":{p},{Pose(shape.Parts[i].Pose)}}}");
        return $"{{\"type\":\"compound\",\"parts\":[{string.Join(',', placed)}]}}";
    }

    private static string Points(Vector3[] points) => $"[{string.Join(',', points.Select(Of))}]";

    private static string Pose(in RigidPose pose)
    {
        Quaternion q = pose.Rotation;
        return $"\"position\":{Of(pose.Position)},"
            + $"\"rotation\":[{Number(q.X)},{Number(q.Y)},{Number(q.Z)},{Number(q.W)}]";
    }
}
