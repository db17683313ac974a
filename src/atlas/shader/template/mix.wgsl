// Mixes 32 bits: a bijection (lowbias32, C. Wellons 2018).
fn NAME_mix(x: u32) -> u32 {
    var h: u32 = x;
    h = h ^ (h >> 16u);
    h = h * 0x7feb352du;
    h = h ^ (h >> 15u);
    h = h * 0x846ca68bu;
    return h ^ (h >> 16u);
}
