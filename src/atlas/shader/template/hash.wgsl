// The hash of a point, modulo 2^32; KEY is mix(seed + 0x9e3779b9).
fn NAME_hash(x: i32, y: i32) -> u32 {
    return NAME_mix(u32(x) + NAME_mix(u32(y) + NAME_KEY));
}

// The color of a point: the upper 32 bits of hash * colors, put together of two halves.
fn NAME_color(x: i32, y: i32, colors: u32) -> u32 {
    let h: u32 = NAME_hash(x, y);
    let low: u32 = (h & 0xffffu) * colors;
    return ((h >> 16u) * colors + (low >> 16u)) >> 16u;
}
