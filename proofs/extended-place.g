# A centre that is turned in 106 bits is where it seems to be, but for this part of its distance from the local origin.
# constant: PairFrame.ExtendedError = 1 * 2^-90
# code: src/Gjk.Core/Geometry/VectorDD.cs, Rotate; Minkowski/PairFrame.cs, BetweenFarCenters
# assumed: a product loses 7 parts in 2^106 (extended-product.g), a sum 3 and a little (as in hull-extended.g), a
#   quotient 20 (two products and three sums at most); the local centre is at the distance 1, since nothing here knows
#   a scale
# control: c = 1b-98;
c = 1b-90;
v = 1b-106;

# v + u x (u x v + w v) * (2 / |q|^2). Of the magnitudes, |u| |v| and w |v| are 1 at most, and each element of a cross
# product has two terms, so a length is sqrt(2) of the bound of an element at most twice over: 3.
product = 7 * v;
sum = 301e-2 * v;
inner = 3 * (product + sum) + product + sum;
outer = 3 * 2 * (product + sum) + 3 * inner;

# The squared length: four products, three sums; then the quotient, and the product with it, 2 at most.
scale = product + 3 * sum + 20 * v;
turned = 2 * outer + 2 * 2 * (scale + product) + sum * 2;

# Two centres, the difference of both, and with that of the positions.
{ c - (turned + turned + 4 * sum) >= 0 }
