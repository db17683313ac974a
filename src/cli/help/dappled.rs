//! Help on the commands about dappled tilings and brick walls.

/// Examples for `dapple`.
pub const DAPPLE: &str = "\
A tiling is dappled when no tile stands more than H times in a row or V times in a column \
(--limits H,V). Files are text, a digit for each cell and . for a free one, or PNG, a level of gray \
for each tile.

Examples:
  tilepack dapple count --size 8x8
  tilepack dapple sample --size 8x8 --seed 1
  echo 0110 > row.txt; tilepack dapple check row.txt";

/// Examples for `dapple check`.
pub const DAPPLE_CHECK: &str = "\
Examples:
  tilepack dapple check tiling.txt --limits 2,3
  tilepack dapple check tiling.txt --limits 3,inf --limits 1:2,2 --cyclic

Exit codes: 0 dappled, 1 not, or not complete.

JSON fields (--json): result (dappled or not-dappled), width, height, free, error (null, or the first \
run that is too long).";

/// Examples for `dapple count`.
pub const DAPPLE_COUNT: &str = "\
Exact, by states of the rim: the cost grows exponentially with the shorter side (12 cells take a \
moment, 16 a minute and 1 GiB) and linearly with the longer one.

Examples:
  tilepack dapple count --size 10x10
  tilepack dapple count --size 6x6 --by-number
  tilepack dapple count --size 8x6 --cyclic --limits 3,2
  tilepack dapple count --size 6x4 --tiles 3 --limits 1,2 --limits 0+1:3,3
  tilepack dapple count --size 12x12 --checkpoint count.checkpoint --json

A count that was stopped goes on with the same command, or with tilepack resume FILE.

Exit codes: 0 counted, 1 there are none, 75 stopped early.

JSON fields (--json): result (counted or stopped), tilings (a number in digits, null when stopped), \
by_number (null, or tile and numbers, a list of pairs: how often it occurs, in how many tilings), width, \
height, tiles, edges (free, cylinder or torus), states (the most at a time, or starts on a torus), \
seconds, stopped_by (null, signal or time-limit), checkpoint (null or the file).";

/// Examples for `dapple sample`.
pub const DAPPLE_SAMPLE: &str = "\
Every tiling is drawn with exactly the same probability: one random number below their count says which.

Examples:
  tilepack dapple sample --size 12x12
  tilepack dapple sample --size 8x20 --number 3 --seed 7
  tilepack dapple sample --size 8x8 --cyclic -o tiling.png
  tilepack dapple sample --size 6x6 --limits 3,3 --json

Exit codes: 0 drawn, 1 there are none.

JSON fields (--json): result (sampled or none), of (how many there are, in digits), width, height, seed, \
tilings (each a list of rows), file (null or the file written).";
