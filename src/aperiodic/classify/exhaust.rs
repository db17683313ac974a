//! No aperiodic set of at most n corner tiles over two or three colors: a proof by exhaustion.
//!
//! If there is an aperiodic set of at most n tiles, there is a smallest one, A: of it no tile can
//! be taken away, every tile has neighbors on all sides in A, and no part of A fills the plane
//! with two periods. All A are built up tile by tile from a set S that they contain:
//!
//! * A **need** is a tile of S without a neighbor in S on some side. A contains one of the tiles
//!   that fit there; each in turn is put in, and those before it are ruled out, so that no set
//!   comes twice. The need with the fewest candidates goes first; with one tile left to choose,
//!   it must meet all needs.
//! * S without needs is decided. When it (or any part of it) fills the plane with two periods, no
//!   A contains it. Else A contains another tile; which, is asked around one tile of S: fill a
//!   patch around it with tiles of S as far as that goes; A contains a tile that fits first where
//!   that goes no farther.
//!
//! The first tile is one of each class under the 8 symmetries of the square and the permutations
//! of the colors; later classes rule out the earlier ones. What is left over, and not decided, is
//! told.

use super::wang::{Tally, slowly};
use super::{NO_STRIPS, Quick};
use crate::aperiodic::decide::{Bounds, SYMMETRIES, Tile};
use crate::search::Stop;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// A set of tiles: at most 81 of them.
type Mask = u128;
/// Colors at most.
pub const MOST_COLORS: u32 = 3;
/// Trees that threads share.
const TASKS: usize = 512;
/// Tiles tried around a tile, to see what is missing.
const PATCHES: u32 = 2000;

/// What to search for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Question {
    /// Two or three.
    pub colors: u32,
    /// Tiles of a set at most.
    pub most: u32,
    /// The tiles of tori of at most so many cells are ruled out before a set is decided.
    pub area: usize,
    /// Whether to list the periodic sets met as well.
    pub periodic: bool,
}

impl Question {
    /// For sets of at most so many tiles over so many colors.
    pub fn new(colors: u32, most: u32) -> Self {
        Self { colors: colors.clamp(1, MOST_COLORS), most, area: 6, periodic: false }
    }
}

/// What a search came to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Exhausted {
    /// The sets that were decided.
    pub tally: Tally,
    /// Those of which nothing is known, sorted.
    pub undecided: Vec<Vec<[u32; 4]>>,
    /// The periodic sets, when asked for; sorted. All smallest ones without the tiles of a small
    /// torus are among them, up to symmetry.
    pub periodic: Vec<Vec<[u32; 4]>>,
    /// Sets built.
    pub nodes: u64,
    /// Whether the search went to its end.
    pub complete: bool,
}

impl Exhausted {
    fn join(mut self, mut other: Self) -> Self {
        self.tally += other.tally;
        self.undecided.append(&mut other.undecided);
        self.periodic.append(&mut other.periodic);
        self.nodes += other.nodes;
        self.complete &= other.complete;
        self
    }
}

/// What does not change.
struct Rules {
    tiles: Vec<[u32; 4]>,
    /// For every side (N, E, S, W) and tile the tiles that fit there.
    fits: [Vec<Mask>; 4],
    /// For every tile the smallest sets with it that fill a small torus.
    periodic: Vec<Vec<Mask>>,
    question: Question,
    bounds: Bounds,
}

/// A set, and the tiles that are ruled out.
#[derive(Debug, Clone, Copy)]
struct State {
    set: Mask,
    out: Mask,
    /// The tile that was put in first.
    root: u32,
}

fn members(mut mask: Mask) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let first = (mask != 0).then(|| mask.trailing_zeros() as usize);
        mask &= mask.wrapping_sub(1);
        first
    })
}

