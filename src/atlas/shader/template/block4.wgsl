// A number of the map, 256 in a row: first the patterns of 4 x 4 tiles in order of their classes, then
// from 65536 on where the patterns of every class begin.
fn NAME_entry(at: u32, MAP_PARAMETER) -> u32 {
    return FETCH_MAP_X(vec2i(i32(at & 255u), i32(at >> 8u)));
}

// The color of a point on the frame of the blocks.
fn NAME_frame(x: i32, y: i32) -> u32 {
    return NAME_uni(NAME_hash(x, y, NAME_KEY), 3u);
}

// The color of the point in column u and row v of a block, each 0 to 4: that of the frame in the south,
// in the west, and the sum of the pattern between.
fn NAME_inside(pattern: u32, south: u32, west: u32, first: u32, u: u32, v: u32) -> u32 {
    var sum: u32 = south + west + 3u - first;
    for (var j: u32 = 0u; j < v; j = j + 1u) {
        for (var i: u32 = 0u; i < u; i = i + 1u) {
            sum = sum + ((pattern >> (4u * j + i)) & 1u);
        }
    }
    return sum % 3u;
}

// The colors of the tile (x, y), all of which are of one block: NE, SE, SW, NW.
fn NAME_sides(x: i32, y: i32, MAP_PARAMETER) -> vec4u {
    let x0: i32 = (x >> 2u) * 4;
    let y0: i32 = (y >> 2u) * 4;
    // What the frame says about the sums of the pattern along its rows and columns, modulo 3.
    var kind: u32 = 0u;
    var weight: u32 = 1u;
    for (var v: i32 = 0; v < 4; v = v + 1) {
        let row: u32 = NAME_frame(x0 + 4, y0 + v + 1) + NAME_frame(x0, y0 + v) + 6u - NAME_frame(x0 + 4, y0 + v) - NAME_frame(x0, y0 + v + 1);
        kind = kind + weight * (row % 3u);
        weight = weight * 3u;
    }
    for (var u: i32 = 0; u < 3; u = u + 1) {
        let column: u32 = NAME_frame(x0 + u + 1, y0 + 4) + NAME_frame(x0 + u, y0) + 6u - NAME_frame(x0 + u, y0 + 4) - NAME_frame(x0 + u + 1, y0);
        kind = kind + weight * (column % 3u);
        weight = weight * 3u;
    }
    let begin: u32 = NAME_entry(65536u + kind, map);
    let count: u32 = NAME_entry(65536u + kind + 1u, map) - begin;
    let hash: u32 = NAME_hash(x >> 2u, y >> 2u, NAME_KEY_BLOCK);
    let pattern: u32 = NAME_entry(begin + NAME_uni(hash, count), map);
    let first: u32 = NAME_frame(x0, y0);
    let left: u32 = NAME_frame(x, y0);
    let right: u32 = NAME_frame(x + 1, y0);
    let low: u32 = NAME_frame(x0, y);
    let high: u32 = NAME_frame(x0, y + 1);
    let column: u32 = u32(x - x0);
    let row: u32 = u32(y - y0);
    return vec4u(
        NAME_inside(pattern, right, high, first, column + 1u, row + 1u),
        NAME_inside(pattern, right, low, first, column + 1u, row),
        NAME_inside(pattern, left, low, first, column, row),
        NAME_inside(pattern, left, high, first, column, row + 1u)
    );
}
