//! Help on the commands about dappled tilings and brick walls.

/// Examples for `dapple`.
pub const DAPPLE: &str = "\
A tiling is dappled when no tile stands more than H times in a row or V times in a column \
(--limits H,V). Files are text, a digit for each cell and . for a free one, or PNG, a level of gray \
for each tile.

Examples:
  echo 0110 > row.txt; tilepack dapple check row.txt";

/// Examples for `dapple check`.
pub const DAPPLE_CHECK: &str = "\
Examples:
  tilepack dapple check tiling.txt --limits 2,3
  tilepack dapple check tiling.txt --limits 3,inf --limits 1:2,2 --cyclic

Exit codes: 0 dappled, 1 not, or not complete.

JSON fields (--json): result (dappled or not-dappled), width, height, free, error (null, or the first \
run that is too long).";

/// Examples for `dapple decide`.
pub const DAPPLE_DECIDE: &str = "\
A completion is found, or a proof that there is none, by a search that learns from contradictions; \
what is found is checked from the definition. If there is none, standard output shows given cells \
that have no completion, all others free: small, for without any one of them there would be a \
completion.

Examples:
  tilepack dapple decide given.txt --cyclic
  tilepack dapple decide given.txt --seed 7 -o tiling.png
  tilepack dapple decide --size 12x12 --tiles 4 --limits inf,inf --limits 0+1:2,2 --limits 2+3:2,2
  tilepack dapple decide --size 16x16 --count 1=85
  tilepack dapple decide --size 10x10 --cyclic --counts 1

Exit codes: 0 found, 1 impossible, 75 stopped before that was known.

JSON fields (--json): result (found, impossible, stopped), width, height, given, seconds; found: tiles \
(rows, null with -o), file; impossible: reason (of --count), core (rows, null for a free cell), \
core_cells (column, row), minimal. --counts: result (complete, none, stopped), tile, possible and \
undecided (first and last of each range), fewer and more (why there are none).";

/// Examples for `dapple closest`.
pub const DAPPLE_CLOSEST: &str = "\
The tiling that keeps the limits and differs from the field in as few cells as possible, or in cells \
that weigh as little as possible. It is found from both sides: overlapping strips of the field bound \
the distance from below, filling a strip anew while the rest stays improves the tiling; when both \
meet, it is proved to be nearest. A field that keeps the limits stays as it is.

Examples:
  tilepack dapple closest field.txt
  tilepack dapple closest field.txt --cyclic --limits 3,2 -o nearest.png
  tilepack dapple closest field.txt --fixed kept.txt --weights weights.txt
  tilepack dapple closest field.txt --time-limit 1m --json

Exit codes: 0 proved to be nearest (or as good as the methods allow), 1 impossible: the fixed cells \
that have no completion are shown, 75 stopped before it was proved; the best tiling is written.

JSON fields (--json): result (optimal, found, impossible, stopped), width, height, distance, bound (no \
tiling is nearer), changed (cells), rounds, nodes (cells decided both ways), lines (of the tallest \
strips), seed, core (rows, null for a free cell, if impossible), tiles (rows, null with -o), file, \
seconds.";
