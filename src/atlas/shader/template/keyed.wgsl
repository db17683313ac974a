// The hash of a point, modulo 2^32; a key is mix(seed + 0x9e3779b9).
fn NAME_hash(x: i32, y: i32, key: u32) -> u32 {
    return NAME_mix(u32(x) + NAME_mix(u32(y) + key));
}

// A number below n, at most 2^16: the upper 32 bits of h * n, put together of two halves.
fn NAME_uni(h: u32, n: u32) -> u32 {
    let low: u32 = (h & 0xffffu) * n;
    return ((h >> 16u) * n + (low >> 16u)) >> 16u;
}
