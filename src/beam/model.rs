//! Partial packings, filled row by row from the north.
//!
//! A state is an array of words: for every pair of colors how many tiles are left with this
//! domino north, south, west and east, and how many such dominoes are still to be placed across
//! and down; for every color the cells it still gets; the last `width` cells and two before
//! them; and what a [`Rule`] keeps. Everything a cell decides is decided as soon as it is
//! filled, across the seams too: a cell of the last column completes a second window and domino,
//! one of the last row those with the first row, which is the same in all states of a beam. What
//! cells given beforehand decide among themselves is decided at the start.
//!
//! Under a symmetry the torus is a [`Fold`]: its seams replace colors, and with a domino or a tile
//! all its images are used up. Counts are then of orbits, and stand with every image.
//!
//! Source: this project (search.md 6).

use super::given::{Given, around};
use super::rule::{Rule, Window};
use super::score::Logarithms;
use crate::torus::Fold;

/// A place to fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct At {
    pub(super) row: usize,
    pub(super) column: usize,
}

/// Where the parts of a state begin.
#[derive(Debug)]
struct Layout {
    south: usize,
    west: usize,
    east: usize,
    across: usize,
    down: usize,
    cells: usize,
    line: usize,
    rule: usize,
}

/// A problem: a torus to fill row by row.
#[derive(Debug)]
pub(super) struct Model<R> {
    pub(super) colors: usize,
    pub(super) width: usize,
    pub(super) height: usize,
    logs: Logarithms,
    rule: R,
    layout: Layout,
    start: Vec<u16>,
    given: Given,
    fold: Fold,
    /// What the seam in the east makes of a color.
    east: Vec<usize>,
    /// Without symmetry and given cells.
    plain: bool,
}

/// How many tiles and cells there are, before any is placed.
pub(super) struct Counts {
    /// For every pair of colors, the tiles with this domino north, and as many south.
    pub(super) across: Vec<u16>,
    /// For every pair of colors, the tiles with this domino west, and as many east.
    pub(super) down: Vec<u16>,
    /// For every color, its cells.
    pub(super) cells: Vec<u16>,
}

impl Counts {
    /// Those of a compact set.
    pub(super) fn compact(colors: usize) -> Self {
        let pairs = vec![2 * colors as u16; colors * colors];
        let cells = vec![2 * (colors * colors) as u16; colors];
        Self { across: pairs.clone(), down: pairs, cells }
    }
}

impl<R: Rule> Model<R> {
    pub(super) fn new(
        fold: Fold,
        counts: &Counts,
        rule: R,
        logs: Logarithms,
        given: Given,
    ) -> Option<Self> {
        let (width, height) = (fold.width(), fold.height());
        let east = (0..counts.cells.len()).map(|color| {
            let (_, steps) = fold.locate(0, width);
            usize::from(fold.powers()[steps][color])
        });
        let east = east.collect();
        let colors = counts.cells.len();
        let pairs = colors * colors;
        let (across, down) = (&counts.across, &counts.down);
        let mut start = [across, across, down, down, across, down].map(Vec::as_slice).concat();
        start.extend(&counts.cells);
        let line = start.len();
        start.resize(line + width + 2, 0);
        let layout = Layout {
            south: pairs,
            west: 2 * pairs,
            east: 3 * pairs,
            across: 4 * pairs,
            down: 5 * pairs,
            cells: 6 * pairs,
            line,
            rule: start.len(),
        };
        start.extend(rule.start());
        let plain = fold.powers().len() == 1 && given.is_empty();
        let mut model =
            Self { plain, colors, width, height, logs, rule, layout, start, given, fold, east };
        model.start = model.spend_given()?;
        Some(model)
    }

    /// The start less what the cells given beforehand use among themselves, so that the counts
    /// of a state are those of what is still to be decided; `None` when they use more than there
    /// is.
    fn spend_given(&self) -> Option<Vec<u16>> {
        let Layout { across, down, cells, .. } = self.layout;
        let mut state = self.start.clone();
        let color = |row, column| self.given.color(row, column);
        for row in 0..self.height {
            for column in 0..self.width {
                let Some(nw) = color(row, column) else { continue };
                self.spend(&mut state, cells, [nw], &self.logs.colors)?;
                if let Some(ne) = color(row, column + 1) {
                    self.spend(&mut state, across, [nw, ne], &self.logs.dominoes)?;
                }
                if let Some(sw) = color(row + 1, column) {
                    self.spend(&mut state, down, [nw, sw], &self.logs.dominoes)?;
                }
            }
        }
        for row in 0..self.height {
            for column in 0..self.width {
                let window = around(row, column).map(|(row, column)| color(row, column));
                if let [Some(nw), Some(ne), Some(sw), Some(se)] = window {
                    self.complete(&mut state, [nw, ne, sw, se])?;
                }
            }
        }
        Some(state)
    }

