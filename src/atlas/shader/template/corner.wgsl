// The colors of the tile (x, y), whose south-west corner is the point (x, y): NE, SE, SW, NW.
fn NAME_sides(x: i32, y: i32, MAP_PARAMETER) -> vec4u {
    return vec4u(
        NAME_color(x + 1, y + 1, NAME_CHMAP_ARGUMENT),
        NAME_color(x + 1, y, NAME_CHMAP_ARGUMENT),
        NAME_color(x, y, NAME_CHMAP_ARGUMENT),
        NAME_color(x, y + 1, NAME_CHMAP_ARGUMENT)
    );
}
