# A difference that counts as flat is so thin that half its thickness, which is told for its depth at most, is within
# the promise, 1e-14 of the scale.
# constant: GjkTolerances.Flat = 64 * 2^-53
# code: src/Gjk.Core/Solvers/Depth/PolytopeStart.cs, TryPair and TryAdd
# assumed: as in depth-noise.g
# control: c = 256b-53;
c = 64b-53;
u = 1b-53;

# n . w: products (p), sums (r). What it is off by is k times the terms' magnitudes at most, which add up to |n| |w| at
# most (Cauchy and Schwarz).
t1 = s1 * m1; t2 = s2 * m2; t3 = s3 * m3;
computed = ((t1 * (1 + p1) + t2 * (1 + p2)) * (1 + r1) + t3 * (1 + p3)) * (1 + r2);
exact = t1 + t2 + t3;
magnitude = m1 + m2 + m3;
e1 = (1 + p1) * (1 + r1) * (1 + r2) - 1;
e2 = (1 + p2) * (1 + r1) * (1 + r2) - 1;
e3 = (1 + p3) * (1 + r2) - 1;
k = 30001e-4 * u;

# The promise, 1e-14 of the scale, in pair sizes: a size is at most 1.74 times the scale (GjkTolerances).
promise = 1e-14 / 174e-2;

# The thickness is the difference of two support values along a direction of unit length (n, as in depth-noise.g),
# rounded once (g).
reach = 2;
length = 1 + 5 * n;
half = (c * (1 + g) * length + (k * reach + k * reach) * length) / 2;
{ m1 in [0, 3] /\ m2 in [0, 3] /\ m3 in [0, 3] /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53
  /\ |p3| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |g| <= 1b-53 /\ n in [0, 1b-53]
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ promise - half >= 0 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k - s2 * e2) + m3 * (k - s3 * e3);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k + s2 * e2) + m3 * (k + s3 * e3);
