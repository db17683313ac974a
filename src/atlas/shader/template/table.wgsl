// The column and row of a tile in the atlas, row 0 the northmost. Texel (number % TABLE_W,
// number / TABLE_W) of the table holds row * WIDTH + column.
fn NAME_cell(sides: vec4u, TABLE_PARAMETER) -> vec2u {
    let number: u32 = NAME_number(sides);
    let cell: u32 = FETCH_TABLE(vec2i(i32(number % NAME_TABLE_W), i32(number / NAME_TABLE_W)));
    return vec2u(cell % NAME_WIDTH, cell / NAME_WIDTH);
}
