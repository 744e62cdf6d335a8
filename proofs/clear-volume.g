# The signs of the four volumes of a tetrahedron's corners with the origin are certain where the least is this large
# beside the corners' size.
# constant: ClosestPointWeights.ClearVolume = 4 * 2^-53
# code: src/Gjk.Core/Simplex/ClosestPointWeights.cs, VolumeWeights, IsClear and CubeOf
# assumed: the corners as given; their squared lengths add up to 1, since nothing here knows a scale. Then three of
#   them have |x| |y| |z| <= 1 / sqrt(27) (the mean inequality), and the magnitudes of the six terms of their volume
#   add up to 6 / sqrt(27) times that at most (the permanent: Carlen, Lieb and Loss 2006): 6 / 27
# control: c = 17b-57;
c = 4b-53;
u = 1b-53;

# The terms of the exact value: a sign (or less) times a magnitude.
t1 = s1 * m1; t2 = s2 * m2; t3 = s3 * m3; t4 = s4 * m4; t5 = s5 * m5; t6 = s6 * m6;

# What the code computes; every operation brings a factor of its own.
# x . (y x z): six products (p), the cross product's differences (d), times x (q), sums (r).
x = (t1 * (1 + p1) - t2 * (1 + p2)) * (1 + d1) * (1 + q1);
y = (t3 * (1 + p3) - t4 * (1 + p4)) * (1 + d2) * (1 + q2);
z = (t5 * (1 + p5) - t6 * (1 + p6)) * (1 + d3) * (1 + q3);
computed = ((x + y) * (1 + r1) + z) * (1 + r2);
exact = t1 - t2 + t3 - t4 + t5 - t6;
magnitude = m1 + m2 + m3 + m4 + m5 + m6;

# What happens to each term.
e1 = (1 + p1) * (1 + d1) * (1 + q1) * (1 + r1) * (1 + r2) - 1;
e2 = (1 + p2) * (1 + d1) * (1 + q1) * (1 + r1) * (1 + r2) - 1;
e3 = (1 + p3) * (1 + d2) * (1 + q2) * (1 + r1) * (1 + r2) - 1;
e4 = (1 + p4) * (1 + d2) * (1 + q2) * (1 + r1) * (1 + r2) - 1;
e5 = (1 + p5) * (1 + d3) * (1 + q3) * (1 + r2) - 1;
e6 = (1 + p6) * (1 + d3) * (1 + q3) * (1 + r2) - 1;

k = 50001e-4 * u;
permanent = 22223e-5;

# The code compares the least volume's square with c^2 size^3. 24 roundings make that smaller, or the volume's square
# larger: 6 in each size, 2 between the sizes, 1 with c^2, 1 in the square, 2 to spare.
v1 = 1 - u;
v2 = v1 * v1;
v4 = v2 * v2;
v8 = v4 * v4;
least = c * c * v8 * v8 * v8;
error = k * permanent;

{ m1 in [0, 1] /\ m2 in [0, 1] /\ m3 in [0, 1] /\ m4 in [0, 1] /\ m5 in [0, 1] /\ m6 in [0, 1] /\ |s1| <= 1
  /\ |s2| <= 1 /\ |s3| <= 1 /\ |s4| <= 1 /\ |s5| <= 1 /\ |s6| <= 1 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |p3| <= 1b-53
  /\ |p4| <= 1b-53 /\ |p5| <= 1b-53 /\ |p6| <= 1b-53 /\ |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53
  /\ |q1| <= 1b-53 /\ |q2| <= 1b-53 /\ |q3| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ least - error * error >= 1b-130 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k + s2 * e2) + m3 * (k - s3 * e3)
  + m4 * (k + s4 * e4) + m5 * (k - s5 * e5) + m6 * (k + s6 * e6);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k - s2 * e2) + m3 * (k + s3 * e3)
  + m4 * (k - s4 * e4) + m5 * (k + s5 * e5) + m6 * (k - s6 * e6);
