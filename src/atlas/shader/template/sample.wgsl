// The texture within a tile: INSIDE goes from its south-west corner (0, 0) to its north-east one
// (1, 1), DX and DY are the derivatives of the position, in tiles, along the screen. They are of the
// position that has no jumps, or mip levels break at the borders of tiles.
fn NAME_sample(tile: vec2i, inside: vec2f, dx: vec2f, dy: vec2f, SAMPLE_PARAMETERS) -> vec4f {
    let cell: vec2u = NAME_cell(NAME_sides(tile.x, tile.yMAP_ARGUMENT)TABLE_ARGUMENT);
    let size: vec2f = vec2f(f32(NAME_WIDTH), f32(NAME_HEIGHT));
    let at: vec2f = vec2f(f32(cell.x) + inside.x, f32(cell.y) + 1.0 - inside.y) / size;
    // Rows of the atlas go south.
    let along: vec2f = vec2f(dx.x, -dx.y) / size;
    let up: vec2f = vec2f(dy.x, -dy.y) / size;
    return SAMPLE_GRAD(at, along, up);
}

// The texture at a position in tiles; in fragment shaders only, and not where only some pixels get to,
// for it takes derivatives. Beyond some thousand tiles from the origin, give NAME_sample the tile and
// the position inside it apart: a float holds 24 bits.
fn NAME_texture(position: vec2f, SAMPLE_PARAMETERS) -> vec4f {
    let tile: vec2f = floor(position);
    return NAME_sample(vec2i(tile), position - tile, dpdx(position), dpdy(position), SAMPLE_ARGUMENTS);
}
