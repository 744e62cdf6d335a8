# Where the boolean solver calls shapes apart, the distance solver does too: what the band leaves after all rounding is
# more than touching.
# constant: GjkTolerances.SeparatedBand = 256 * 2^-53
# constant: GjkTolerances.Touch = 16 * 2^-53 (touch)
# code: src/Gjk.Core/Solvers/GjkOverlap.cs, Solve; Solvers/Proofs.cs, IsTouching
# assumed: the vertices as given; |n| = 1 and the pair's size 1, since nothing here knows a scale; a plane no further
#   away than twice the band, so the vertices are no further from the origin than 2.02
# control: c = 32b-53;
c = 256b-53;
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

# A support is chosen by rounded values, so another vertex may be lower: by twice the rounding of a dot product with a
# local point, whose coordinates are four half extents at most (HullOrigin); and for B by what rounding does to the
# direction: sqrt(3) k for each of two points, since the rows of a rotation are unit vectors.
chosen = 2 * 4 * k + 2 * k * 174e-2;

# The distance solver may end with its plane a noise below the feature, and each of the two rounds (noise.g).
reach = 202e-2;
touch = 16b-53;
other = 4b-53 + k * reach + k * reach;
left = c * (1 - 10 * g) - k * reach - chosen - other;
{ m1 in [0, 3] /\ m2 in [0, 3] /\ m3 in [0, 3] /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53
  /\ |p3| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |g| <= 1b-53
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ left - touch >= 0 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k - s2 * e2) + m3 * (k - s3 * e3);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k + s2 * e2) + m3 * (k + s3 * e3);