/// Searches for aperiodic sets. `progress` is told trees done, and how many there are.
pub fn exhaust(
    question: Question,
    bounds: &Bounds,
    stop: &dyn Stop,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Exhausted {
    let bounds = Bounds { strips: NO_STRIPS, ..*bounds };
    let rules = Rules::new(question, bounds);
    let mut quick = Quick::default();
    let mut above = Exhausted { complete: true, ..Exhausted::default() };
    let mut tasks = rules.roots(question.colors);
    // The same number of tasks whatever the number of threads.
    for _ in 0..question.most {
        if tasks.len() >= TASKS {
            break;
        }
        tasks =
            tasks.iter().flat_map(|&state| rules.children(state, &mut quick, &mut above)).collect();
    }
    let done = AtomicU64::new(0);
    let total = tasks.len() as u64;
    let walk = |quick: &mut Quick, &state: &State| {
        let mut result = Exhausted { complete: true, ..Exhausted::default() };
        let mut open = vec![state];
        while let Some(state) = open.pop() {
            if result.nodes.is_multiple_of(256) && stop.should_stop() {
                result.complete = false;
                break;
            }
            open.append(&mut rules.children(state, quick, &mut result));
        }
        progress(done.fetch_add(1, Ordering::Relaxed) + 1, total);
        result
    };
    let none = || Exhausted { complete: true, ..Exhausted::default() };
    let below = tasks.par_iter().map_init(Quick::default, walk).reduce(none, Exhausted::join);
    let mut all = above.join(below);
    all.undecided.sort_unstable();
    all.periodic.sort_unstable();
    all
}

impl Rules {
    fn new(question: Question, bounds: Bounds) -> Self {
        let colors = question.colors;
        let digit = |tile: u32, place: u32| tile / colors.pow(3 - place) % colors;
        let tiles: Vec<[u32; 4]> =
            (0..colors.pow(4)).map(|t| [0, 1, 2, 3].map(|place| digit(t, place))).collect();
        // The corners that two neighbors share: of the one and of the other.
        const SHARED: [[(usize, usize); 2]; 4] =
            [[(0, 3), (1, 2)], [(1, 0), (2, 3)], [(3, 0), (2, 1)], [(0, 1), (3, 2)]];
        let fits = SHARED.map(|shared| {
            let fit =
                |one: &[u32; 4], other: &[u32; 4]| shared.iter().all(|&(a, b)| one[a] == other[b]);
            let mask = |one: &[u32; 4]| {
                let fitting = tiles.iter().enumerate().filter(|(_, other)| fit(one, other));
                fitting.fold(0, |mask, (tile, _)| mask | 1 << tile)
            };
            tiles.iter().map(mask).collect()
        });
        let generators = generators(colors, question.area);
        let of = |tile: usize| generators.iter().copied().filter(|g| g >> tile & 1 == 1).collect();
        let periodic = (0..tiles.len()).map(of).collect();
        Self { tiles, fits, periodic, question, bounds }
    }

    /// One tile of each class.
    fn roots(&self, colors: u32) -> Vec<State> {
        let orders: &[[u32; 3]] = match colors {
            3 => &[[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]],
            2 => &[[0, 1, 2], [1, 0, 2]],
            _ => &[[0, 1, 2]],
        };
        let mut out: Mask = 0;
        let mut roots = Vec::new();
        for (number, tile) in self.tiles.iter().enumerate() {
            if out >> number & 1 == 1 {
                continue;
            }
            if !self.repeats(1 << number, number) {
                roots.push(State { set: 1 << number, out, root: number as u32 });
            }
            for sides in SYMMETRIES {
                for order in orders {
                    let image = sides.map(|side| order[tile[side] as usize]);
                    let same = self.tiles.iter().position(|tile| *tile == image);
                    out |= same.map_or(0, |same| 1 << same);
                }
            }
        }
        roots
    }

    /// Whether a set with this tile in it fills a small torus.
    fn repeats(&self, set: Mask, tile: usize) -> bool {
        self.periodic[tile].iter().any(|generator| generator & !set == 0)
    }

    /// The sets with one tile more, one of which every smallest aperiodic set that contains this
    /// set does contain. The last is to be gone through first.
    fn children(&self, state: State, quick: &mut Quick, result: &mut Exhausted) -> Vec<State> {
        result.nodes += 1;
        let left = self.question.most - state.set.count_ones();
        let Some(candidates) = self.candidates(state, left, quick, result) else {
            return Vec::new();
        };
        let mut children = Vec::new();
        let mut out = state.out;
        for tile in members(candidates) {
            let set = state.set | 1 << tile;
            if !self.repeats(set, tile) {
                children.push(State { set, out, root: state.root });
            }
            out |= 1 << tile;
        }
        children
    }

    fn candidates(
        &self,
        state: State,
        left: u32,
        quick: &mut Quick,
        result: &mut Exhausted,
    ) -> Option<Mask> {
        let free = !state.set & !state.out & ((1 << self.tiles.len()) - 1);
        let (mut fewest, mut all) = (None::<Mask>, free);
        for tile in members(state.set) {
            for fits in &self.fits {
                if fits[tile] & state.set == 0 {
                    let candidates = fits[tile] & free;
                    all &= candidates;
                    if candidates == 0 || left == 0 {
                        return None;
                    }
                    if fewest.is_none_or(|f| candidates.count_ones() < f.count_ones()) {
                        fewest = Some(candidates);
                    }
                }
            }
        }
        if let Some(candidates) = fewest {
            return Some(if left == 1 { all } else { candidates });
        }
        let tiles = self.edges(state.set);
        let verdict = quick.decide(&tiles).or_else(|| slowly(&tiles, &self.bounds, &()));
        result.tally.count(verdict);
        match verdict {
            Some(true) => {
                if self.question.periodic {
                    result.periodic.push(self.listed(state.set));
                }
                None
            }
            _ if left == 0 => {
                if verdict.is_none() {
                    result.undecided.push(self.listed(state.set));
                }
                None
            }
            Some(false) => Some(self.missing(state, free)),
            None => {
                result.undecided.push(self.listed(state.set));
                Some(free)
            }
        }
    }

    fn listed(&self, set: Mask) -> Vec<[u32; 4]> {
        members(set).map(|tile| self.tiles[tile]).collect()
    }

    /// As Wang tiles, labels numbered as they come.
    fn edges(&self, set: Mask) -> Vec<Tile> {
        let mut names = [[u32::MAX; 9]; 2];
        let mut counts = [0; 2];
        let mut name = |space: usize, a: u32, b: u32| {
            let place = &mut names[space][(a * 3 + b) as usize];
            if *place == u32::MAX {
                *place = counts[space];
                counts[space] += 1;
            }
            *place
        };
        let edges = |tile: usize| {
            let [nw, ne, se, sw] = self.tiles[tile];
            [name(0, nw, ne), name(1, ne, se), name(0, sw, se), name(1, nw, sw)]
        };
        members(set).map(edges).collect()
    }

    /// Tiles of which one must come, for the set alone does not fill the plane: the fewest that
    /// the patches around a tile ask for.
    fn missing(&self, state: State, free: Mask) -> Mask {
        let mut fewest = free;
        for tile in members(state.set) {
            for side in [3, 5] {
                let mut patch = Patch { rules: self, state, side, budget: PATCHES, asked: 0 };
                let mut cells = vec![None; side * side];
                cells[side * side / 2] = Some(tile);
                let filled = patch.fill(&mut cells);
                if !filled && patch.budget > 0 {
                    let asked = patch.asked & free;
                    if asked.count_ones() < fewest.count_ones() {
                        fewest = asked;
                    }
                    break;
                }
                if patch.budget == 0 {
                    break;
                }
            }
        }
        fewest
    }
}

/// A square of cells around a tile.
struct Patch<'a> {
    rules: &'a Rules,
    state: State,
    side: usize,
    budget: u32,
    /// Tiles outside the set that would have fitted where it went no farther.
    asked: Mask,
}

