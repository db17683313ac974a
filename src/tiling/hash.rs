//! Integer hashes of places, the same bit by bit on every processor.
//!
//! [`mix`] multiplies and shifts 32 bits so that each bit of its argument changes each bit of the
//! result in half of the cases (the constants are those of `lowbias32`, found by C. Wellons,
//! *Prospecting for hash functions*, 2018); it is a bijection and 0 stays 0. [`hash3`] nests it, so
//! that neither coordinate can make up for the other. All arithmetic is modulo `2^32`, which CPUs,
//! GLSL, HLSL and WGSL agree on.

/// A bijection of 32 bits without visible pattern.
pub const fn mix(x: u32) -> u32 {
    let mut h = x;
    h ^= h >> 16;
    h = h.wrapping_mul(0x7feb_352d);
    h ^= h >> 15;
    h = h.wrapping_mul(0x846c_a68b);
    h ^ (h >> 16)
}

/// What [`hash3`] begins with: the seed, mixed.
pub const fn key(seed: u32) -> u32 {
    mix(seed.wrapping_add(0x9e37_79b9))
}

/// The hash of a place; negative coordinates in two's complement.
pub const fn hash3(seed: u32, x: u32, y: u32) -> u32 {
    mix(x.wrapping_add(mix(y.wrapping_add(key(seed)))))
}

/// A number below `n` from a hash: its upper bits, which are the better ones.
pub const fn uni(hash: u32, n: u32) -> u32 {
    ((hash as u64 * n as u64) >> 32) as u32
}
