//! Packings of compact sets, constructed: milliseconds for sets of thousands of tiles.
//!
//! Corner sets of `2 C^3` tiles come from the rows of a Latin square ([`shifts`], [`groups`])
//! wherever a side of the torus is `C m` with `m` a divisor of `C`, from a few tori of few colors
//! ([`narrow`]), and from numbered copies of a packing over fewer colors ([`copies`]). Together
//! they cover the near-square shape for 2 to 32 colors, each of them. Wang sets of `2 CH CV`
//! tiles come in every shape by putting pairs (N, W) down at random and swapping a few ([`wang`]).
//!
//! Whether there is a construction depends on the random choices in rare cases only, and what
//! is given is right: every construction is checked for what a compact set asks before it is
//! returned. Source: this project.

pub mod copies;
pub mod groups;
pub mod narrow;
pub mod shifts;
pub mod wang;

use crate::tiles::{Kind, TileSet};
use crate::torus::Shape;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// A packing of a compact set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Compact {
    /// The labels, as in [`crate::torus::Lattice`].
    pub labels: Vec<u8>,
    /// How it was constructed, in words.
    pub name: String,
}

/// A packing of a compact set, or `None` when no construction is known; another seed gives
/// another packing.
pub fn construct(set: &TileSet, shape: Shape, seed: u64) -> Option<Compact> {
    if !set.is_compact() || set.size() != shape.cells() as u64 {
        return None;
    }
    match set.kind() {
        Kind::Corner => {
            let (colors, columns) = (set.colors().horizontal(), shape.width());
            let found = corner(colors, columns, shape.height(), seed)?;
            is_compact(colors, columns, &found.labels).then_some(found)
        }
        Kind::Wang => {
            let named = |labels, name: &str| Compact { labels, name: name.to_owned() };
            wang::strict(set.colors(), shape, seed)
                .map(|labels| named(labels, "pairs put down and swapped, strict"))
                .or_else(|| {
                    wang::weak(set.colors(), shape, seed)
                        .map(|labels| named(labels, "pairs put down and swapped, weak"))
                })
        }
        Kind::Domino => None,
    }
}

/// Whether a construction is known for a compact corner set on a torus, but for bad luck with
/// random choices.
pub fn covers(colors: usize, columns: usize, rows: usize) -> bool {
    colors >= 2
        && columns * rows == 2 * colors.pow(3)
        && (known(colors, columns, rows).is_some()
            || shifts::suits(colors, columns, rows)
            || shifts::suits(colors, rows, columns)
            || bases(colors, columns, rows).any(|(c, columns, rows)| covers(c, columns, rows)))
}

/// The shapes in which a compact corner set is constructed, from the widest.
pub fn shapes(colors: usize) -> Vec<Shape> {
    let tiles = 2 * colors.pow(3);
    let divisors = (2..=tiles / 2).rev().filter(|width| tiles.is_multiple_of(*width));
    let covered = divisors.filter(|&width| covers(colors, width, tiles / width));
    covered.filter_map(|w| Shape::new(w as u64, (tiles / w) as u64).ok()).collect()
}

/// The packings over fewer colors whose copies give a torus: colors, columns, rows.
fn bases(
    colors: usize,
    columns: usize,
    rows: usize,
) -> impl Iterator<Item = (usize, usize, usize)> {
    let factors = (2..=colors / 2).filter(move |&k| colors.is_multiple_of(k));
    let sides = factors.map(move |k| (k, k.pow(3)));
    let bases = sides.flat_map(move |(k, copies)| {
        let lower = rows.is_multiple_of(copies).then_some((colors / k, columns, rows / copies));
        let thinner =
            columns.is_multiple_of(copies).then_some((colors / k, columns / copies, rows));
        [lower, thinner].into_iter().flatten()
    });
    bases.filter(|&(_, columns, rows)| columns.min(rows) > 1)
}

fn corner(colors: usize, columns: usize, rows: usize, seed: u64) -> Option<Compact> {
    if let Some(labels) = known(colors, columns, rows) {
        let labels = if seed == 0 { labels } else { moved(&labels, columns, colors, seed) };
        return Some(Compact {
            labels,
            name: format!("{columns}x{rows} over {colors} colors, annealed once"),
        });
    }
    if let Some(labels) = shifts::corner(colors, columns, rows, seed) {
        return Some(Compact { labels, name: "shifted rows".to_owned() });
    }
    bases(colors, columns, rows).find_map(|(fewer, w, h)| {
        let base = corner(fewer, w, h, seed)?;
        let k = colors / fewer;
        let labels = if h == rows {
            let turned = reflected(&base.labels, h, w);
            reflected(&copies::stacked(&turned, h, fewer, k), columns, rows)
        } else {
            copies::stacked(&base.labels, w, fewer, k)
        };
        let name = format!("{} copies of {w}x{h} over {fewer} colors ({})", k.pow(3), base.name);
        Some(Compact { labels, name })
    })
}

/// A torus that is written down.
fn known(colors: usize, columns: usize, rows: usize) -> Option<Vec<u8>> {
    let color = |digit: u8| digit - b'0';
    narrow::KNOWN.iter().filter(|(known, _)| *known == colors).find_map(|(_, lines)| {
        let cells: Vec<u8> = lines.iter().flat_map(|line| line.bytes().map(color)).collect();
        let (w, h) = (lines[0].len(), lines.len());
        match (columns, rows) {
            sides if sides == (w, h) => Some(cells),
            sides if sides == (h, w) => Some(reflected(&cells, h, w)),
            _ => None,
        }
    })
}

/// Another packing of the same set: translated, with the colors exchanged.
fn moved(cells: &[u8], columns: usize, colors: usize, seed: u64) -> Vec<u8> {
    let mut rng = Pcg64::seed_from_u64(seed);
    let mut names: Vec<u8> = (0..colors).map(|color| color as u8).collect();
    names.shuffle(&mut rng);
    let rows = cells.len() / columns;
    let (down, right) = (rng.random_range(0..rows), rng.random_range(0..columns));
    let from = |cell: usize| {
        let (row, column) = (cell / columns + down, cell % columns + right);
        row % rows * columns + column % columns
    };
    (0..cells.len()).map(|cell| names[usize::from(cells[from(cell)])]).collect()
}

/// The reflection through the SW-NE diagonal, which keeps NE; `columns` and `rows` afterwards.
fn reflected(cells: &[u8], columns: usize, rows: usize) -> Vec<u8> {
    let from = |cell: usize| {
        let (row, column) = (cell / columns, cell % columns);
        (columns - 1 - column) * rows + (rows - 1 - row)
    };
    (0..cells.len()).map(|cell| cells[from(cell)]).collect()
}

/// Whether every (NW, SW, SE) occurs twice, with different NE.
fn is_compact(colors: usize, columns: usize, cells: &[u8]) -> bool {
    let rows = cells.len() / columns;
    let at =
        |row: usize, column: usize| usize::from(cells[row % rows * columns + column % columns]);
    // Of each triple the NE met first, plus 1, or that there were both.
    const BOTH: u16 = u16::MAX;
    let mut met = vec![0u16; colors.pow(3)];
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let (nw, ne) = (at(row, column), at(row, column + 1));
        let (sw, se) = (at(row + 1, column), at(row + 1, column + 1));
        match &mut met[(nw * colors + sw) * colors + se] {
            none @ 0 => *none = ne as u16 + 1,
            first if *first != BOTH && usize::from(*first) != ne + 1 => *first = BOTH,
            _ => return false,
        }
    }
    met.iter().all(|&met| met == BOTH)
}
