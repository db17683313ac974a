// The column and row of a tile in the atlas, row 0 the northmost: row i is the ring, rotated by
// i (i - 1) / 2, so its upper pair and its lower pair say where it is.
fn NAME_cell(sides: vec4u) -> vec2u {
    let n: u32 = NAME_CH * NAME_CH;
    let above: u32 = NAME_ring(NAME_CH, sides.w, sides.x);
    let below: u32 = NAME_ring(NAME_CH, sides.z, sides.y);
    let row: u32 = (below + n - above) % n;
    let rotation: u32 = (row * (row - 1u) / 2u) % n;
    return vec2u((above + n - rotation) % n, row);
}
