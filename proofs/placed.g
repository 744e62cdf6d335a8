# The bounding radius of a placed shape holds it: a turned point is no further from the centre than its distance before,
# times 1 + c.
# constant: Placement.RoundingUp = 1 + 32 * 2^-53
# code: src/Gjk.Core/Cores/Placement.cs, Outward; Geometry/RotationD.cs, Rotate
# assumed: a point at the distance 1, since nothing here knows a scale; the inner radius holds the inner shape
# control: c = 1 + 8b-53;
c = 1 + 32b-53;
u = 1b-53;

# What the matrix does to lengths. The elements are off by 5.03 and 3.02 roundings (pose.g), so by the norm of a row,
# 11.07; the common factor, off by 4.02, is multiplied by R - I, whose norm is 2 at most.
matrix = 1107e-2 * u + 2 * 402e-2 * u;

# A product with the matrix: the three terms of an element lose 3.0001 roundings of |row| |v| (noise.g), and three rows
# sqrt(3) times that.
product = 30001e-4 * 17321e-4 * u;

# The radius is a product and a sum.
turned = 1 + matrix + product;
radius = c * (1 - u) * (1 - u);
{ radius - turned >= 1b-60 }
