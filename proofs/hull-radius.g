# The ball about a hull's centre holds its corners: the computed distance of the furthest, times 1 + c, is not below the
# true one.
# constant: ConvexHull.RadiusSlack = 8 * 2^-53
# code: src/Gjk.Core/Hulls/ConvexHull.cs, MeasureRadius
# assumed: the true distance is 1, since nothing here knows a scale; a root rounds like any operation
# control: c = 2b-53;
c = 8b-53;
u = 1b-53;

# The squared distance is smaller by 5 roundings at most: two of each difference, which is squared, its square, two
# sums. The root of it and the product with 1 + c are one more each, which a square counts twice.
v1 = 1 - u;
v2 = v1 * v1;
v4 = v2 * v2;
v8 = v4 * v4;
squared = v8 * v1 * (1 + c) * (1 + c);
{ squared - 1 >= 1b-60 }
