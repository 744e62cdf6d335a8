namespace Gjk.Core;

/// <summary>A triangle of a hull, as a shape scales it: wound so that its normal points outward.</summary>
internal struct HullFacet
{
    /// <summary>Squared sine of the angle between two edges: a thinner triangle's normal is computed in 106 bits. Above
    /// it, double turns a normal by less than 1e-13, and a height by less than that times the size. Four times more or
    /// less only moves triangles from one to the other.</summary>
    private const double Thin = 1e-4;

    /// <summary>Ratio to a height: more than that. A facet that is higher than asked by less is looked at in
    /// vain.</summary>
    public const double Slack = 1e-11;

    /// <summary>Squared ratio of lengths: a triangle that is thinner than that part of its distance from the shape's
    /// centre is none. Its normal is the rounding of its corners, 1e-16, and may point anywhere; without it the depth
    /// changes by no more. Four times more or less only moves triangles between the two. Pinned by
    /// HullDepthTests.</summary>
    private const double Line = 1e-24;

    /// <summary>The corners, measured from the shape's centre.</summary>
    public Double3 P, Q, R;

    /// <summary>Outward, of any length.</summary>
    public Double3 Normal;

    /// <summary>The corners' ids.</summary>
    public int IdP, IdQ, IdR;

    /// <summary>Whether its corners are on a line, but for rounding.</summary>
    public readonly bool HasNoArea =>
        !(Normal.LengthSquared > LineSquared * Math.Max((Q - P).LengthSquared, (R - P).LengthSquared));

    /// <summary>A square of a length: of what a corner's distance from a line has to be more than.</summary>
    public readonly double LineSquared => Line * Math.Max(P.LengthSquared, (Q - P).LengthSquared);

    /// <summary>Reads a triangle of a shape that is a hull.</summary>
    public static void Get<T>(ref T shape, in BodyForm form, int index, out HullFacet facet)
        where T : struct, ISupportMap
    {
        int[] triangles = form.Hull!.Triangles;
        facet.IdP = triangles[3 * index];
        facet.IdQ = triangles[3 * index + (form.IsMirrored ? 2 : 1)];
        facet.IdR = triangles[3 * index + (form.IsMirrored ? 1 : 2)];
        shape.TryGetVertex(facet.IdP, out facet.P);
        shape.TryGetVertex(facet.IdQ, out facet.Q);
        shape.TryGetVertex(facet.IdR, out facet.R);
        Double3 e = facet.Q - facet.P, f = facet.R - facet.P;
        facet.Normal = Double3.Cross(e, f);
        if (facet.Normal.LengthSquared > Thin * (e.LengthSquared * f.LengthSquared)) return;
        facet.Normal = VectorDD.Normal(facet.P, facet.Q, facet.R);
    }

    /// <summary>Whether its plane is certainly as high as that, measured from a point along the normal.</summary>
    public readonly bool IsAbove(in Double3 point, double height)
    {
        double over = Double3.Dot(Normal, P - point);
        return height > 0 && over > 0 && over * over >= height * height * (1 + 2 * Slack) * Normal.LengthSquared;
    }

    /// <summary>Makes the second corner the first.</summary>
    public void Turn()
    {
        (P, Q, R) = (Q, R, P);
        (IdP, IdQ, IdR) = (IdQ, IdR, IdP);
    }
}
