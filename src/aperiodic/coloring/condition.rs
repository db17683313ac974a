//! When tilings by the corner tiles give tilings by the Wang tiles.
//!
//! A pair of colors at the ends of a side has the labels that occur there. The options of a
//! corner tile are all Wang tiles whose labels its four pairs have.
//!
//! * *Pair*: every pair has one label.
//! * *Radius r*: options that fit no option of some neighbor go, and that r times; at the end one
//!   is left wherever the tiles up to r steps away can stand in a tiling, and neighbors fit. What
//!   has no legal margin around it cannot stand in a tiling.
//!
//! In both cases corner tiles give Wang tiles, cell by cell, and a period of the one tiling is a
//! period of the other. Corner tiles are bits of a word here, and Wang tiles of another.

use super::vertices::Vertices;
use std::collections::{BTreeMap, BTreeSet};

/// A sufficient condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// Pairs of colors have one label.
    Pair,
    /// Options are settled by the tiles up to so many steps away.
    Radius(usize),
}

impl Condition {
    /// `pair`, `radius1` and so on.
    pub fn name(self) -> &'static str {
        match self {
            Condition::Pair => "pair",
            Condition::Radius(1) => "radius1",
            Condition::Radius(_) => "radius2",
        }
    }
}

/// The most corner tiles, and Wang tiles, that are looked at: bits of a word.
pub const MOST_TILES: usize = 128;
/// Surroundings looked at, at most; more than any set of a few dozen tiles needs.
const PATIENCE: u64 = 3_000_000;

/// The corner tiles that a coloring makes, and what they may stand for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Colored {
    /// The corner tiles [NW, NE, SE, SW], sorted.
    pub tiles: Vec<[u8; 4]>,
    /// The Wang tiles that occur at each.
    pub image: Vec<Vec<usize>>,
    /// The Wang tiles whose labels occur at its pairs.
    pub options: Vec<Vec<usize>>,
}

impl Colored {
    /// The corner tiles of a coloring, which gives each class a color.
    pub fn new(vertices: &Vertices, colors: &[u8]) -> Self {
        let mut found: BTreeMap<[u8; 4], BTreeSet<usize>> = BTreeMap::new();
        for &(classes, wang) in &vertices.cells {
            found.entry(classes.map(|class| colors[class])).or_default().insert(wang);
        }
        let mut labels: BTreeSet<(bool, [u8; 2], u32)> = BTreeSet::new();
        for (flat, ends, label) in vertices.sides() {
            labels.insert((flat, ends.map(|class| colors[class]), label));
        }
        let fits = |tile: [u8; 4], wang: &[u32; 4]| {
            (0..4).all(|side| labels.contains(&(side % 2 == 0, ends(tile, side), wang[side])))
        };
        let options = found.keys().map(|&tile| {
            let wang = vertices.wang.iter().enumerate();
            wang.filter(|(_, wang)| fits(tile, wang)).map(|(number, _)| number).collect()
        });
        let options = options.collect();
        let image = found.values().map(|wang| wang.iter().copied().collect()).collect();
        Self { tiles: found.into_keys().collect(), image, options }
    }

    /// Whether a condition holds. A set too large or too tangled to say does not count.
    pub fn meets(&self, condition: Condition, wang: &[[u32; 4]]) -> bool {
        let radius = match condition {
            Condition::Pair => return self.pairs_have_one_label(wang),
            Condition::Radius(radius) => radius,
        };
        self.tiles.len() <= MOST_TILES
            && wang.len() <= MOST_TILES
            && Decoding::new(self, wang, radius).is_some_and(|mut decoding| decoding.holds())
    }

    fn pairs_have_one_label(&self, wang: &[[u32; 4]]) -> bool {
        let mut label = BTreeMap::new();
        self.tiles.iter().zip(&self.image).all(|(&tile, image)| {
            image.iter().all(|&w| {
                (0..4).all(|side| {
                    let pair = (side % 2 == 0, ends(tile, side));
                    *label.entry(pair).or_insert(wang[w][side]) == wang[w][side]
                })
            })
        })
    }
}

/// The colors at the ends of a side N, E, S, W, from the west or the north on.
fn ends([nw, ne, se, sw]: [u8; 4], side: usize) -> [u8; 2] {
    [[nw, ne], [ne, se], [sw, se], [nw, sw]][side % 4]
}

