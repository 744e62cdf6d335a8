# A face that a cast enters through: its corners count as level, it is no needle and no graze. Then the entry is right
# to 1e-9 of the radii, a hundredth of the promise, and the normal to 3e-7.
# constant: CastPortal.Level = 64 * 2^-53
# constant: CastPortal.LeastHeight = 1e7 * 64 * 2^-53 (height)
# constant: CastPortal.LeastSlope = 1e-5 (slope)
# constant: CastPortal.EntryGap = 1e-10 (gap)
# code: src/Gjk.Core/Solvers/Motion/CastPortal.cs, Solve and IsCertain
# assumed: the corners as given; the radii are 1, since nothing here knows a scale, so the corners are no further from
#   the origin than 2 (the line passes within the radii). The shape lies beyond the support plane
# control: c = 256b-53;
c = 64b-53;
height = 1e7 * 64b-53;
slope = 1e-5;
gap = 1e-10;
u = 1b-53;

# A corner is as level as its computed offset says, and what two computed offsets lose (noise.g); ten roundings in the
# comparison.
reach = 2;
off = c * (1 + 10 * u) + 2 * 30001e-4 * u * reach;

# Along the line the plane and the corners are further apart by the slope; the weighted point is off the line by the
# gap.
entry = off / (slope * (1 - 10 * u)) + gap * (1 + 10 * u);

# Planes that have all corners within as much on either side, over a triangle of this height.
tilt = 2 * off / (height * (1 - 10 * u));
{ 1e-9 - entry >= 0 /\ 3e-7 - tilt >= 0 }