    /// The row south of the last, one cell further than the first is wide.
    pub(super) fn under(&self, first: &[u8]) -> Vec<usize> {
        let color = |column| usize::from(self.fold.color(first, self.height, column));
        (0..=self.width).map(color).collect()
    }

    /// Adds a tile to those to be used, and the dominoes and the cell that it needs.
    pub(super) fn give(&self, state: &mut [u16], [nw, ne, sw, se]: Window) {
        let Layout { south, west, east, across, down, cells, rule, .. } = self.layout;
        let n = self.colors;
        for (begin, a, b) in [
            (0, nw, ne),
            (across, nw, ne),
            (south, sw, se),
            (west, nw, sw),
            (down, nw, sw),
            (east, ne, se),
        ] {
            each_image(self.fold.powers(), [a, b], |[a, b]| state[begin + a * n + b] += 1);
        }
        each_image(self.fold.powers(), [nw], |[nw]| state[cells + nw] += 1);
        let words = &mut state[rule..];
        each_image(self.fold.powers(), [nw, ne, sw, se], |tile| self.rule.give(words, tile));
    }

    /// Nothing placed.
    pub(super) fn start(&self) -> &[u16] {
        &self.start
    }

    /// Words of a state.
    pub(super) fn words(&self) -> usize {
        self.start.len()
    }

    /// The color that a cell has beforehand.
    pub(super) fn given(&self, at: At) -> Option<usize> {
        self.given.color(at.row, at.column)
    }

    /// Fills a cell and gives the change of the score, or `None` when that is not possible; the
    /// state is then spoiled. `under` is the row south of the last, as far as it is needed.
    pub(super) fn place(
        &self,
        state: &mut [u16],
        under: &[usize],
        at: At,
        color: usize,
    ) -> Option<i64> {
        let Layout { across, down, cells, line, .. } = self.layout;
        let (nw, first) = (line + self.width, line + self.width + 1);
        let (last_column, last_row) = (at.column + 1 == self.width, at.row + 1 == self.height);
        let [north, north_west] = [line + at.column, nw].map(|i| usize::from(state[i]));
        let west = usize::from(state[line + at.column.max(1) - 1]);
        // What lies among cells given beforehand was spent at the start.
        let open = |cells: &[(usize, usize)]| !self.given.all(cells);
        let (row, column) = (at.row, at.column);
        let mut score = 0;
        if open(&[(row, column)]) {
            score += self.spend(state, cells, [color], &self.logs.colors)?;
        }

        state[nw] = north as u16;
        if column == 0 {
            state[first] = north as u16;
        } else if open(&[(row, column - 1), (row, column)]) {
            score += self.spend(state, across, [west, color], &self.logs.dominoes)?;
        }
        state[line + at.column] = color as u16;
        let start = self.east[usize::from(state[line])];
        if last_column && open(&[(row, column), (row, 0)]) {
            score += self.spend(state, across, [color, start], &self.logs.dominoes)?;
        }
        if row > 0 {
            if open(&[(row - 1, column), (row, column)]) {
                score += self.spend(state, down, [north, color], &self.logs.dominoes)?;
            }
            if column > 0 && open(&around(row - 1, column - 1)) {
                score += self.complete(state, [north_west, north, west, color])?;
            }
            if last_column && open(&around(row - 1, column)) {
                let above = self.east[usize::from(state[first])];
                score += self.complete(state, [north, above, color, start])?;
            }
        }
        if last_row {
            let south = under[at.column];
            if open(&[(row, column), (row + 1, column)]) {
                score += self.spend(state, down, [color, south], &self.logs.dominoes)?;
            }
            if column > 0 && open(&around(row, column - 1)) {
                score += self.complete(state, [west, color, under[at.column - 1], south])?;
            }
            if last_column && open(&around(row, column)) {
                score += self.complete(state, [color, start, south, under[at.column + 1]])?;
            }
        }
        Some(score)
    }

    /// Fills a cell with a color that [`Model::choices`] gave for this state.
    #[inline]
    pub(super) fn fill(&self, state: &mut [u16], under: &[usize], at: At, color: usize) {
        if !self.plain || !self.is_inner(at) {
            let placed = self.place(state, under, at, color);
            debug_assert!(placed.is_some());
            return;
        }
        let Layout { south, west, east, across, down, cells, line, rule } = self.layout;
        let (n, last) = (self.colors, line + self.width);
        let (counts, words) = state.split_at_mut(rule);
        let cell = |i: usize| usize::from(counts[i]);
        let (nw, ne, sw) = (cell(last), cell(line + at.column), cell(line + at.column - 1));
        counts[last] = ne as u16;
        counts[line + at.column] = color as u16;
        for used in [
            cells + color,
            across + sw * n + color,
            down + ne * n + color,
            nw * n + ne,
            south + sw * n + color,
            west + nw * n + sw,
            east + ne * n + color,
        ] {
            counts[used] -= 1;
        }
        self.rule.take(words, [nw, ne, sw, color]);
    }

