// The color of a point: bit i is the exclusive or of the random bits of the points j to the west and
// i - j to the south for which binomial(i, j) is odd.
fn NAME_color(x: i32, y: i32, colors: u32) -> u32 {
    var color: u32 = 0u;
    for (var i: u32 = 0u; i < NAME_BITS; i = i + 1u) {
        var digit: u32 = 0u;
        for (var j: u32 = 0u; j <= i; j = j + 1u) {
            if ((j & (i - j)) == 0u) {
                digit = digit ^ (NAME_hash(x - i32(j), y - i32(i - j), NAME_KEY) >> 31u);
            }
        }
        color = color | (digit << i);
    }
    return color;
}
