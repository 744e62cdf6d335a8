# To which side of a line a point lies in the plane of two axes is certain where the two products differ by so much,
# beside the sum of their magnitudes.
# constant: PlanarOrientation.LineErrorFactor = 8 * 2^-53
# code: src/Gjk.Core/Hulls/Building/HullPredicates.cs, Turn
# assumed: the points are floats; the sum of the magnitudes is 1, since nothing here knows a scale
# control: c = 2b-53;
c = 8b-53;
u = 1b-53;

# The terms of the exact value: a sign (or less) times a magnitude.
t1 = s1 * m1; t2 = s2 * m2;

# What the code computes; every operation brings a factor of its own.
# Two differences (d), their product (p), for either product; the difference of both (r).
computed = (t1 * (1 + d1) * (1 + d2) * (1 + p1) - t2 * (1 + d3) * (1 + d4) * (1 + p2)) * (1 + r);
exact = t1 - t2;
magnitude = m1 + m2;

# What happens to each term.
e1 = (1 + d1) * (1 + d2) * (1 + p1) * (1 + r) - 1;
e2 = (1 + d3) * (1 + d4) * (1 + p2) * (1 + r) - 1;

k = 40001e-4 * u;

# The code adds the magnitudes of the computed products: 4 roundings make them smaller, 1 more with the constant.
v1 = 1 - u;
v2 = v1 * v1;
v4 = v2 * v2;
v8 = v4 * v4;
least = c * v4 * v1;

{ m1 in [0, 1] /\ m2 in [0, 1] /\ |s1| <= 1 /\ |s2| <= 1 /\ |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53
  /\ |d4| <= 1b-53 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |r| <= 1b-53
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ least - k >= 1b-90 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k + s2 * e2);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k - s2 * e2);
