// The color of a point: its diagonal is cut into pieces of 16 steps, from one random color to the
// next, and in every step the color doubles and gains a bit. KEY, KEY_ENDS and KEY_BITS are of the
// hashes for the place of the cuts, the colors there, and the bits between.
fn NAME_color(x: i32, y: i32, colors: u32) -> u32 {
    let diagonal: i32 = x - y;
    let along: i32 = y + i32(NAME_uni(NAME_hash(diagonal, 0, NAME_KEY), 16u));
    let piece: i32 = along >> 4u;
    let at: u32 = u32(along) & 15u;
    let begin: u32 = NAME_uni(NAME_hash(diagonal, piece, NAME_KEY_ENDS), colors);
    let end: u32 = NAME_uni(NAME_hash(diagonal, piece + 1, NAME_KEY_ENDS), colors);
    let rest: u32 = (end + colors * 65536u - begin * 65536u) % colors;
    let count: u32 = (65535u - rest) / colors + 1u;
    let bits: u32 = rest + colors * NAME_uni(NAME_hash(diagonal, piece, NAME_KEY_BITS), count);
    return ((begin << at) + (bits >> (16u - at))) % colors;
}
