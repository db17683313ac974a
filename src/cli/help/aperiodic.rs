//! Help on the commands about aperiodic sets.

/// Examples for `aperiodic`.
pub const APERIODIC: &str = "\
A set may be a tile set file or the name of a published one: see aperiodic sets.

Examples:
  tilepack aperiodic decide ammann
  tilepack aperiodic convert kari --method vertical -o corner.json
  tilepack aperiodic patch jeandel-rao --size 64x64 -o patch.svg";

/// Examples for `aperiodic sets`.
pub const APERIODIC_SETS: &str = "\
Examples:
  tilepack aperiodic sets

JSON fields (--json): sets: name, title, kind, tiles, colors (north and south, then east and west), \
status, source; of sets made of others command.";

/// Examples for `aperiodic convert`.
pub const CONVERT: &str = "\
The corner tiles of diagonal, rotation and subdivision are aperiodic if the Wang tiles are. For \
horizontal and vertical, print asks only that different pairs give different tiles; that is not \
enough, so mixed tiles are looked for (docs/aperiodic.md), and with them the set is decided.

Examples:
  tilepack aperiodic convert kari --method vertical -o corner.json
  tilepack aperiodic convert ammann --method horizontal
  tilepack aperiodic convert culik --method rotation --repeat 4
  tilepack aperiodic convert corner.json --method to-wang -o wang.json

JSON fields (--json): result (converted), method, steps (method, tiles, colors, injective), mixed, sound \
(null when undecided), status, file; without -o, up to 1000 tiles: kind, tiles.";

/// Examples for `aperiodic tables`.
pub const TABLES: &str = "\
Sizes as tiles/colors; repeated conversions go by way of Wang tiles. It takes some seconds: the largest \
set has 1,213,029 tiles over 58,910 colors.

Examples:
  tilepack aperiodic tables
  tilepack aperiodic tables --json

JSON fields (--json): sets: set, steps (by method: tiles, colors, injective), criterion (of horizontal \
and vertical: mixed, sound, status).";

/// Examples for `aperiodic decide`.
pub const DECIDE: &str = "\
A set of tiles is read as a machine whose k-th power writes below k rows what it reads above them. \
An empty power says that there is no tiling, a cycle that writes what it reads that there is one with \
two periods; no program decides all sets. Published aperiodic sets are recognized, up to symmetry and \
the names of labels. Every verdict is checked by code that shares nothing with what found it, and so \
is a certificate by verify.

Examples:
  tilepack aperiodic decide set.json
  tilepack aperiodic decide set.json --limit 60 --certificate proof.json; tilepack verify proof.json

Exit codes: 0 when the set fills the plane, 1 when it does not, 75 when it is undecided.

JSON fields (--json): verdict (no-tiling, periodic, undecided or aperiodic), width, height (of the \
torus), limit, status (how it is known), torus (numbers of tiles) and smallest, or square and nodes (a \
string of digits), or rows or columns (the empty power), or name and source; useful (tiles that are on \
cycles), lonely (tiles without a neighbor on some side), seconds, file.";

/// Examples for `aperiodic classify`.
pub const CLASSIFY: &str = "\
Sets of N Wang tiles: those in which every tile is on a cycle of labels along and on one downward, up \
to the names of labels and what --up-to says. All 65,536 sets of corner tiles over two colors. Or a \
proof that no set of at most N corner tiles is aperiodic. docs/classification.md tells what is counted.

Parts are independent and give the same sums in any order; a part that was stopped is run again.

Examples:
  tilepack aperiodic classify --kind wang --tiles 4
  tilepack aperiodic classify --kind corner --colors 2
  tilepack aperiodic classify --kind corner --colors 3 --tiles 6
  tilepack aperiodic classify --kind wang --tiles 5 --part 0/2 -o 0.json
  tilepack aperiodic classify --kind wang --tiles 5 --part 1/2 -o 1.json
  tilepack aperiodic classify --merge 0.json 1.json

JSON fields (--json): result (complete or stopped), kind, tiles, colors, up_to, limit, part, parts, done, \
missing, sets, periodic, no_tiling, undecided (strings of digits), undecided_sets, generators (over two \
colors: tiles, cells of the torus, cells of a period), nodes (a string of digits), no_aperiodic, seconds.";

/// Examples for `aperiodic color`.
pub const APERIODIC_COLOR: &str = "\
Every vertex of a Wang tiling gets a color by the window of tiles around it; the corner tiles that \
come up fill the plane. The condition sees to it that each of their tilings gives one by the Wang \
tiles, so none is periodic if none of those is. Colors are annealed to few corner tiles, in rounds \
with random numbers of their own: the same rounds give the same answer, whatever the number of \
threads. With --time-limit it depends on the machine how many rounds are finished.

For jeandel-rao all windows are known exactly, and the certificate that is written is checked \
before by the code of verify. For a tile set file the windows are those of a legal patch (--patch), \
and it is not proved that the corner tiles fill the plane.

Examples:
  tilepack aperiodic color jeandel-rao --rounds 4 -o c.json; tilepack verify c.json
  tilepack aperiodic color jeandel-rao --condition pair --target 30 --set-out corners.json
  tilepack aperiodic color jeandel-rao --window 4x3 --condition pair --rounds 2 --json

Exit codes: 0 found, 1 no coloring met the condition, or there is no patch, 75 stopped before.

JSON fields (--json): result (found, none or stopped), base, status (exact, or from a patch), window, \
condition (the strongest that was verified), tiles, colors, corner_tiles ([NW, NE, SE, SW]), seed, \
round (that found them), rounds (finished), moves, examined (strings of digits), ends (pairs: corner \
tiles, null for none; rounds that ended with so many), stopped_by, seconds, file, set_file.";

/// Examples for `aperiodic patch`.
pub const PATCH: &str = "\
The sets of Kari and Culik compute and that of Jeandel and Rao is coded by a torus, so their patches \
may be as large as you like. Others are searched, \
a row at a time with some rows looked ahead: up to a hundred tiles a side or so. Every side is checked.

Examples:
  tilepack aperiodic patch jeandel-rao --size 40x24 -o patch.svg
  tilepack aperiodic patch kari --size 300x200 --seed 7 -o kari.png --tile-size 4
  tilepack aperiodic patch ammann --size 12x8

Exit codes: 0, 1 when there is none, 75 when stopped.

JSON fields (--json): result (filled, none or stopped), kind, width, height, seed, ahead (rows looked \
ahead, 0 when computed), back (how often rows were taken back), seconds, file; reason.";
