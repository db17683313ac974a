// A coordinate modulo a size, never negative.
fn NAME_around(at: i32, size: u32) -> u32 {
    if (at < 0) {
        return size - 1u - u32(-1 - at) % size;
    }
    return u32(at) % size;
}
