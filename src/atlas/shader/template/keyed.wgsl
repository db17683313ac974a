// Mixes 32 bits: a bijection (lowbias32, C. Wellons 2018).
fn NAME_mix(x: u32) -> u32 {
    var h: u32 = x;
    h = h ^ (h >> 16u);
    h = h * 0x7feb352du;
    h = h ^ (h >> 15u);
    h = h * 0x846ca68bu;
    return h ^ (h >> 16u);
}

// The hash of a point, modulo 2^32; a key is mix(seed + 0x9e3779b9).
fn NAME_hash(x: i32, y: i32, key: u32) -> u32 {
    return NAME_mix(u32(x) + NAME_mix(u32(y) + key));
}

// A number below n, at most 2^16: the upper 32 bits of h * n, put together of two halves.
fn NAME_uni(h: u32, n: u32) -> u32 {
    let low: u32 = (h & 0xffffu) * n;
    return ((h >> 16u) * n + (low >> 16u)) >> 16u;
}
