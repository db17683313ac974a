// The color of a point: when the Halton sequence visits it, in COLORS parts of equal length. The
// grid of P1 = 2^N1 by P2 = 3^N2 points repeats. (Schlömer 2012, section 2.4.)
fn NAME_color(x: i32, y: i32, colors: u32) -> u32 {
    // The column, its binary digits reversed.
    var column: u32 = u32(x) & (NAME_P1 - 1u);
    var l1: u32 = 0u;
    for (var i: u32 = 0u; i < NAME_N1; i = i + 1u) {
        l1 = l1 * 2u + (column & 1u);
        column = column >> 1u;
    }
    // The row, never negative, its ternary digits reversed.
    var row: u32 = u32(y) % NAME_P2;
    if (y < 0) {
        row = NAME_P2 - 1u - u32(-1 - y) % NAME_P2;
    }
    var l2: u32 = 0u;
    for (var j: u32 = 0u; j < NAME_N2; j = j + 1u) {
        l2 = l2 * 3u + row % 3u;
        row = row / 3u;
    }
    // The visit has these two remainders.
    var visit: u32 = NAME_P2 * ((l1 * NAME_M1) & (NAME_P1 - 1u)) + NAME_P1 * ((l2 * NAME_M2) % NAME_P2);
    if (visit >= NAME_P1 * NAME_P2) {
        visit = visit - NAME_P1 * NAME_P2;
    }
    // visit * colors / (P1 * P2) by long division: 32 bits do not hold the product.
    var color: u32 = 0u;
    var rest: u32 = 0u;
    for (var bit: u32 = 128u; bit > 0u; bit = bit >> 1u) {
        color = color * 2u;
        rest = rest * 2u;
        if ((colors & bit) != 0u) {
            rest = rest + visit;
        }
        color = color + rest / (NAME_P1 * NAME_P2);
        rest = rest % (NAME_P1 * NAME_P2);
    }
    return color;
}
