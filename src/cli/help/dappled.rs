//! Help on the commands about dappled tilings and brick walls.

/// Examples for `dapple`.
pub const DAPPLE: &str = "\
A tiling is dappled when no tile stands more than H times in a row or V times in a column \
(--limits H,V). Files are text, a digit for each cell and . for a free one, or PNG, a level of gray \
for each tile.

Examples:
  tilepack dapple count --size 8x8
  tilepack dapple sample --size 8x8 --seed 1
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

/// Examples for `dapple draw`.
pub const DAPPLE_DRAW: &str = "\
Examples:
  tilepack dapple make --size 32x16 -o tiling.txt
  tilepack dapple draw tiling.txt -o tiling.svg --cell-size 12
  tilepack dapple make --from tiling.txt --limits 3,3 --cyclic -o cyclic.txt
  tilepack dapple draw cyclic.txt --against tiling.txt -o changes.png

JSON fields (--json): result (drawn), width, height, differ (cells that differ, null without --against), \
file.";

/// Examples for `dapple flow`.
pub const DAPPLE_FLOW: &str = "\
Every row and every column is a street, by turns in both directions. Where tile 0 stands the two \
streams cross, where tile 1 stands both turn, so that they wind through the tiling; that it is \
dappled says how far they go straight on. At crossings every stream goes over and under in turns.

Examples:
  tilepack dapple decide --size 24x16 -o winding.txt; tilepack dapple flow winding.txt -o flow.svg
  tilepack dapple flow winding.txt -o flow.html

JSON fields (--json): result (drawn), width, height, streams, closed, longest (cells that it goes \
through), straight (cells at most, in a row and in a column), file.";

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
