// Where the pair (x, y) stands in the least ring of all pairs of colors.
fn NAME_ring(colors: u32, x: u32, y: u32) -> u32 {
    let block: u32 = min(x, y);
    let start: u32 = colors * colors - (colors - block) * (colors - block);
    if (y > x) {
        return start + 2u * (y - x) - 1u;
    }
    if (x == colors - 1u) {
        // The last color of a block is followed by the next block, the very last by the first.
        if (y == 0u) {
            return colors * colors - 1u;
        }
        return start - 1u;
    }
    return start + 2u * (x - y);
}
