using System.Globalization;
using System.Text.Json;

namespace Gjk.Core.Tests.Support;

/// <summary>A cast and its proved answer: B moves by the velocity over the fractions from 0 to 1.</summary>
internal sealed record CastCase(
    TestPair Pair, Vector3 Velocity, CastStatus Outcome, double Fraction, Double3 Normal, bool IsNormalUnique)
{
    public CastResult Cast() =>
        ConvexQuery.Cast(Pair.A.Shape, Pair.PoseA, default, Pair.B.Shape, Pair.PoseB, Velocity);

    /// <summary>The same asked as a ray that reaches as far; B is a point.</summary>
    public RayCastResult Ray() =>
        ConvexQuery.RayCast(Pair.A.Shape, Pair.PoseA, Pair.PoseB.Position, Velocity, Velocity.Length());
}

/// <summary>The casts of tests/Cases with their answers.</summary>
internal static class CastFamily
{
    private const string Header = "a,b,outcome,fraction,nx,ny,nz,ties,case";

    private const string PlainHeader = "a,b,outcome,fraction,tolerance,case";

    public static IEnumerable<string> Names =>
    [
        "cast_box", "cast_graze", "cast_hull32", "cast_hull8", "cast_inside", "cast_miss", "cast_ray", "cast_round",
        "cast_slide", "cast_speed", "cast_thin",
    ];

    /// <summary>Points against hulls that are flat but for rounding: no normals, and fractions to 3e-6.</summary>
    public const string Flat = "cast_flat";

    public static IReadOnlyList<CastCase> Load(string name)
    {
        using var scene = JsonDocument.Parse(CaseFamily.Read($"{name}.json"));
        (TestShape Shape, RigidPose Pose)[] objects = CaseFamily.Objects(scene.RootElement);
        Vector3[] velocities =
        [
            .. scene.RootElement.GetProperty("objects").EnumerateArray().Select(
                o => o.TryGetProperty("velocity", out JsonElement v) ? CaseFamily.Vector(v) : default),
        ];
        string[] rows = CaseFamily.Read($"{name}.expected.csv").Split('\n', StringSplitOptions.RemoveEmptyEntries);
        if (rows[0].Trim() != (name == Flat ? PlainHeader : Header))
            throw new InvalidDataException($"{name}: unexpected header '{rows[0]}'.");
        return [.. rows.Skip(1).Select(row => Case(name, row.Trim().Split(','), objects, velocities))];
    }

    private static CastCase Case(
        string name, string[] cells, (TestShape Shape, RigidPose Pose)[] objects, Vector3[] velocities)
    {
        int a = int.Parse(cells[0], CultureInfo.InvariantCulture);
        int b = int.Parse(cells[1], CultureInfo.InvariantCulture);
        Assert.Equal(default, velocities[a]);
        CastStatus outcome = cells[2] switch
        {
            "hit" => CastStatus.Hit,
            "miss" => CastStatus.Miss,
            "overlapping_at_start" => CastStatus.OverlappingAtStart,
            _ => throw new InvalidDataException($"{name}: unknown outcome '{cells[2]}'."),
        };
        bool isHit = outcome == CastStatus.Hit, hasNormal = isHit && name != Flat;
        var pair = new TestPair(
            $"{name} {a},{b} {cells[^1]}", objects[a].Shape, objects[a].Pose, objects[b].Shape, objects[b].Pose);
        return new CastCase(
            pair, velocities[b], outcome, isHit ? CaseFamily.Number(cells[3]) : 0,
            hasNormal ? new(CaseFamily.Number(cells[4]), CaseFamily.Number(cells[5]), CaseFamily.Number(cells[6]))
                : default,
            hasNormal && cells[7] == "1");
    }
}
