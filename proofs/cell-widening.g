# The cell that a direction is looked up in, widened by this part of a cell, holds the direction.
# constant: CellGrid.Widening = 1 * 2^-30
# code: src/Gjk.Core/Hulls/Lookup/HullSupport.cs, CubeCell and Index; CellGrid.cs, Measure
# assumed: a face has 64 cells to a side at most (HullCells.MaxSide); w is the largest component
# control: c = 1b-46;
c = 1b-30;

# v * (middle / w) + middle, in cells; v and w are products with the stretch (a, b).
position = (v * (1 + a) * (middle * (1 + q) / (1 + b)) * (1 + p) + middle) * (1 + r);
exact = v * middle + middle;

# The cell's own middle and half sides are off by 3 roundings of 1 each, which is half of the cells.
cell = 6 * middle * 1b-53;
{ |v| <= 1 /\ middle in [1b-1, 32] /\ |a| <= 1b-53 /\ |b| <= 1b-53 /\ |p| <= 1b-53 /\ |q| <= 1b-53 /\ |r| <= 1b-53
  -> |position - exact| + cell - c <= 0 }
position - exact -> v * middle * ((1 + a) * ((1 + q) / (1 + b)) * (1 + p) * (1 + r) - 1) + middle * r { 1 + b <> 0 };
