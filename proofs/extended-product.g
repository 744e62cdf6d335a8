# A product of two numbers of 106 bits, each an unevaluated sum of two doubles: how far it is off, as a part of it.
# supports: hull-extended.g, which takes 7 parts in 2^106
# code: src/Gjk.Core/Arithmetic/DoubleDouble.cs, operator *
# assumed: the high halves are from 1 to 2, as powers of two make them; a low half is at most half a unit in the last
#   place of its high half; the product of the high halves is exact as p + e (Dekker 1971); the last sum is exact as
#   a sum of two
# control: c = 6b-106;
c = 7b-106;
@double = float<ieee_64, ne>;
ah = double(ah_);
bh = double(bh_);
p = double(ah * bh);
e = ah * bh - p;
cross double= ah * bl + al * bh;
low = double(e + cross);
computed = p + low;
exact = (ah + al) * (bh + bl);
{ ah in [1, 2] /\ bh in [1, 2] /\ |al| <= 1b-53 /\ |bl| <= 1b-53 -> |(computed - exact) / (ah * bh)| / c <= 1 }

# The error is that of the last sum, that of the cross terms, and what is left out, each as a part of the product.
(computed - exact) / (ah * bh) -> (low - (e + cross)) / (ah * bh)
  + (cross - (ah * bl + al * bh)) / (ah * bh) - (al / ah) * (bl / bh) { ah <> 0, bh <> 0 };
$ ah in 16, bh in 16;
