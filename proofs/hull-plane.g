# On which side of a plane through three points a point lies is certain where its height, by the length of the normal,
# is this large beside the sum of the terms' magnitudes.
# constant: HullPredicates.PlaneErrorFactor = 16 * 2^-53
# constant: HullDeterminant.ErrorFactor = 16 * 2^-53
# code: src/Gjk.Core/Hulls/Building/HullPredicates.cs, PlaneThrough and Side; HullDeterminant.cs, SignFrom
# assumed: the points are floats; the sum of the magnitudes is 1, since nothing here knows a scale. An extent of the
#   cloud is not below the difference of two of its points: rounding is monotone
# control: c = 4b-53;
c = 16b-53;
u = 1b-53;

# The terms of the exact value: a sign (or less) times a magnitude.
t1 = s1 * m1; t2 = s2 * m2; t3 = s3 * m3; t4 = s4 * m4; t5 = s5 * m5; t6 = s6 * m6;

# What the code computes; every operation brings a factor of its own.
# u = b - a (dx dy dz), v = c - a (gx gy gz), w = p - a (wx wy wz), products (p), differences (d), times w (q), sums
# (r).
x = (t1 * (1 + dy) * (1 + gz) * (1 + p1) - t2 * (1 + dz) * (1 + gy) * (1 + p2)) * (1 + d1) * (1 + wx) * (1 + q1);
y = (t3 * (1 + dz) * (1 + gx) * (1 + p3) - t4 * (1 + dx) * (1 + gz) * (1 + p4)) * (1 + d2) * (1 + wy) * (1 + q2);
z = (t5 * (1 + dx) * (1 + gy) * (1 + p5) - t6 * (1 + dy) * (1 + gx) * (1 + p6)) * (1 + d3) * (1 + wz) * (1 + q3);
computed = ((x + y) * (1 + r1) + z) * (1 + r2);
exact = t1 - t2 + t3 - t4 + t5 - t6;
magnitude = m1 + m2 + m3 + m4 + m5 + m6;

# What happens to each term.
e1 = (1 + dy) * (1 + gz) * (1 + p1) * (1 + d1) * (1 + wx) * (1 + q1) * (1 + r1) * (1 + r2) - 1;
e2 = (1 + dz) * (1 + gy) * (1 + p2) * (1 + d1) * (1 + wx) * (1 + q1) * (1 + r1) * (1 + r2) - 1;
e3 = (1 + dz) * (1 + gx) * (1 + p3) * (1 + d2) * (1 + wy) * (1 + q2) * (1 + r1) * (1 + r2) - 1;
e4 = (1 + dx) * (1 + gz) * (1 + p4) * (1 + d2) * (1 + wy) * (1 + q2) * (1 + r1) * (1 + r2) - 1;
e5 = (1 + dx) * (1 + gy) * (1 + p5) * (1 + d3) * (1 + wz) * (1 + q3) * (1 + r2) - 1;
e6 = (1 + dy) * (1 + gx) * (1 + p6) * (1 + d3) * (1 + wz) * (1 + q3) * (1 + r2) - 1;

k = 80001e-4 * u;

# The code computes the sum of the magnitudes too: 8 roundings make it smaller, those of the three differences, of the
# product, of the two that are added, of the product with w, and of the sum of three; 1 more with the constant.
v1 = 1 - u;
v2 = v1 * v1;
v4 = v2 * v2;
v8 = v4 * v4;
least = c * v8 * v1;

{ m1 in [0, 1] /\ m2 in [0, 1] /\ m3 in [0, 1] /\ m4 in [0, 1] /\ m5 in [0, 1] /\ m6 in [0, 1] /\ |s1| <= 1
  /\ |s2| <= 1 /\ |s3| <= 1 /\ |s4| <= 1 /\ |s5| <= 1 /\ |s6| <= 1 /\ |dx| <= 1b-53 /\ |dy| <= 1b-53 /\ |dz| <= 1b-53
  /\ |gx| <= 1b-53 /\ |gy| <= 1b-53 /\ |gz| <= 1b-53 /\ |wx| <= 1b-53 /\ |wy| <= 1b-53 /\ |wz| <= 1b-53
  /\ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |p3| <= 1b-53 /\ |p4| <= 1b-53 /\ |p5| <= 1b-53 /\ |p6| <= 1b-53
  /\ |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |q1| <= 1b-53 /\ |q2| <= 1b-53 /\ |q3| <= 1b-53
  /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ least - k >= 1b-90 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k + s2 * e2) + m3 * (k - s3 * e3)
  + m4 * (k + s4 * e4) + m5 * (k - s5 * e5) + m6 * (k + s6 * e6);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k - s2 * e2) + m3 * (k + s3 * e3)
  + m4 * (k - s4 * e4) + m5 * (k + s5 * e5) + m6 * (k - s6 * e6);
