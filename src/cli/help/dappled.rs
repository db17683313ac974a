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

/// Examples for `brick`.
pub const BRICK: &str = "\
In every tile one joint goes straight through and two others end at it, beside each other: T-joints, \
no crosses, and a brick around every corner of the grid. Labels 0 and 1 say where a joint goes from \
west to east or from north to south; without --labels they are made dappled, so that no joint is \
long. With three positions or more every boundary goes on into a wall, where lines are not too short; \
without limits (inf,inf) and for regions a linear algorithm decides it.

Examples:
  tilepack brick --size 24x16 -o wall.svg
  tilepack brick --size 12x12 --limits 3,2 --cyclic -o wall.txt; tilepack verify wall.txt
  tilepack dapple make --size 20x10 -o labels.txt; tilepack brick --labels labels.txt -o wall.png
  tilepack brick --size 3x3 --positions 3 --count

  tilepack brick --positions 3 --set-out bricks.json --tiles-out bricks
  tilepack find --set bricks.json --values random -o packing.json
  tilepack atlas packing.json --fill bricks -o atlas.png --check
  tilepack brick --positions 3 --size 16x16 --cyclic -o map.txt
  tilepack export packing.json --to glsl-es-300 --coloring map:map.txt -o wall.glsl

Exit codes: 0 built or counted, 1 there is no such wall, 75 stopped, or no labels were found that do.

JSON fields (--json): result (built, counted, none or stopped), method, width, height, positions, \
set_size (how many brick Wang tiles there are), seed, file, set_file, tiles_file, tiles (without -o; \
their numbers by row); walls (--count, a string of digits); reason where there is none.";

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
