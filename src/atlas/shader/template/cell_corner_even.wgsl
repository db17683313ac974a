// The color of a corner: east (0 or 1) and south (0 or 1) of the north-west one.
fn NAME_corner(sides: vec4u, east: u32, south: u32) -> u32 {
    if (south == 0u) {
        if (east == 0u) {
            return sides.w;
        }
        return sides.x;
    }
    if (east == 0u) {
        return sides.z;
    }
    return sides.y;
}

// The column and row of a tile in the atlas, row 0 the northmost. The low bits of the corners say
// where in a block of 4 by 4 cells it is, the rest of them are the digits of the block.
fn NAME_cell(sides: vec4u) -> vec2u {
    let k: u32 = NAME_CH / 2u;
    let low: u32 = (sides.w & 1u) * 8u + (sides.x & 1u) * 4u + (sides.z & 1u) * 2u + (sides.y & 1u);
    // Sixteen places of four bits each.
    var places: u32 = NAME_PLACES_LOW;
    if (low >= 8u) {
        places = NAME_PLACES_HIGH;
    }
    let place: u32 = (places >> (4u * (low & 7u))) & 15u;
    let row: u32 = place / 4u;
    let column: u32 = place % 4u;
    let re: u32 = row & 1u;
    let ce: u32 = column & 1u;
    var row_digit: u32 = NAME_corner(sides, ce, re) / 2u;
    let row_high: u32 = NAME_corner(sides, ce, 1u - re) / 2u;
    let column_digit: u32 = NAME_corner(sides, 1u - ce, re) / 2u;
    let column_high: u32 = NAME_corner(sides, 1u - ce, 1u - re) / 2u;
    if (row == 3u) {
        // Its even row is in the next block.
        row_digit = (row_digit + k - 1u) % k;
    }
    return vec2u(
        4u * (column_high * k + column_digit) + column,
        4u * (row_high * k + row_digit) + row
    );
}
