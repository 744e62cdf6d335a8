# The line of two balls that move is where it seems to be, but for this part of the radii and of the way: one that
# passes further off misses.
# constant: ConvexQuery.BallLineError = 32 * 2^-53
# code: src/Gjk.Core/Queries/ConvexQuery.CastPoint.cs, CastBalls; Minkowski/PairFrame.cs, BetweenCenters
# assumed: the radii and the way are 1 together, since nothing here knows a scale: what is linear in both is bounded by
#   its value at either end. The line passes within twice the radii, or else misses whatever is rounded
# control: c = 6b-53;
c = 32b-53;
u = 1b-53;

# The way between the centres: a difference of floats, or one rounding of it in 106 bits, which is 2 with room.
start = 2 * u;

# The difference of the motions, and the product that makes it a unit vector, which rounds each component.
tilt = u + u;

# nearest = between + axis * way, and once more with what is left along the axis: of the way a product, of the radii two
# sums, counted twice. Its length: 3 roundings in the square count half, and the root.
perWay = start + tilt + u;
perRadii = 2 * (start + tilt + u + u) + 2 * (15e-1 * u + u);

# The limit is a sum of radii, a sum with the way, a product and a sum.
limit = c * (1 - 3 * u) - 2 * u;
{ limit - perWay >= 0 /\ limit - perRadii >= 0 }