/// All surroundings, by backtracking.
struct Decoding {
    /// For each direction and corner tile, the corner tiles that fit there.
    fitting: [Vec<u128>; 4],
    /// For each corner tile its options.
    options: Vec<u128>,
    /// For each direction and Wang tile the Wang tiles that fit there.
    wang: [Vec<u128>; 4],
    radius: usize,
    all: u128,
    left: u64,
}

const STEPS: [(isize, isize); 4] = [(-1, 0), (0, 1), (1, 0), (0, -1)];

/// The cells around one or two middle ones.
struct Frame {
    /// For each cell the neighbor in each direction.
    next: Vec<[Option<usize>; 4]>,
    middles: Vec<usize>,
    /// Cells in the order in which they are filled, without the middles.
    order: Vec<usize>,
    /// How many of them are read.
    read: usize,
}

impl Frame {
    /// The frame of a cell, or of a cell and its neighbor in a direction.
    fn new(radius: usize, neighbor: Option<usize>) -> Self {
        let reach = radius as isize + 1;
        let (down, right) = neighbor.map_or((0, 0), |direction| STEPS[direction]);
        let (height, width) = (2 * reach + 1 + down, 2 * reach + 1 + right);
        let number = |row: isize, column: isize| {
            let inside = (0..height).contains(&row) && (0..width).contains(&column);
            inside.then_some((row * width + column) as usize)
        };
        let at = |cell: usize| (cell as isize / width, cell as isize % width);
        let cells = (height * width) as usize;
        let next = (0..cells).map(|cell| {
            let (row, column) = at(cell);
            STEPS.map(|(down, right)| number(row + down, column + right))
        });
        let mut middles: Vec<usize> = number(reach, reach).into_iter().collect();
        if neighbor.is_some() {
            middles.extend(number(reach + down, reach + right));
        }
        let apart = |&cell: &usize| {
            let (row, column) = at(cell);
            let from = |&middle: &usize| {
                let (r, c) = at(middle);
                (row.abs_diff(r) + column.abs_diff(c), row.abs_diff(r))
            };
            middles.iter().map(from).min().unwrap_or_default()
        };
        let mut order: Vec<usize> = (0..cells).filter(|cell| !middles.contains(cell)).collect();
        order.sort_by_key(apart);
        let read = order.iter().filter(|&cell| apart(cell).0 <= radius).count();
        let next = next.collect();
        Self { next, middles, order, read }
    }
}

impl Decoding {
    fn new(colored: &Colored, wang: &[[u32; 4]], radius: usize) -> Option<Self> {
        let tiles = &colored.tiles;
        let meet = |side: usize| {
            let of = |&tile: &[u8; 4]| {
                let there = |(i, &other): (usize, &[u8; 4])| {
                    u128::from(ends(tile, side) == ends(other, side + 2)) << i
                };
                tiles.iter().enumerate().map(there).sum()
            };
            tiles.iter().map(of).collect()
        };
        let meet_wang = |side: usize| {
            let of = |tile: &[u32; 4]| {
                let there = |(i, other): (usize, &[u32; 4])| {
                    u128::from(tile[side] == other[(side + 2) % 4]) << i
                };
                wang.iter().enumerate().map(there).sum()
            };
            wang.iter().map(of).collect()
        };
        let bits = |options: &Vec<usize>| options.iter().map(|&option| 1 << option).sum();
        let options: Vec<u128> = colored.options.iter().map(bits).collect();
        let any = options.iter().all(|&options| options != 0);
        any.then(|| Self {
            fitting: [0, 1, 2, 3].map(meet),
            options,
            wang: [0, 1, 2, 3].map(meet_wang),
            radius,
            all: u128::MAX >> (MOST_TILES - tiles.len()),
            left: PATIENCE,
        })
    }

