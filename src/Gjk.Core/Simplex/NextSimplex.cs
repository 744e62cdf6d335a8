namespace Gjk.Core;

/// <summary>Muratori's step ("Implementing GJK", 2006), for the distance and the boolean: given the feature that was
/// nearest the origin and the vertex found beyond it, which vertices make the next one, and what is its
/// normal?</summary>
/// <remarks>
/// <para>A is the newest vertex, as in his drawings. The way GJK grows a simplex saves most of the tests. The old
/// feature was the nearest before and A lies beyond it, so the new one contains A: an edge AB, a face ABC or A alone.
/// And the origin cannot be behind the old face BCD. Tests that he may leave out for the boolean are put back (Ericson
/// 2004, section 5.1), because a distance needs the nearest feature and not just a good direction.</para>
/// <para>Where he winds each triangle away from the origin, the side is kept as a sign (<see
/// cref="FeatureVertices.Winding"/>): no vertex moves, and no branch is taken that no processor could predict.</para>
/// <para>The normal is built from the feature: for a face the cross product of two edges, for an edge a double cross
/// product, for a vertex the vertex itself. A nearly cancelled vector is never used, so near contact the normal stays
/// perpendicular to the feature to the last bits. <see cref="ExtendedFeatureStep"/> is the same step in extended
/// precision.</para>
/// </remarks>
internal static class NextSimplex
{
    /// <summary>Bits of the three faces of a tetrahedron at A.</summary>
    private const int Abc = 1, Acd = 2, Adb = 4;

    /// <summary>The nearest feature of the last one and the newest vertex.</summary>
    /// <param name="simplex">The last feature's vertices, none to three; then the new one's.</param>
    /// <param name="newest">Found beyond it.</param>
    /// <param name="feature">Gets the new feature's normal and height.</param>
    /// <param name="nearest">Whether to compare, where the origin sees several faces of a tetrahedron; otherwise the
    /// first will do.</param>
    /// <returns>False when the origin is inside (or on the hidden side of every face of) the tetrahedron; the vertices
    /// then stay as they were.</returns>
    [MethodImpl(Jit.Step)]
    public static bool TryAdvance(
        ref FeatureVertices simplex, in MinkowskiVertex newest, ref ClosestFeature feature, bool nearest)
    {
        if (simplex.Count == 3)
        {
            if (!TryTakeFace(ref simplex, newest, nearest)) return false;
        }
        else
        {
            simplex.C.Set(simplex.B);
            simplex.B.Set(simplex.A);
        }

        simplex.A.Set(newest);
        if (simplex.Count >= 2) Triangle(ref simplex, ref feature);
        else if (simplex.Count == 1) Line(ref simplex, ref feature);
        else KeepVertex(ref simplex, ref feature);
        return true;
    }

    /// <summary>Keeps the whole vertex, edge or triangle when the origin is beside that, not beside a part of it: for a
    /// simplex that was the nearest feature of a pair before the pair moved.</summary>
    [MethodImpl(Jit.Step)]
    public static bool TryKeepAll(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        double ax = simplex.A.X, ay = simplex.A.Y, az = simplex.A.Z;
        if (simplex.Count == 1)
        {
            KeepVertex(ref simplex, ref feature, ax, ay, az);
            return true;
        }

        double bx = simplex.B.X - ax, by = simplex.B.Y - ay, bz = simplex.B.Z - az;
        if (simplex.Count == 2)
        {
            bool isBeside = bx * ax + by * ay + bz * az < 0
                & bx * simplex.B.X + by * simplex.B.Y + bz * simplex.B.Z > 0;
            if (isBeside) KeepEdge(ref simplex, ref feature, ax, ay, az, bx, by, bz);
            return isBeside;
        }

        double cx = simplex.C.X - ax, cy = simplex.C.Y - ay, cz = simplex.C.Z - az;
        double nx = by * cz - bz * cy, ny = bz * cx - bx * cz, nz = bx * cy - by * cx;
        bool inside = Triple(bx, by, bz, nx, ny, nz, ax, ay, az) > 0
            & Triple(nx, ny, nz, cx, cy, cz, ax, ay, az) > 0
            & Triple(cx - bx, cy - by, cz - bz, nx, ny, nz, simplex.B.X, simplex.B.Y, simplex.B.Z) > 0;
        if (inside) KeepFace(ref simplex, ref feature, ax, ay, az, nx, ny, nz);
        return inside;
    }

