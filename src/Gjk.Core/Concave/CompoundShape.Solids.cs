namespace Gjk.Core;

// A solid's inside is in none of its triangles, so a compound keeps each of its solids besides the parts.
public sealed partial class CompoundShape
{
    private static readonly Vector3 s_unscaled = Vector3.One;

    /// <summary>The numbers that the parts of a unit have in the compound.</summary>
    internal readonly int[] Numbers = [];

    /// <summary>A unit of a compound.</summary>
    private CompoundShape(CompoundShape whole, int[] numbers, SolidInside? inside, PartTree? like)
    {
        (_firsts, _poses, Numbers) = ([0, numbers.Length], [RigidPose.Identity], numbers);
        _parts = Array.ConvertAll(numbers, i => whole._parts[i]);
        Boxes = Array.ConvertAll(numbers, i => whole.Boxes[i]);
        Tree = BuildTree(like);
        Insides = inside is null ? [] : [new SolidInside(inside, 0, RigidPose.Identity, s_unscaled)];
        Units = inside is null ? [] : [this];
    }

    /// <summary>The insides of its solids, in the order of the parts.</summary>
    internal SolidInside[] Insides { get; }

    /// <summary>Each solid as a compound of its own, and then all else as another one; of one solid alone the compound
    /// itself; nothing without solids.</summary>
    internal CompoundShape[] Units { get; }

    /// <summary>Volume, mass, centre of mass and inertia: the sum of the convex parts and the solids, so that what lies
    /// in two of them counts twice.</summary>
    /// <param name="density">Mass in a unit of volume, of all parts; at least 0 and finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The density is negative, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">A part has none; see
    /// <see cref="ConvexShape.GetMassProperties"/>.</exception>
    public MassProperties GetMassProperties(float density = 1)
    {
        Guard.NonNegative(density, nameof(density));
        MassProperties? all = null;
        int next = 0;
        for (int part = 0; part < _parts.Length;)
        {
            bool isSolid = next < Insides.Length && part == Insides[next].First;
            MassProperties one = isSolid
                ? MassOf(Insides[next]).Times(density)
                : _parts[part].GetMassProperties(density);
            all = all is { } others ? others + one : one;
            part = isSolid ? Insides[next++].End : part + 1;
        }

        return all!.Value;
    }

    private MassProperties MassOf(SolidInside inside)
    {
        var sum = new TetrahedronSum(_parts[inside.First].Center);
        for (int part = inside.First; part < inside.End; part++)
        {
            GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
            if (inside.OutwardOf(part) > 0) sum.Add(a, b, c);
            else sum.Add(a, c, b);
        }

        return sum.ToMass();
    }

    /// <summary>The corners of a triangle.</summary>
    internal void GetCorners(int part, out Double3 a, out Double3 b, out Double3 c)
    {
        ref readonly ConvexShape shape = ref _parts[part];
        shape.TryGetVertex(0, out a);
        shape.TryGetVertex(1, out b);
        shape.TryGetVertex(2, out c);
        (a, b, c) = (shape.Center + a, shape.Center + b, shape.Center + c);
    }

    private SolidInside[] InsidesOf(CompoundPart[] children)
    {
        var insides = new List<SolidInside>();
        for (int i = 0; i < children.Length; i++)
        {
            foreach (SolidInside inside in children[i].Shape.Insides)
            {
                // What becomes of a height field does not change its parts here.
                SolidInside kept = inside.Mesh.HeightField is not null && children[i].Shape.Mesh is { } field
                    ? field.Scaled(s_unscaled).Insides[0]
                    : inside;
                insides.Add(new SolidInside(kept, _firsts[i] + inside.First, _poses[i], s_unscaled));
            }
        }

        return [.. insides];
    }

    /// <summary>The units, with the trees of another compound's where that is given.</summary>
    private CompoundShape[] MakeUnits(CompoundShape? like)
    {
        if (Insides.Length == 0) return [];
        if (Insides.Length == 1 && Insides[0].Mesh.TriangleCount == PartCount) return [this];
        var units = new List<CompoundShape>();
        var others = new List<int>();
        int next = 0;
        foreach (SolidInside inside in Insides)
        {
            for (; next < inside.First; next++) others.Add(next);
            var own = new int[inside.End - inside.First];
            for (int i = 0; i < own.Length; i++) own[i] = next++;
            units.Add(new CompoundShape(this, own, inside, like?.Units[units.Count].Tree));
        }

        for (; next < PartCount; next++) others.Add(next);
        if (others.Count > 0)
            units.Add(new CompoundShape(this, [.. others], null, like?.Units[units.Count].Tree));
        return [.. units];
    }
}
