// The colors of a cell of the map, MAP_W by MAP_H cells, repeated: its north-west corner, or its
// north and west edges. Row 0 is the northmost; the south-west cell is the tile (0, 0).
fn NAME_map(x: i32, y: i32, MAP_PARAMETER) -> vec2u {
    var column: u32 = u32(x) % NAME_MAP_W;
    if (x < 0) {
        column = NAME_MAP_W - 1u - u32(-1 - x) % NAME_MAP_W;
    }
    var up: u32 = u32(y) % NAME_MAP_H;
    if (y < 0) {
        up = NAME_MAP_H - 1u - u32(-1 - y) % NAME_MAP_H;
    }
    return FETCH_MAP_XY(vec2i(i32(column), i32(NAME_MAP_H - 1u - up)));
}
