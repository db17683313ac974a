// The column and row of a tile in the atlas, row 0 the northmost: its places in two rings. (Wei
// 2004; Lagae 2007, 5.5.2.)
fn NAME_cell(sides: vec4u) -> vec2u {
    return vec2u(NAME_ring(NAME_CV, sides.w, sides.y), NAME_ring(NAME_CH, sides.x, sides.z));
}
