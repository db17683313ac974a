// The colors of the tile (x, y): N, E, S, W. Its edges are points of a lattice twice as fine, the
// south one (2x + 1, 2y) and the west one (2x, 2y + 1).
fn NAME_sides(x: i32, y: i32, MAP_PARAMETER) -> vec4u {
    return vec4u(
        NAME_color(2 * x + 1, 2 * y + 2, NAME_CHMAP_ARGUMENT),
        NAME_color(2 * x + 2, 2 * y + 1, NAME_CVMAP_ARGUMENT),
        NAME_color(2 * x + 1, 2 * y, NAME_CHMAP_ARGUMENT),
        NAME_color(2 * x, 2 * y + 1, NAME_CVMAP_ARGUMENT)
    );
}
