# Where the quadratic coefficient of a line and a cone is this large beside a part of it, its sign is certain.
# constant: RayCone.Parallel = 16 * 2^-53
# code: src/Gjk.Core/Queries/Rays/RayCone.cs, TryFind
# assumed: the direction and the slope k of the cone as given; the part k^2 dy^2 is 1, since nothing here knows a
#   scale. A sign can only be wrong where the other part, dx^2 + dz^2, is about as large: 1.01 at most
# control: c = 4b-53;
c = 16b-53;
u = 1b-53;

# a = dx dx + dz dz - k k dy dy: a product and two sums for each of the first two, three products and the last sum.
computed = ((mx * (1 + p1) + mz * (1 + p2)) * (1 + r1) - (1 + q1) * (1 + q2) * (1 + q3)) * (1 + r2);
exact = mx + mz - 1;
ex = (1 + p1) * (1 + r1) * (1 + r2) - 1;
ez = (1 + p2) * (1 + r1) * (1 + r2) - 1;
ea = (1 + q1) * (1 + q2) * (1 + q3) * (1 + r2) - 1;
k = 30001e-4 * u;
ka = 40001e-4 * u;
error = k * (mx + mz) + ka;

# The code computes the part anew: three products, and one with the constant.
limit = c * (1 - u) * (1 - u) * (1 - u) * (1 - u);
{ mx in [0, 2] /\ mz in [0, 2] /\ mx + mz in [0, 101e-2] /\ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |q1| <= 1b-53
  /\ |q2| <= 1b-53 /\ |q3| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  -> error - (computed - exact) >= 0 /\ error + (computed - exact) >= 0 /\ limit - error >= 0 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
error - (computed - exact) -> mx * (k - ex) + mz * (k - ez) + (ka + ea);
error + (computed - exact) -> mx * (k + ex) + mz * (k + ez) + (ka - ea);
