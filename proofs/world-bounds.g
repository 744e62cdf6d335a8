# A box in the world is widened by more than its centre is off.
# constant: ShapeBounds.DoubleSlack = 64 * 2^-53
# code: src/Gjk.Core/World/ShapeBounds.cs, BoxAt and Around
# assumed: the local centre's distance and the position's together are 1, since nothing here knows a scale
# control: c = 16b-53;
c = 64b-53;
u = 1b-53;

# What the matrix does to lengths. The elements are off by 5.03 and 3.02 roundings (pose.g), so by the norm of a row,
# 11.07; the common factor, off by 4.02, is multiplied by R - I, whose norm is 2 at most.
matrix = 1107e-2 * u + 2 * 402e-2 * u;

# A product with the matrix: the three terms of an element lose 3.0001 roundings of |row| |v| (noise.g), and three rows
# sqrt(3) times that.
product = 30001e-4 * 17321e-4 * u;

# The turned centre, and the sum with the position; the slack itself is a product and a sum or two.
centre = matrix + product + u;
slack = c * (1 - u) * (1 - u) * (1 - u) * (1 - u);
{ slack - centre >= 0 }
