# A vertex that is left out of a cell's list is not what a scan of all finds there: in every direction of the cell
# another one is higher, by more than the scan's two dot products can lose.
# constant: CellFilter.Slack = 1 * 2^-40
# code: src/Gjk.Core/Hulls/Lookup/CellFilter.cs, Copy and IsBeaten; HullBlocks.cs, Dot; HullCellLists.cs
# assumed: in stretched units a coordinate is 4 at most (HullOrigin) and a component of a direction 1 (a part's half
#   side and centre are 1.01 at most); a coordinate is a quotient. Lists that are clipped (CellClip) have the same
#   slack, but the corners of the clipped rectangle are not in this
# control: c = 1b-45;
c = 1b-40;
u = 1b-53;

# A dot product of coordinates that were rounded: quotients (q), products (p), sums (r). What it is off by is k times
# the terms' magnitudes at most, 4 each.
t1 = s1 * m1; t2 = s2 * m2; t3 = s3 * m3;
computed = ((t1 * (1 + q1) * (1 + p1) + t2 * (1 + q2) * (1 + p2)) * (1 + r1) + t3 * (1 + q3) * (1 + p3)) * (1 + r2);
exact = t1 + t2 + t3;
magnitude = m1 + m2 + m3;
e1 = (1 + q1) * (1 + p1) * (1 + r1) * (1 + r2) - 1;
e2 = (1 + q2) * (1 + p2) * (1 + r1) * (1 + r2) - 1;
e3 = (1 + q3) * (1 + p3) * (1 + r2) - 1;
k = 40001e-4 * u;
dot = k * 12;

# The sum with the slack, of the lower vertex.
limit = dot + 1201e-2 * u;

# Along each side: two coordinates, their difference, its product with half the side; then a sum. Of the higher vertex.
side = (4 * u + 4 * u + 8 * u) * 101e-2 + 81e-1 * u;
least = dot + side + 201e-1 * u + side + 282e-1 * u;

# The scan's own dot products have coordinates that are floats: 3 roundings of the magnitudes.
scan = 30001e-4 * 12 * u;
left = c - limit - least;
{ m1 in [0, 4] /\ m2 in [0, 4] /\ m3 in [0, 4] /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |q1| <= 1b-53 /\ |q2| <= 1b-53
  /\ |q3| <= 1b-53 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |p3| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  -> k * magnitude - (computed - exact) >= 0 /\ k * magnitude + (computed - exact) >= 0 /\ left - (scan + scan) >= 0 }

# The same, term by term: what is left is not negative. Gappa checks that the two sides are one polynomial.
k * magnitude - (computed - exact) -> m1 * (k - s1 * e1) + m2 * (k - s2 * e2) + m3 * (k - s3 * e3);
k * magnitude + (computed - exact) -> m1 * (k + s1 * e1) + m2 * (k + s2 * e2) + m3 * (k + s3 * e3);
