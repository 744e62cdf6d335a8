# The line of a cast is where it seems to be, but for this part of the radii and of the way: a plane that is further off
# proves a miss.
# constant: CastLine.Rounding = 32 * 2^-53
# code: src/Gjk.Core/Solvers/Motion/CastLine.cs, Make; Minkowski/PairFrame.cs, Compose; CastPortal.cs, IsBeside
# assumed: the radii and the way are 1 together, since nothing here knows a scale: what is linear in both is bounded by
#   its value at either end. The matrix of A as given: what that is off by (pose.g) turns shape and line alike, by less
#   than is promised of a vertex. The centres are the shapes' local origins. The line passes within the radii
# control: c = 8b-53;
c = 32b-53;
u = 1b-53;

# A product with the matrix: the three terms of an element lose 3.0001 roundings of |row| |v| (noise.g), and three rows
# sqrt(3) times that.
product = 30001e-4 * 17321e-4 * u;

# The difference of the positions, and its product with the matrix, for a centre no further away than way and radii.
start = u + product;

# The difference of the motions, its product with the matrix, and the product that makes it a unit vector, which rounds
# each component: they tilt the line over the way, and over the radii behind it.
tilt = u + product + u;

# nearest = T + axis * way, and once more with what is left along the axis: of the way a product, of the radii two sums.
perWay = start + tilt + u;
perRadii = start + tilt + u + u;
{ c - perWay >= 0 /\ c - perRadii >= 0 }
