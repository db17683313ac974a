//! Help on the commands about textures and tilings.

/// Examples for `atlas`.
pub const ATLAS: &str = "\
The picture of a tile depends, within the strip, on the colors of that side alone. So a filter \
that strays over the border of a tile reads in the atlas what it would read in any tiling, as long \
as it stays in the strip: through level log2(STRIP), and with anisotropic filtering through a \
ratio of 2 STRIP at level 0. --check finds the largest difference over all legal neighbors.

Mip levels are means of 2 x 2 texels, in light; no texel crosses the border of a tile. Equal \
arguments give equal bytes, and the PNG says in its text which they were.

Examples:
  tilepack find --kind corner --colors 3 -o three.json
  tilepack atlas three.json -o atlas.png --mips --tables tables --check
  tilepack atlas three.json -o curves.png --fill truchet --tile-size 128 --strip 8
  tilepack atlas three.json --fill noise --check --arrange by-number || echo not exact
  tilepack atlas three.json -o padded.png --gutter 4 --fill truchet --check

Exit codes: 0, and 1 when --check finds that filtering is not exact through log2(STRIP).

JSON fields (--json): result (made), file, width, height, tiles, tile_size, strip, gutter, levels, \
files, tables; with --check exact_to_lod (null when at none), errors (bilinear, by LOD), trilinear \
(at LOD 0.5, 1.5, ...), anisotropic (ratio and error, at LOD 0), in 1/255 of full light.";

/// Examples for `lint`.
pub const LINT: &str = "\
What tiles with the same colors on a side should show there is taken to be the median of what \
they show. A seam is visible when its steps are more than twice those beside it, by more than \
4/255.

Examples:
  tilepack find --kind wang --colors 2 -o wang.json
  tilepack atlas wang.json -o wang.png --fill truchet
  tilepack lint wang.png --tiles wang.json --strip 4 --filter --heat heat.png

Exit codes: 0 all fits, 1 something is off.

JSON fields (--json): result (fits or off), tiles, tile_size, strip, areas, off (areas that are \
off: cell, side, corner, largest, rms), seams, visible (first, second, side, largest, step, \
inside), missing, twice, alike, lonely, redraw (cells, the worst first); with --filter those of \
atlas --check.";

/// Examples for `fill`.
pub const FILL: &str = "\
Every texel of a tile is a texel of an example, unchanged; pieces are cut apart along the line where \
it shows least, all maps alike. Within --strip texels of a side a tile shows what the colors of that \
side say, and nothing else: atlas --fill OUT goes on from there. That is checked before anything \
is written. The corners of Wang tiles are the same in all of them.

OUT.png is a sheet: of --packing the packing's own atlas, else in the order of tile numbers, and \
OUT.tiles.json says so to atlas --sheet and lint --tiles. Other names are folders. Maps go to \
OUT-NAME, NAME being that of the map's file. Of a compact set the tiles are those of the packing \
that find constructs. Equal arguments give equal bytes on any number of threads, unless a time limit \
cuts the trying short.

Examples:
  tilepack fill --example stone -o stone.png
  tilepack fill --example stone-normal -o normal.png
  tilepack fill stone.png --map normal.png --kind corner --colors 2 -o stones --candidates 4
  tilepack find --kind wang --colors 2 -o wang.json
  tilepack fill stone.png --packing wang.json --tile-size 32 -o wang.png --report wang-report.json
  tilepack atlas wang.json --fill wang.png --sheet wang.json --check

Exit codes: 0, and 75 when a signal ended it; nothing is written then.

JSON fields (--json, --report): result (made, or drawn for --example), kind, colors, method, tiles, \
tile_size, strip, strip_differences (0), seed, candidates (tried), taken, stopped_by, seconds, \
files, tile_list, bytes, quality, and with --baselines baselines (periodic, quilting). quality has \
seams (share of all steps; mean, high (95 %) and largest mismatch by the mean difference of texels \
side by side in the examples; at_cuts, at_borders, at_middles: differences there by those \
elsewhere), period (comb and peak: what lines at multiples of 1/tile_size in the spectrum have over \
independent tiles; correlation 1, 2, ... tiles apart), likeness (of each channel mean, variance, \
moved; patches and patches_high: distances of 7x7 patches, in 1/255), reuse (share, evenness, \
largest).";

/// Examples for `export`.
pub const EXPORT: &str = "\
A packing is checked, then written for another program. Tile sets and frames name a picture of the \
packing, in which the tiles lie as in the packing, --tile-size texels each; its name is --image. \
Maps, models and demos show a tiling of --size tiles without end: of a complete set random colors, \
else laid tile by tile, else the packing repeated; --seed chooses it. docs/formats-out.md says what \
each format holds and how to load it.

Tiled and Godot count the colors of vertical edges on from those of horizontal edges; Tiled knows at \
most 254 of both together. Pieces of a puzzle have room for so many colors as their knobs can be \
told apart.

Shaders (glsl-330, glsl-es-300, hlsl, wgsl) are functions to be pasted; how to call them stands at \
the top. --coloring hash and halton:WxH need a packing of a complete set, compact and others one of \
their tiles (see tile), map:FILE any set that has the tiles of the file. --lookup formula needs no table, but the packing that find --method construct \
gives without a seed.

