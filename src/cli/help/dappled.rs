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
