# The radius that is measured from a core's local box is not below the true one.
# constant: CoreExtent.RoundingUp = 8 * 2^-53
# code: src/Gjk.Core/Cores/CoreExtent.cs, Radius
# assumed: the true radius is 1, since nothing here knows a scale; a root rounds like any operation
# control: c = 2b-53;
c = 8b-53;
u = 1b-53;

# The squared radius is smaller by 3 roundings at most, a square and two sums. The root of it and the product with
# 1 + c are one more each, which a square counts twice.
v1 = 1 - u;
v2 = v1 * v1;
v4 = v2 * v2;
squared = v4 * v2 * v1 * (1 + c) * (1 + c);
{ squared - 1 >= 1b-60 }