impl Patch<'_> {
    /// Fills the cells from the middle on; false when it cannot be done (or the budget is used
    /// up).
    fn fill(&mut self, cells: &mut [Option<usize>]) -> bool {
        if self.budget == 0 {
            return false;
        }
        self.budget -= 1;
        let Some((cell, fitting)) = self.tightest(cells) else { return true };
        self.asked |= fitting & !self.state.set;
        for tile in members(fitting & self.state.set) {
            cells[cell] = Some(tile);
            if self.fill(cells) {
                return true;
            }
        }
        cells[cell] = None;
        false
    }

    /// The empty cell beside a filled one for which the fewest tiles of the set fit, and all
    /// tiles that do.
    fn tightest(&self, cells: &[Option<usize>]) -> Option<(usize, Mask)> {
        let side = self.side;
        let mut best: Option<(u32, usize, Mask)> = None;
        for cell in (0..cells.len()).filter(|&cell| cells[cell].is_none()) {
            let (row, column) = (cell / side, cell % side);
            // The neighbor, and the side of the neighbor on which this cell is.
            let around = [
                (row > 0).then(|| (cell - side, 2)),
                (column + 1 < side).then(|| (cell + 1, 3)),
                (row + 1 < side).then(|| (cell + side, 0)),
                (column > 0).then(|| (cell - 1, 1)),
            ];
            let mut fitting = Mask::MAX;
            let mut touched = false;
            for (neighbor, towards) in around.into_iter().flatten() {
                if let Some(tile) = cells[neighbor] {
                    touched = true;
                    fitting &= self.rules.fits[towards][tile];
                }
            }
            let count = (fitting & self.state.set).count_ones();
            if touched && best.is_none_or(|(fewest, ..)| count < fewest) {
                best = Some((count, cell, fitting));
            }
        }
        best.map(|(_, cell, fitting)| (cell, fitting))
    }
}

/// The sets of tiles of the tori of at most `area` cells, without those that contain another.
fn generators(colors: u32, area: usize) -> Vec<Mask> {
    let mut all: Vec<Mask> = Vec::new();
    for (width, height) in (1..=area).flat_map(|w| (1..=area / w).map(move |h| (w, h))) {
        let cells = width * height;
        for code in 0..u64::from(colors).pow(cells as u32) {
            let color = |row: usize, column: usize| {
                let cell = (row % height * width + column % width) as u32;
                (code / u64::from(colors).pow(cell) % u64::from(colors)) as u32
            };
            let tile = |cell: usize| {
                let (r, c) = (cell / width, cell % width);
                let corners = [color(r, c), color(r, c + 1), color(r + 1, c + 1), color(r + 1, c)];
                corners.into_iter().fold(0, |tile, corner| tile * colors + corner)
            };
            all.push((0..cells).fold(0, |mask, cell| mask | 1 << tile(cell)));
        }
    }
    all.sort_unstable_by_key(|mask| (mask.count_ones(), *mask));
    all.dedup();
    let mut least: Vec<Mask> = Vec::new();
    for mask in all {
        if !least.iter().any(|smaller| smaller & !mask == 0) {
            least.push(mask);
        }
    }
    least
}
