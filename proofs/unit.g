# What one operation in double can lose. Everything else rests on it: sums and products of the other scripts are
# written (a + b) (1 + d) with |d| <= u, which has no scale, so sizes may be called 1.
# constant: RoundOff.Unit = 1 * 2^-53
# code: src/Gjk.Core/Arithmetic/RoundOff.cs, Unit
# assumed: nothing under- or overflows (PairFrame.IsOrdinary: lengths are 2^-60 to 2^60; products of floats are normal)
# control: u = 1b-54;
u = 1b-53;
@double = float<ieee_64, ne>;
rounded = double(x);
{ x in [1b-1000, 1b1000] -> (rounded - x) / x in [-1b-53, 1b-53] /\ (rounded - x) / x / u in [-1, 1] }
