// The colors of the tile (x, y): N, E, S, W.
fn NAME_sides(x: i32, y: i32, MAP_PARAMETER) -> vec4u {
    let here: vec2u = NAME_map(x, y, map);
    return vec4u(here.x, NAME_map(x + 1, y, map).y, NAME_map(x, y - 1, map).x, here.y);
}
