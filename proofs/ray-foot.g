# A ray whose foot is further from a body's centre than its radius, by this part of what the foot is made of, misses.
# constant: RayCaster.FootError = 64 * 2^-53
# code: src/Gjk.Core/Queries/Rays/RayCaster.cs, TryCast; LocalRay.cs, TryMake
# assumed: |between| + offset is 1, since nothing here knows a scale; an origin no further away than 2^40 radii, so what
#   is left along the ray, some sixty roundings, counts by its square only
# control: c = 16b-53;
c = 64b-53;
u = 1b-53;

# What the matrix does to lengths. The elements are off by 5.03 and 3.02 roundings (pose.g), so by the norm of a row,
# 11.07; the common factor, off by 4.02, is multiplied by R - I, whose norm is 2 at most.
matrix = 1107e-2 * u + 2 * 402e-2 * u;

# A product with the matrix: the three terms of an element lose 3.0001 roundings of |row| |v| (noise.g), and three rows
# sqrt(3) times that.
product = 30001e-4 * 17321e-4 * u;

# The matrix turns origin and direction alike. A linear map brings the foot to no more than 1 + matrix times its
# distance, which is 1 at most: by matrix more.

# The origin: a difference of floats, its product with the matrix, and less the centre.
origin = u + product + u;

# The direction: its product with the matrix and the product that makes it a unit vector, which rounds each component.
tilt = product + u;

# foot = local + direction * shift: a product and a sum.
foot = u + u;

# Of the reach: a product, two sums; and the squares that are compared, 3 roundings in each, count half.
limit = c * (1 - 3 * u) - u - 15e-1 * u - 15e-1 * u;
{ limit - (matrix + origin + tilt + foot) >= 0 }
