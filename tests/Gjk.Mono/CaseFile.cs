using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Mono;

/// <summary>A hard pair and its proved answer.</summary>
internal sealed class HardCase
{
    public HardCase(
        int indexA, int indexB, string name, PosedMesh a, PosedMesh b, bool overlap, double distance, double depth)
    {
        (IndexA, IndexB, Name, A, B, Overlap, Distance, Depth) = (indexA, indexB, name, a, b, overlap, distance, depth);
        Scale = Math.Max(a.LongestSide, b.LongestSide);
    }

    public int IndexA { get; }

    public int IndexB { get; }

    public string Name { get; }

    public PosedMesh A { get; }

    public PosedMesh B { get; }

    public bool Overlap { get; }

    public double Distance { get; }

    public double Depth { get; }

    public double Scale { get; }
}

/// <summary>A mesh with its pose.</summary>
internal sealed class PosedMesh
{
    public readonly ConvexShape Shape;
    public readonly RigidPose Pose;

    public PosedMesh(in ConvexShape shape, in RigidPose pose) => (Shape, Pose) = (shape, pose);

    public double LongestSide
    {
        get
        {
            Vector3D size = (Vector3D)Shape.Hull!.Bounds.Max - Shape.Hull.Bounds.Min, scale = Shape.Scale;
            return Math.Max(
                Math.Abs(size.X * scale.X), Math.Max(Math.Abs(size.Y * scale.Y), Math.Abs(size.Z * scale.Z)));
        }
    }
}

/// <summary>One family of tests/Cases with its answers.</summary>
internal static class CaseFile
{
    public static readonly string[] Families =
    [
        "parallel", "align", "touch", "deep", "aspect", "large", "degenerate", "dense", "everyday", "offset", "uneven",
    ];

    public static List<HardCase> Read(string directory, string family)
    {
        Dictionary<string, object> scene = Json.ReadObject(File.ReadAllText(Path.Combine(directory, family + ".json")));
        var meshes = ((Dictionary<string, object>)scene["meshes"]).ToDictionary(
            m => m.Key, m => ConvexShape.Mesh(((List<object>)m.Value).ConvertAll(Vector)));
        var read = (List<object>)scene["objects"];
        List<PosedMesh> objects = read.ConvertAll(o => Object((Dictionary<string, object>)o, meshes));
        IEnumerable<string> rows = File.ReadLines(Path.Combine(directory, family + ".expected.csv")).Skip(1);
        return rows.Select(row => Case(row.Split(','), objects, family)).ToList();
    }

    private static PosedMesh Object(Dictionary<string, object> o, Dictionary<string, ConvexShape> meshes)
    {
        var mesh = (string)((Dictionary<string, object>)o["shape"])["mesh"];
        var q = (List<object>)o["rotation"];
        ConvexShape shape = o.TryGetValue("scale", out object scale)
            ? meshes[mesh].Scaled(Vector(scale))
            : meshes[mesh];
        var rotation = new Quaternion(Json.Float(q[0]), Json.Float(q[1]), Json.Float(q[2]), Json.Float(q[3]));
        return new PosedMesh(shape, new RigidPose(rotation, Vector(o["position"])));
    }

    private static Vector3 Vector(object list)
    {
        var v = (List<object>)list;
        return new Vector3(Json.Float(v[0]), Json.Float(v[1]), Json.Float(v[2]));
    }

    private static HardCase Case(string[] cells, List<PosedMesh> objects, string family)
    {
        int a = int.Parse(cells[0], CultureInfo.InvariantCulture);
        int b = int.Parse(cells[1], CultureInfo.InvariantCulture);
        return new HardCase(
            a, b, $"{family} {a},{b} {cells[5]}", objects[a], objects[b],
            bool.Parse(cells[2]), Number(cells[3]), Number(cells[4]));
    }

    private static double Number(string text) => double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);
}
