// The colors of the tile (x, y): NE, SE, SW, NW.
fn NAME_sides(x: i32, y: i32, MAP_PARAMETER) -> vec4u {
    return vec4u(
        NAME_map(x + 1, y, map).x,
        NAME_map(x + 1, y - 1, map).x,
        NAME_map(x, y - 1, map).x,
        NAME_map(x, y, map).x
    );
}
