# Two bounds of a depth that count as met differ by less than the promise, 1e-14 of the scale, with what rounding does
# to either.
# constant: GjkTolerances.DepthNoise = 16 * 2^-53
# code: src/Gjk.Core/Solvers/Depth/GjkDepth.cs, Expand; Simplex/Polytope.Faces.cs, TrySetFace and Offsets
# assumed: the vertices as given; the pair's size is 1, since nothing here knows a scale. Shapes that overlap have
#   centres a size apart at most, so the vertices are no further from the origin than 2, and the depth is 1 at most
# control: c = 64b-53;
c = 16b-53;
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

# A product with the normal n, of any length, is divided by |n|, which leaves 6 roundings (n): 3 in the squared length
# count half, then a root, a quotient and a product. So a length of 1 stands for it here. It is as much in either bound
# as the depth is long; the gap is rounded once (g).
reach = 2;
length = 1 + 5 * n;
gap = c * (1 + g) + (k * reach + k * reach) * length + (length - 1) * 1;
{ m1 in [0, 3] /\ m2 in [0, 3] /\ m3 in [0, 3] /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53
  /\ |p3| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |g| <= 1b-53 /\ n in [0, 1b-53]
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ promise - gap >= 0 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k - s2 * e2) + m3 * (k - s3 * e3);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k + s2 * e2) + m3 * (k + s3 * e3);
