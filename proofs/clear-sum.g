# Where the origin clearly is inside a tetrahedron, the point that its weights give is the origin but for Residual, 1e-9
# of the corners' size.
# constant: ClosestPointWeights.ClearSum = 1e-5
# constant: ClosestPointWeights.Residual = 1e-9 (residual)
# code: src/Gjk.Core/Simplex/ClosestPointWeights.cs, TryInside and VolumeWeights
# assumed: the corners' squared lengths add up to 1, since nothing here knows a scale; then their lengths add up to 2 at
#   most. A volume is off by 1.1112 roundings at most (clear-volume.g); all four have one sign, by IsClear
# control: c = 1e-7;
c = 1e-5;
residual = 1e-9;
u = 1b-53;
volume = 11112e-4 * u;

# The sum of the volumes, compared by its square with c^2 size^3: 30 roundings make it smaller than it seems (g).
sum = c * (1 - 30 * g);

# A weight is a volume over the computed sum. What the sum is off by changes all weights alike, and the weighted point,
# the origin, not at all. The rest is what the volume is off by, and the quotient's own rounding of a weight that is 1
# at most but for the volumes' errors (1.001).
weight = volume / sum * 1001e-3 + 1001e-3 * u;
point = 2 * weight;
{ |g| <= 1b-53 -> residual - point >= 0 }