    /// <summary>The nearest feature of one to three vertices, of which the first is known to be part of it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Reduce(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        if (simplex.Count == 3) Triangle(ref simplex, ref feature);
        else if (simplex.Count == 2) KeepEdge(ref simplex, ref feature);
        else KeepVertex(ref simplex, ref feature);
    }

    /// <summary>The vertex A alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepVertex(ref FeatureVertices simplex, ref ClosestFeature feature) =>
        KeepVertex(ref simplex, ref feature, simplex.A.X, simplex.A.Y, simplex.A.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepVertex(
        ref FeatureVertices simplex, ref ClosestFeature feature, double ax, double ay, double az)
    {
        simplex.Count = 1;
        Double3.Write(ax, ay, az, out feature.Normal);
        feature.Height = ax * ax + ay * ay + az * az;
        feature.NormalSquared = feature.Height;
    }

    /// <summary>The origin is beside AB, or behind A.</summary>
    [MethodImpl(Jit.Step)]
    private static void Line(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        double ax = simplex.A.X, ay = simplex.A.Y, az = simplex.A.Z;
        double bx = simplex.B.X - ax, by = simplex.B.Y - ay, bz = simplex.B.Z - az;
        if (bx * ax + by * ay + bz * az < 0) KeepEdge(ref simplex, ref feature, ax, ay, az, bx, by, bz);
        else KeepVertex(ref simplex, ref feature, ax, ay, az);
    }

    /// <summary>The origin is above or below ABC, beside AB or AC, or behind A; BC was tested when A was not
    /// there.</summary>
    [MethodImpl(Jit.Step)]
    private static void Triangle(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        double ax = simplex.A.X, ay = simplex.A.Y, az = simplex.A.Z;
        double bx = simplex.B.X - ax, by = simplex.B.Y - ay, bz = simplex.B.Z - az;
        double cx = simplex.C.X - ax, cy = simplex.C.Y - ay, cz = simplex.C.Z - az;
        double nx = by * cz - bz * cy, ny = bz * cx - bx * cz, nz = bx * cy - by * cx;
        bool beyondAB = Triple(bx, by, bz, nx, ny, nz, ax, ay, az) < 0;
        bool beyondAC = Triple(nx, ny, nz, cx, cy, cz, ax, ay, az) < 0;
        if (!(beyondAB | beyondAC))
        {
            KeepFace(ref simplex, ref feature, ax, ay, az, nx, ny, nz);
            return;
        }

        bool besideAB = beyondAB & bx * ax + by * ay + bz * az < 0;
        bool besideAC = beyondAC & cx * ax + cy * ay + cz * az < 0;
        if (!(besideAB | besideAC))
        {
            KeepVertex(ref simplex, ref feature, ax, ay, az);
            return;
        }

        if (!besideAB) simplex.B.Set(simplex.C);
        KeepEdge(ref simplex, ref feature);
    }

    /// <summary>The inside of AB.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepEdge(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        double ax = simplex.A.X, ay = simplex.A.Y, az = simplex.A.Z;
        KeepEdge(ref simplex, ref feature, ax, ay, az, simplex.B.X - ax, simplex.B.Y - ay, simplex.B.Z - az);
    }

    /// <summary>The inside of AB, of which b is ab: (ab × a) × ab is perpendicular to AB to the last bits, however near
    /// the origin is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepEdge(
        ref FeatureVertices simplex, ref ClosestFeature feature, double ax, double ay, double az, double bx, double by,
        double bz)
    {
        simplex.Count = 2;
        double mx = by * az - bz * ay, my = bz * ax - bx * az, mz = bx * ay - by * ax;
        double nx = my * bz - mz * by, ny = mz * bx - mx * bz, nz = mx * by - my * bx;
        Double3.Write(nx, ny, nz, out feature.Normal);
        feature.Height = mx * mx + my * my + mz * mz;
        feature.NormalSquared = nx * nx + ny * ny + nz * nz;
    }

    /// <summary>The inside of ABC, whose normal ab × ac is turned away from the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepFace(
        ref FeatureVertices simplex, ref ClosestFeature feature, double ax, double ay, double az, double nx, double ny,
        double nz)
    {
        simplex.Count = 3;
        double height = nx * ax + ny * ay + nz * az, winding = BranchFree.WithSign(1, height);
        simplex.Winding = winding;
        Double3.Write(nx * winding, ny * winding, nz * winding, out feature.Normal);
        feature.Height = height * winding;
        feature.NormalSquared = nx * nx + ny * ny + nz * nz;
    }

    /// <summary>The face of the tetrahedron that the origin is beyond: its corners other than the newest become B and
    /// C. False when it is beyond none.</summary>
    [MethodImpl(Jit.Step)]
    private static bool TryTakeFace(ref FeatureVertices simplex, in MinkowskiVertex newest, bool nearest)
    {
        double ax = newest.X, ay = newest.Y, az = newest.Z;
        double bx = simplex.A.X - ax, by = simplex.A.Y - ay, bz = simplex.A.Z - az;
        double cx = simplex.B.X - ax, cy = simplex.B.Y - ay, cz = simplex.B.Z - az;
        double dx = simplex.C.X - ax, dy = simplex.C.Y - ay, dz = simplex.C.Z - az;
        double winding = simplex.Winding;
        int faces = (Triple(bx, by, bz, cx, cy, cz, ax, ay, az) * winding > 0 ? Abc : 0)
            | (Triple(cx, cy, cz, dx, dy, dz, ax, ay, az) * winding > 0 ? Acd : 0)
            | (Triple(dx, dy, dz, bx, by, bz, ax, ay, az) * winding > 0 ? Adb : 0);
        if (faces == 0) return false;
        if ((faces & (faces - 1)) != 0)
            faces = nearest ? Nearest(faces, newest, simplex.A, simplex.B, simplex.C) : faces & -faces;
        if (faces == Abc)
        {
            simplex.C.Set(simplex.B);
            simplex.B.Set(simplex.A);
        }
        else if (faces == Adb)
        {
            simplex.B.Set(simplex.C);
            simplex.C.Set(simplex.A);
        }

        return true;
    }

    /// <summary>(b × c) · a in numbers: Mono keeps numbers in registers, and each vector in memory, cleared and
    /// copied.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Triple(
        double bx, double by, double bz, double cx, double cy, double cz, double ax, double ay, double az) =>
        (by * cz - bz * cy) * ax + (bz * cx - bx * cz) * ay + (bx * cy - by * cx) * az;

    /// <summary>Of several faces the one whose own nearest feature is nearest; the first of equals.</summary>
    /// <remarks>The vertices come by value: the caller's are to stay in registers.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Nearest(int faces, MinkowskiVertex a, MinkowskiVertex b, MinkowskiVertex c, MinkowskiVertex d)
    {
        double abc = (faces & Abc) != 0 ? DistanceSquared(a, b, c) : double.PositiveInfinity;
        double acd = (faces & Acd) != 0 ? DistanceSquared(a, c, d) : double.PositiveInfinity;
        double adb = (faces & Adb) != 0 ? DistanceSquared(a, d, b) : double.PositiveInfinity;
        if ((faces & Abc) != 0 && !(acd < abc) && !(adb < abc)) return Abc;
        return (faces & Acd) != 0 && !(adb < acd) ? Acd : Adb;
    }

    private static double DistanceSquared(in MinkowskiVertex a, in MinkowskiVertex b, in MinkowskiVertex c)
    {
        FeatureVertices simplex = default;
        ClosestFeature feature = default;
        simplex.A.Set(a);
        simplex.B.Set(b);
        simplex.C.Set(c);
        Triangle(ref simplex, ref feature);
        return feature.DistanceSquared;
    }
}
