//! The definitions, by trying everything.

/// Whether Wang or corner tiles fill a torus (or, when `open`, a rectangle).
pub(crate) fn fills(
    tiles: &[[u32; 4]],
    corner: bool,
    (width, height): (usize, usize),
    open: bool,
) -> bool {
    let mut cells = Vec::new();
    fill(tiles, corner, (width, height), open, &mut cells)
}

fn fits(corner: bool, one: [u32; 4], other: [u32; 4], east: bool) -> bool {
    match (corner, east) {
        (false, true) => one[1] == other[3],
        (false, false) => one[2] == other[0],
        (true, true) => (one[1], one[2]) == (other[0], other[3]),
        (true, false) => (one[3], one[2]) == (other[0], other[1]),
    }
}

fn fill(
    tiles: &[[u32; 4]],
    corner: bool,
    (width, height): (usize, usize),
    open: bool,
    cells: &mut Vec<[u32; 4]>,
) -> bool {
    let at = cells.len();
    if at == width * height {
        return true;
    }
    let (row, column) = (at / width, at % width);
    tiles.iter().any(|&tile| {
        cells.push(tile);
        let good = (column == 0 || fits(corner, cells[at - 1], tile, true))
            && (row == 0 || fits(corner, cells[at - width], tile, false))
            && (open || column + 1 < width || fits(corner, tile, cells[row * width], true))
            && (open || row + 1 < height || fits(corner, tile, cells[column], false));
        let done = good && fill(tiles, corner, (width, height), open, cells);
        cells.pop();
        done
    })
}

/// The cells of the smallest torus with at most `most` of them.
pub(crate) fn smallest_torus(tiles: &[[u32; 4]], corner: bool, most: usize) -> Option<usize> {
    (1..=most).find(|area| {
        let widths = (1..=*area).filter(|width| area % width == 0);
        widths.into_iter().any(|width| fills(tiles, corner, (width, area / width), false))
    })
}

/// The side of the smallest square that cannot be filled, at most `most`.
pub(crate) fn smallest_square(tiles: &[[u32; 4]], corner: bool, most: usize) -> Option<usize> {
    (1..=most).find(|&side| !fills(tiles, corner, (side, side), true))
}
