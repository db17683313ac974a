//! Help on the commands about dappled tilings and brick walls.

/// Examples for `dapple`.
pub const DAPPLE: &str = "\
A tiling is dappled when no tile stands more than H times in a row or V times in a column \
(--limits H,V). Files are text, a digit for each cell and . for a free one, or PNG, a level of gray \
for each tile.

Examples:
  tilepack dapple make --size 32x16 -o tiling.txt; tilepack dapple check tiling.txt
  tilepack dapple make --size 64x64 --limits 3,5 --cyclic -o tiling.png";

/// Examples for `dapple make`.
pub const DAPPLE_MAKE: &str = "\
Goes once through the cells and changes those that repeat too often; a tiling that is dappled \
already comes back as it is. That always works with free edges, for two tiles with limits from 2 on \
and for three and more tiles; with edges that meet for two tiles with limits from 3 on. Elsewhere what \
the pass leaves is repaired exactly, and if there is no tiling at all, that is proved.

Examples:
  tilepack dapple make --size 32x16 -o tiling.txt
  tilepack dapple make --from tiling.txt --limits 1:2,3 --limits 0:3,inf --cyclic
  tilepack dapple make --size 2000x1000 --seed 7 --order wavefront -o tiling.png
  tilepack dapple make --size 24x12 --tiles 6 --limits 1,1 --limits 0+1+2:3,3 --limits 3+4+5:3,3

Exit codes: 0 made, 1 there is none, 75 stopped.

JSON fields (--json): result (found, none or stopped), method, width, height, tiles, changed (cells \
that differ from the start), seed, start_seconds (random tiles), seconds (from there), \
cells_per_second, file, rows (without -o; arrays of tiles); reason where there is none.";

/// Examples for `dapple check`.
pub const DAPPLE_CHECK: &str = "\
Examples:
  tilepack dapple make --size 30x20 --limits 2,3 --cyclic -o tiling.txt
  tilepack dapple check tiling.txt --limits 2,3 --cyclic
  tilepack dapple check tiling.txt --limits 3,inf --limits 1:2,3

Exit codes: 0 dappled, 1 not, or not complete.

JSON fields (--json): result (dappled or not-dappled), width, height, free, error (null, or the first \
run that is too long).";
