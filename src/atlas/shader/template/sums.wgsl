// The color of a point, as part of horizontal edges.
fn NAME_horizontal(x: i32, y: i32) -> u32 {
    return NAME_uni(NAME_hash(x, y, NAME_KEY), NAME_CH);
}

// The same for vertical edges.
fn NAME_vertical(x: i32, y: i32) -> u32 {
    return NAME_uni(NAME_hash(x, y, NAME_KEY_VERTICAL), NAME_CV);
}

// The colors of the tile (x, y): N, E, S, W. An edge has the sum of the colors of its ends. (Lagae
// 2007, section 4.3.)
fn NAME_sides(x: i32, y: i32) -> vec4u {
    return vec4u(
        (NAME_horizontal(x, y + 1) + NAME_horizontal(x + 1, y + 1)) % NAME_CH,
        (NAME_vertical(x + 1, y + 1) + NAME_vertical(x + 1, y)) % NAME_CV,
        (NAME_horizontal(x, y) + NAME_horizontal(x + 1, y)) % NAME_CH,
        (NAME_vertical(x, y + 1) + NAME_vertical(x, y)) % NAME_CV
    );
}