    /// Whether every surrounding is read as it should be.
    fn holds(&mut self) -> bool {
        let tiles = self.options.len();
        let alone = Frame::new(self.radius, None);
        let mut cells = vec![usize::MAX; alone.next.len()];
        for tile in 0..tiles {
            cells[alone.middles[0]] = tile;
            if self.options[tile].count_ones() > 1 && !self.all_read(&alone, &mut cells, 0) {
                return false;
            }
        }
        for direction in [1, 2] {
            let frame = Frame::new(self.radius, Some(direction));
            let mut cells = vec![usize::MAX; frame.next.len()];
            for one in 0..tiles {
                let mut others = self.fitting[direction][one];
                while others != 0 {
                    let two = others.trailing_zeros() as usize;
                    others &= others - 1;
                    if self.always_fit(direction, one, two) {
                        continue;
                    }
                    (cells[frame.middles[0]], cells[frame.middles[1]]) = (one, two);
                    if !self.all_read(&frame, &mut cells, 0) {
                        return false;
                    }
                }
            }
        }
        true
    }

    /// Whether any two options of two corner tiles fit.
    fn always_fit(&self, direction: usize, one: usize, two: usize) -> bool {
        bits(self.options[one]).all(|wang| self.options[two] & !self.wang[direction][wang] == 0)
    }

    /// Whether, however the cells that are still free are filled, the middle is read right.
    fn all_read(&mut self, frame: &Frame, cells: &mut [usize], filled: usize) -> bool {
        if self.left == 0 {
            return false;
        }
        self.left -= 1;
        if filled == frame.read {
            return self.is_right(frame, cells) || !self.continues(frame, cells, filled);
        }
        let cell = frame.order[filled];
        let mut fitting = self.candidates(frame, cells, cell);
        while fitting != 0 {
            cells[cell] = fitting.trailing_zeros() as usize;
            fitting &= fitting - 1;
            if !self.all_read(frame, cells, filled + 1) {
                cells[cell] = usize::MAX;
                return false;
            }
        }
        cells[cell] = usize::MAX;
        true
    }

    /// Whether the rest can be filled.
    fn continues(&mut self, frame: &Frame, cells: &mut [usize], filled: usize) -> bool {
        let Some(&cell) = frame.order.get(filled) else { return true };
        let mut fitting = self.candidates(frame, cells, cell);
        while fitting != 0 {
            cells[cell] = fitting.trailing_zeros() as usize;
            fitting &= fitting - 1;
            let can = self.continues(frame, cells, filled + 1);
            cells[cell] = usize::MAX;
            if can {
                return true;
            }
        }
        false
    }

    /// The corner tiles that fit what is around a cell.
    fn candidates(&self, frame: &Frame, cells: &[usize], cell: usize) -> u128 {
        let mut fitting = self.all;
        for (direction, next) in frame.next[cell].iter().enumerate() {
            let there = next.map_or(usize::MAX, |next| cells[next]);
            if there != usize::MAX {
                fitting &= self.fitting[(direction + 2) % 4][there];
            }
        }
        fitting
    }

    /// The options of a cell that are left after so many steps.
    fn settled(&self, frame: &Frame, cells: &[usize], cell: usize, radius: usize) -> u128 {
        let mut options = self.options[cells[cell]];
        if radius == 0 || options.count_ones() == 1 {
            return options;
        }
        for (direction, next) in frame.next[cell].iter().enumerate() {
            let Some(next) = *next else { continue };
            let theirs = self.settled(frame, cells, next, radius - 1);
            let back = &self.wang[(direction + 2) % 4];
            options &= bits(theirs).fold(0, |fit, wang| fit | back[wang]);
        }
        options
    }

    /// Whether the middles stand for one Wang tile each, and these fit.
    fn is_right(&self, frame: &Frame, cells: &[usize]) -> bool {
        let read = |&cell: &usize| self.settled(frame, cells, cell, self.radius);
        match frame.middles[..] {
            [ref one, ref two] => {
                let (first, second) = (read(one), read(two));
                let direction = if two - one == 1 { 1 } else { 2 };
                first.count_ones() == 1
                    && second.count_ones() == 1
                    && self.wang[direction][first.trailing_zeros() as usize] & second != 0
            }
            _ => frame.middles.iter().all(|middle| read(middle).count_ones() == 1),
        }
    }
}

/// The numbers of the bits of a word.
fn bits(mut word: u128) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = (word != 0).then(|| word.trailing_zeros() as usize)?;
        word &= word - 1;
        Some(bit)
    })
}