Examples:
  tilepack find --kind corner --colors 3 -o corner.json
  tilepack find --kind wang --colors 3 --set compact -o wang.json
  tilepack export corner.json --to preview-svg --indices -o corner.svg
  tilepack export corner.json --to contact-sheet -o tiles.svg
  tilepack export corner.json --to demo-png --size 32x18 --tile-size 32 --seed 7 -o demo.png
  tilepack export corner.json --to tiled-tsx --image atlas.png --tile-size 32 -o corner.tsx
  tilepack export corner.json --to tiled-tmx --tileset corner.tsx --tile-size 32 -o map.tmx
  tilepack export corner.json --to godot-tres --image atlas.png -o corner.tres
  tilepack export corner.json --to texturepacker-hash --image atlas.png -o corner.tp.json
  tilepack export corner.json --to obj --image atlas.png --size 24x24 -o ground.obj
  tilepack export corner.json --to puzzle-svg --tile-size 40 -o puzzle.svg
  tilepack export corner.json --to preview-png --tile-size 16 -o corner.png
  tilepack export corner.json --to glsl-es-300 --lookup formula -o tiling.glsl
  tilepack export corner.json --to wgsl --coloring halton:512x512 --name ground
  tilepack export wang.json --to hlsl --coloring map:wang.json -o tiling.hlsl --json

JSON fields (--json): result (written), format, file; of tile sets and frames image, image_width, \
image_height; of maps, models and demos tiling (how it was laid), of models material; of ktx2 and \
dds width, height, levels.";

/// Examples for `import`.
pub const IMPORT: &str = "\
A wangset (in Tiled: a terrain set) of corners or edges becomes a tile set as find reads it. One \
color list serves all edges in Tiled. Where no color is on horizontal and on vertical edges, each \
sort gets its own, in the order of the list; else both have the same numbers. Colors that no tile \
shows are left out. Two tiles with the same colors, unset colors, and colors on edges and corners \
at once are refused.

A tile set does not keep the order of the tiles; table in --json says which tile of ours each of \
Tiled is.

Examples:
  tilepack find --kind wang --colors 2 -o wang.json
  tilepack export wang.json --to tiled-tsx -o wang.tsx
  tilepack import wang.tsx -o set.json
  tilepack find --set set.json --size 4x4 -o packed.json

JSON fields (--json): result (imported), wangset, kind, colors, tiles, file, table (id in Tiled, \
tile), horizontal_colors and vertical_colors (the numbers in Tiled of colors 0, 1, ...; the same for \
corners), doubles (left out: id, and first with these colors), unset (left out).";

/// Examples for `tile`.
pub const TILE: &str = "\
An endless tiling gives every place a tile without those before it; shaders do the same (see \
export --to). X counts to the east, Y to the north, both from -2^62 to 2^62. Windows are written as \
pictures are read, from the north.

--coloring, and the tiles that it needs in --packing:
  hash                random corners or edges: all tiles over the colors
  two-hash            Wang tiles, edges by two hashes of their ends: all tiles
  halton:WxH          corners that keep equal colors apart, then repeated: all tiles
  table, long-period  hashes by permutations, of period 24 and 5930659848: all tiles
  compact             corner tiles: the 2 C^3 tiles of the xor set where C is 2, 4, 8, ...,
                      else of the difference set; Wang tiles: C^3 tiles, whose edges are
                      sums of one hash
  diagonal            corner tiles: the 2 C^3 tiles of the diagonal set; simple, but streaky
  probabilities:FILE  corner tiles: those that the map in the file admits, a text or a PNG
                      (docs/formats.md); with probabilities:WxH:FILE cells of W x H points
  map:FILE            the tiles of the file, whose south-west tile is the one at 0 0
  scanline            tile after tile, corner tiles from the south: the tiles of --packing or
                      --set; what is laid depends on where the window begins

--set-out writes the tiles needed, so that find --set packs them. --stats counts a window: misfits, \
tiles seen, chi2 of their numbers per degree of freedom, equal neighbors, dependence of points.

Examples:
  tilepack tile --kind corner --colors 3 --seed 7 -5 12
  tilepack tile --kind wang --colors 2,3 --coloring halton:256x256 0 0 --size 16x4
  tilepack tile --kind wang --colors 3 --coloring compact 0 0 --set-out s.json
  tilepack find --set s.json -o q.json; tilepack tile 5 2 --packing q.json --coloring compact
  tilepack tile --kind corner --colors 4 --coloring compact 0 0 --size 256x256 --stats
  tilepack tile --kind corner --colors 3 --coloring scanline 0 0 --size 9x9
  tilepack find --kind corner --colors 3 -o p.json; tilepack tile 5 2 --packing p.json --json
  tilepack tile --packing p.json --coloring map:p.json 0 0 --size 9x9

JSON fields (--json): kind, colors, coloring, seed, tiles, a list of objects with x, y, tile, sides, \
and with --packing the row and column of its cell. With --stats instead of tiles: width, height, \
misfits, seen, set (its tiles), chi2_per_df (null where tiles are not equally likely), \
equal_neighbors (null for Wang tiles), information (bits) and its lag, row_agreement, \
column_agreement, entropy (bits a tile).";
