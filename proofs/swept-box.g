# A path never enters a widened box later than it enters the box: the widening is more than the test loses.
# constant: SweptBox.WaySlack = 512 * 2^-53
# code: src/Gjk.Core/BroadPhase/SweptBox.cs, SweptBox, MeetsScalar and MeetsWide
# assumed: the farthest coordinate of the box is 1, seen from the start, since nothing here knows a scale; the rest of
#   the slack is for the queries that ask about what is in the box
# control: c = 3b-53;
c = 512b-53;
u = 1b-53;

# The entry, -(passed + slack) * inverse, in units of the true 1 / d: a difference (p) of floats, a sum (a), a quotient
# (i) and a product (m). The slack is a product (s). The true entry is -passed.
passed = f * (1 + p);
entry = (passed + c * (1 + s)) * (1 + a) * (1 + i) * (1 + m);
{ |f| <= 1 /\ |p| <= 1b-53 /\ |s| <= 1b-53 /\ |a| <= 1b-53 /\ |i| <= 1b-53 /\ |m| <= 1b-53 -> entry - f >= 0 }
entry - f -> f * ((1 + p) * (1 + a) * (1 + i) * (1 + m) - 1) + c * (1 + s) * (1 + a) * (1 + i) * (1 + m);
