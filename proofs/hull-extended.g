# The same in numbers of 106 bits: on which side of a plane through three points a point lies.
# constant: HullDeterminant.ExtendedErrorFactor = 128 * 2^-106
# code: src/Gjk.Core/Hulls/Building/HullDeterminant.cs, SignFrom; Arithmetic/DoubleDouble.cs
# assumed: the differences of floats are exact there; a product loses 7 parts in 2^106 at most (extended-product.g), a
#   sum 3 and a little (Joldes, Muller and Popescu 2017, AccurateDWPlusDW, which this sum is); the magnitudes add up
#   to 1, since nothing here knows a scale
# control: c = 23b-106;
c = 128b-106;
u = 1b-53;
v = 1b-106;

# The terms of the exact value: a sign (or less) times a magnitude.
t1 = s1 * m1; t2 = s2 * m2; t3 = s3 * m3; t4 = s4 * m4; t5 = s5 * m5; t6 = s6 * m6;

# What the code computes; every operation brings a factor of its own.
# Products (p), differences (d), times w (q), sums (r).
x = (t1 * (1 + 7 * p1) - t2 * (1 + 7 * p2)) * (1 + 301e-2 * d1) * (1 + 7 * q1);
y = (t3 * (1 + 7 * p3) - t4 * (1 + 7 * p4)) * (1 + 301e-2 * d2) * (1 + 7 * q2);
z = (t5 * (1 + 7 * p5) - t6 * (1 + 7 * p6)) * (1 + 301e-2 * d3) * (1 + 7 * q3);
computed = ((x + y) * (1 + 301e-2 * r1) + z) * (1 + 301e-2 * r2);
exact = t1 - t2 + t3 - t4 + t5 - t6;
magnitude = m1 + m2 + m3 + m4 + m5 + m6;

# What happens to each term.
e1 = (1 + 7 * p1) * (1 + 301e-2 * d1) * (1 + 7 * q1) * (1 + 301e-2 * r1) * (1 + 301e-2 * r2) - 1;
e2 = (1 + 7 * p2) * (1 + 301e-2 * d1) * (1 + 7 * q1) * (1 + 301e-2 * r1) * (1 + 301e-2 * r2) - 1;
e3 = (1 + 7 * p3) * (1 + 301e-2 * d2) * (1 + 7 * q2) * (1 + 301e-2 * r1) * (1 + 301e-2 * r2) - 1;
e4 = (1 + 7 * p4) * (1 + 301e-2 * d2) * (1 + 7 * q2) * (1 + 301e-2 * r1) * (1 + 301e-2 * r2) - 1;
e5 = (1 + 7 * p5) * (1 + 301e-2 * d3) * (1 + 7 * q3) * (1 + 301e-2 * r2) - 1;
e6 = (1 + 7 * p6) * (1 + 301e-2 * d3) * (1 + 7 * q3) * (1 + 301e-2 * r2) - 1;

k = 2304e-2 * v;

# The sum of the magnitudes is computed in double, as in hull-plane.g; the high half of the volume is within a rounding.
v1 = 1 - u;
v2 = v1 * v1;
v4 = v2 * v2;
v8 = v4 * v4;
least = c * v8 * v2;

{ m1 in [0, 1] /\ m2 in [0, 1] /\ m3 in [0, 1] /\ m4 in [0, 1] /\ m5 in [0, 1] /\ m6 in [0, 1] /\ |s1| <= 1
  /\ |s2| <= 1 /\ |s3| <= 1 /\ |s4| <= 1 /\ |s5| <= 1 /\ |s6| <= 1 /\ |p1| <= 1b-106 /\ |p2| <= 1b-106
  /\ |p3| <= 1b-106 /\ |p4| <= 1b-106 /\ |p5| <= 1b-106 /\ |p6| <= 1b-106 /\ |d1| <= 1b-106 /\ |d2| <= 1b-106
  /\ |d3| <= 1b-106 /\ |q1| <= 1b-106 /\ |q2| <= 1b-106 /\ |q3| <= 1b-106 /\ |r1| <= 1b-106 /\ |r2| <= 1b-106
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0
  /\ least - k >= 1b-140 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k + s2 * e2) + m3 * (k - s3 * e3)
  + m4 * (k + s4 * e4) + m5 * (k - s5 * e5) + m6 * (k + s6 * e6);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k - s2 * e2) + m3 * (k + s3 * e3)
  + m4 * (k - s4 * e4) + m5 * (k + s5 * e5) + m6 * (k - s6 * e6);