    /// Whether a cell completes one window, one domino across and one down.
    #[inline(always)]
    fn is_inner(&self, At { row, column }: At) -> bool {
        row > 0 && row + 1 < self.height && column > 0 && column + 1 < self.width
    }

    /// Takes one off the counts, from `begin` on, of what shows these colors and its images.
    #[inline(always)]
    fn spend<const N: usize>(
        &self,
        state: &mut [u16],
        begin: usize,
        shown: [usize; N],
        logs: &[i64],
    ) -> Option<i64> {
        let index = |shown: [usize; N]| begin + shown.iter().fold(0, |i, c| i * self.colors + c);
        let count = state[index(shown)];
        let less = count.checked_sub(1)?;
        // All images have one count.
        each_image(self.fold.powers(), shown, |image| state[index(image)] = less);
        Some(logs[usize::from(count)])
    }

    fn complete(&self, state: &mut [u16], window: Window) -> Option<i64> {
        let [nw, ne, sw, se] = window;
        let Layout { south, west, east, rule, .. } = self.layout;
        let (counts, words) = state.split_at_mut(rule);
        if !self.rule.open(words, window) {
            return None;
        }
        let mut score = if self.rule.fresh(words, window) { self.logs.fresh } else { 0 };
        each_image(self.fold.powers(), window, |image| self.rule.take(words, image));
        for (begin, domino) in
            [(0, [nw, ne]), (south, [sw, se]), (west, [nw, sw]), (east, [ne, se])]
        {
            score += self.spend(counts, begin, domino, &self.logs.tiles)?;
        }
        Some(score)
    }

    /// Every color that the cell may have, in order, with the change of the score.
    #[inline]
    pub(super) fn choices(
        &self,
        state: &[u16],
        under: &[usize],
        at: At,
        scratch: &mut Vec<u16>,
        mut each: impl FnMut(usize, i64),
    ) {
        if let Some(color) = self.given.color(at.row, at.column) {
            scratch.clear();
            scratch.extend_from_slice(state);
            if let Some(change) = self.place(scratch, under, at, color) {
                each(color, change);
            }
            return;
        }
        if !self.is_inner(at) {
            for color in 0..self.colors {
                scratch.clear();
                scratch.extend_from_slice(state);
                if let Some(change) = self.place(scratch, under, at, color) {
                    each(color, change);
                }
            }
            return;
        }
        // One window, one domino across, one down: no copy is needed.
        let Layout { south, west, east, across, down, cells, line, rule } = self.layout;
        let n = self.colors;
        let (counts, words) = state.split_at(rule);
        let cell = |i: usize| usize::from(counts[i]);
        let (nw, ne, sw) =
            (cell(line + self.width), cell(line + at.column), cell(line + at.column - 1));
        let (top_left, left_left) = (cell(nw * n + ne), cell(west + nw * n + sw));
        if top_left == 0 || left_left == 0 {
            return;
        }
        let given = self.logs.tiles[top_left] + self.logs.tiles[left_left];
        let row = |from: usize| &counts[from..from + n];
        let columns = row(south + sw * n)
            .iter()
            .zip(row(east + ne * n))
            .zip(row(across + sw * n).iter().zip(row(down + ne * n)))
            .zip(row(cells));
        for (color, (((&b, &r), (&h, &v)), &c)) in columns.enumerate() {
            let window = [nw, ne, sw, color];
            if b == 0 || r == 0 || h == 0 || v == 0 || c == 0 || !self.rule.open(words, window) {
                continue;
            }
            let fresh = if self.rule.fresh(words, window) { self.logs.fresh } else { 0 };
            let tiles = self.logs.tiles[usize::from(b)] + self.logs.tiles[usize::from(r)];
            let dominoes = self.logs.dominoes[usize::from(h)] + self.logs.dominoes[usize::from(v)];
            each(color, given + tiles + dominoes + self.logs.colors[usize::from(c)] + fresh);
        }
    }
}

/// Every image of what shows these colors, once.
#[inline(always)]
pub(super) fn each_image<const N: usize>(
    powers: &[Vec<u8>],
    shown: [usize; N],
    mut each: impl FnMut([usize; N]),
) {
    each(shown);
    for power in &powers[1..] {
        let image = shown.map(|color| usize::from(power[color]));
        if image == shown {
            break;
        }
        each(image);
    }
}
