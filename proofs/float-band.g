# A distance that is beyond a limit by more than the band rounds to a float beyond it.
# constant: GjkTolerances.FloatBand = 4 * 2^-24
# code: src/Gjk.Core/Solvers/Motion/CastSolver.cs, Solve; ConvexQuery and Wide use it alike
# assumed: the limit is a float, called 1; rounding to float changes a number by 2^-24 of it at most (e)
# control: band = 1b-24;
band = 4b-24;
distance = 1 + band + more;
rounded = distance * (1 + e);
{ more in [0, 1] /\ |e| <= 1b-24 -> rounded - 1 >= 1b-24 }
