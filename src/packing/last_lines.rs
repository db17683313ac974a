//! Whether the last lines of a corner packing can still be filled, as far as a look shows.
//!
//! When the last two lines (rows, or columns) are open, the colors of a position in both are
//! one of few states, and a way around the torus from state to state through windows that are
//! tiles not yet placed is found by dynamic programming. It need not use each tile once, so
//! finding one proves nothing; but where there is none, no packing lies below. With two rows
//! open that is so for 99 of 100 partial packings of the C = 3 corner tiles. While the line
//! before is being filled, the ways are followed along with it, one position for each point.
//!
//! The search itself does better without, as it would ask at every node. An estimate of the
//! number of packings asks before it spends its probes on what is dead already.

use super::Task;
use super::corner_plan::CornerPlan;
use super::quotient::Quotient;
use super::reduction::Reduction;
use crate::search::{Alternatives, Words};
use crate::tiles::Kind;
use crate::torus::{Cell, Order};

/// Colors with which the search may make these looks, at most.
pub const MOST_COLORS: usize = 4;
/// Cells of a torus on which it may.
pub const MOST_CELLS: usize = 511;

/// States are numbers below this, for their sets to be words.
const STATES: usize = 16;
/// Lines that are left open by the line being filled, at most.
const MOST_LINES: usize = 2;

/// For each state the set of the states at position 0 from which it is reached.
type Ways = [u16; STATES];

/// What to look at once a level is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Look {
    /// Nothing: too much is open.
    No,
    /// The first point of the line before `first` is known: the ways begin.
    Begin { first: usize },
    /// The line before `first` is known up to this position: the ways go on.
    Step { first: usize, position: usize },
    /// The line before `first` is known: the ways close, then as `Around`.
    Close { first: usize },
    /// All ways around through `count` open lines.
    Around { first: usize, count: usize },
}

/// The lines of a torus, and when their points are known.
#[derive(Debug, Clone)]
pub struct LastLines {
    /// Points of a line.
    length: usize,
    /// Line by line the points, and the level from which on each is known.
    points: Vec<(u32, usize)>,
    /// By level.
    looks: Vec<Look>,
    /// Lines that a state holds while the line before is being filled.
    most: usize,
    /// Bits of a color in a state.
    shift: usize,
    /// All colors.
    all: u64,
    /// Whether lines are columns.
    transposed: bool,
}

/// The ways found on the path from the root to a node, by level.
#[derive(Debug, Clone)]
pub struct Found(Vec<Ways>);

impl LastLines {
    /// Of a task that has been checked, or `None` where lines cannot be looked at.
    pub fn new(task: &Task, reduction: &Reduction) -> Option<Self> {
        let order = task.visiting_order();
        if task.set.kind() != Kind::Corner || !matches!(order, Order::Row | Order::Column) {
            return None;
        }
        let colors = task.set.colors().horizontal();
        let shift = (colors - 1).checked_ilog2().map_or(1, |log| log as usize + 1);
        let shape = task.shape;
        let transposed = order == Order::Column;
        let (lines, length) = match transposed {
            false => (shape.height(), shape.width()),
            true => (shape.width(), shape.height()),
        };
        let mut given: Vec<bool> = task.pins.labels().iter().map(Option::is_some).collect();
        for (place, _) in reduction.fixed_labels(task) {
            given[place] = true;
        }
        let plan = CornerPlan::new(task, &Quotient::new(task), &given);
        let mut known_from = vec![0; shape.cells()];
        for (level, step) in plan.steps.iter().enumerate() {
            for &cell in &step.orbit {
                known_from[cell as usize] = level + 1;
            }
        }
        let mut points = Vec::with_capacity(shape.cells());
        for line in 0..lines as i64 {
            for position in 0..length as i64 {
                let (row, column) = if transposed { (position, line) } else { (line, position) };
                // Compact sets are visited from row 1 to the north.
                let row = if task.set.is_compact() { 1 - row } else { row };
                let cell = shape.step(Cell(0), row, column);
                points.push((cell.0, known_from[cell.index()]));
            }
        }
        let most = (STATES.ilog2() as usize / shift).min(MOST_LINES);
        if most == 0 {
            return None;
        }
        let all = u64::MAX >> (u64::BITS as usize - colors);
        let mut last = Self { length, points, looks: Vec::new(), most, shift, all, transposed };
        last.looks = (0..plan.steps.len()).map(|level| last.look(level, lines)).collect();
        Some(last)
    }

    fn look(&self, level: usize, lines: usize) -> Look {
        let line = |line: usize| &self.points[line * self.length..][..self.length];
        let is_open = |&at: &usize| line(at).iter().any(|&(_, from)| from > level);
        let open: Vec<usize> = (0..lines).filter(is_open).collect();
        let (Some(&first), Some(&last)) = (open.first(), open.last()) else { return Look::No };
        let count = open.len();
        if last - first + 1 != count || count >= lines || count > self.most + 1 {
            return Look::No;
        }
        if count <= self.most {
            let followed = |line: &[(u32, usize)]| {
                line[self.length - 1].1 == level && line[0].1 + self.length - 1 == level
            };
            if count == self.most && self.length > 1 && first > 0 && followed(line(first - 1)) {
                return Look::Close { first };
            }
            return Look::Around { first, count };
        }
        // A prefix of the line is known, and the point last chosen is its end.
        let known = line(first).iter().take_while(|&&(_, from)| from <= level).count();
        let rest_is_open = line(first)[known..].iter().all(|&(_, from)| from > level);
        match known {
            1.. if !rest_is_open || line(first)[known - 1].1 != level => Look::No,
            0 => Look::No,
            1 => Look::Begin { first: first + 1 },
            // The ways must have begun at the level of the first point.
            _ if line(first)[0].1 + known - 1 != level => Look::No,
            _ => Look::Step { first: first + 1, position: known - 1 },
        }
    }

    /// Nothing found yet.
    pub fn begin(&self) -> Found {
        Found(vec![[0; STATES]; self.looks.len() + 1])
    }

    /// Whether no packing lies below a state with this many choices made; `color` gives the
    /// colors of points known, `open` the tiles free for a window with these known corners.
    ///
    /// Must have been asked for the nodes on the path to it before, the last first.
    pub fn is_hopeless(
        &self,
        level: usize,
        found: &mut Found,
        color: impl Fn(u32) -> u8,
        open: impl Fn([u8; 3]) -> u64,
        fresh: impl Fn([u8; 3]) -> u64,
    ) -> bool {
        let (first, count) = match self.looks[level] {
            Look::No => return false,
            Look::Begin { first } | Look::Step { first, .. } | Look::Close { first } => {
                (first, self.most)
            }
            Look::Around { first, count } => (first, count),
        };
        // Where the line before the open ones, these and the one after begin, around the torus;
        // no division, for this is the inner loop of the look.
        let mut begins = [0; MOST_LINES + 2];
        let mut begin = if first == 0 { self.points.len() } else { first * self.length };
        begin -= self.length;
        for line in &mut begins {
            *line = begin;
            begin += self.length;
            if begin == self.points.len() {
                begin = 0;
            }
        }
        let known = |line: usize, position: usize| {
            let (cell, from) = self.points[begins[line] + position];
            (from <= level).then(|| color(cell))
        };
        let states = 1 << (self.shift * count);
        let through = Through { lines: self, count, known: &known, open: &open, fresh: &fresh };
        match self.looks[level] {
            Look::No => false,
            Look::Begin { .. } => {
                found.0[level][..states].fill(0);
                through.begin(1, 0, &mut found.0[level]);
                false
            }
            Look::Step { position, .. } => {
                let (before, after) = found.0.split_at_mut(level);
                let (before, after) = (&before[level - 1][..states], &mut after[0]);
                !through.step((position - 1, position), before, after)
            }
            Look::Close { .. } => {
                // The ways found before may use what has been placed since: if they close, they
                // are looked for anew.
                let mut next = [0; STATES];
                let (end, mut ways) = (self.length - 1, found.0[level - 1]);
                for at in [(end - 1, end), (end, 0)] {
                    if !through.step(at, &ways[..states], &mut next) {
                        return true;
                    }
                    ways = next;
                }
                !closes(&ways) || !self.leads_around(&through, states)
            }
            Look::Around { .. } => !self.leads_around(&through, states),
        }
    }

    /// Whether there is a way around.
    fn leads_around<K, O, N>(&self, through: &Through<'_, K, O, N>, states: usize) -> bool
    where
        K: Fn(usize, usize) -> Option<u8>,
        O: Fn([u8; 3]) -> u64,
        N: Fn([u8; 3]) -> u64,
    {
        let (mut ways, mut next) = ([0; STATES], [0; STATES]);
        through.begin(1, 0, &mut ways);
        for position in 0..self.length {
            let after = if position + 1 == self.length { 0 } else { position + 1 };
            if !through.step((position, after), &ways[..states], &mut next) {
                return false;
            }
            ways = next;
        }
        closes(&ways)
    }
}

/// Whether some way leads from a state of position 0 back to it.
fn closes(ways: &Ways) -> bool {
    ways.iter().enumerate().any(|(state, from)| from >> state & 1 == 1)
}

/// The windows that ways go through.
struct Through<'a, K, O, N> {
    lines: &'a LastLines,
    /// Open lines.
    count: usize,
    /// The color of a point if known: of the line before the open ones, numbered 0, of these,
    /// and of the one after.
    known: &'a K,
    open: &'a O,
    fresh: &'a N,
}

/// Two neighbors of a line: their colors, and whether both are known.
#[derive(Debug, Clone, Copy)]
struct Pair {
    colors: (u8, u8),
    known: bool,
}

impl<K, O, N> Through<'_, K, O, N>
where
    K: Fn(usize, usize) -> Option<u8>,
    O: Fn([u8; 3]) -> u64,
    N: Fn([u8; 3]) -> u64,
{
    /// Every state of position 0 is reached from itself.
    fn begin(&self, line: usize, state: usize, ways: &mut Ways) {
        if line > self.count {
            ways[state] = 1 << state;
            return;
        }
        let colors = (self.known)(line, 0).map_or(self.lines.all, |color| 1 << color);
        for color in Words([colors]).numbers() {
            let shift = self.lines.shift * (line - 1);
            self.begin(line + 1, state | (color as usize) << shift, ways);
        }
    }

    /// From the states of a position to those of the next; whether there are any.
    #[inline(always)]
    fn step(&self, at: (usize, usize), before: &[u16], after: &mut Ways) -> bool {
        after[..before.len()].fill(0);
        let color = |position| (self.known)(0, position).unwrap_or(0);
        let above = Pair { colors: (color(at.0), color(at.1)), known: true };
        let is_open = |line| (self.known)(line, at.0).or((self.known)(line, at.1)).is_none();
        if self.count == 2 && is_open(1) && is_open(2) {
            return self.step_open(at, above.colors, before, after);
        }
        let mut any = false;
        for (state, &ways) in before.iter().enumerate() {
            if ways != 0 {
                any |= self.spread(1, at, above, (state, 0), ways, after);
            }
        }
        any
    }

    /// As [`Self::step`] for two lines with nothing known at either position, far the most
    /// frequent: what depends on one of the lines alone is looked up once.
    #[inline(always)]
    fn step_open(
        &self,
        at: (usize, usize),
        above: (u8, u8),
        before: &[u16],
        after: &mut Ways,
    ) -> bool {
        let shift = self.lines.shift;
        let below = |position| (self.known)(3, position).unwrap_or(0);
        let (below, below_next) = (below(at.0), below(at.1));
        // By color of the second line: what may be next to it, for the window below it.
        let mut second = [0u64; 1 << (STATES.ilog2() / 2)];
        for color in Words([self.lines.all]).numbers() {
            for next in Words([self.lines.all]).numbers() {
                let fits = self.corners((color as u8, next as u8), below) >> below_next & 1;
                second[color as usize] |= fits << next;
            }
        }
        let mut any = 0;
        for a in Words([self.lines.all]).numbers() {
            for a_next in Words([self.fresh_corners(above, a as u8)]).numbers() {
                for b in Words([self.lines.all]).numbers() {
                    let ways = before[(b as usize) << shift | a as usize];
                    if ways == 0 {
                        continue;
                    }
                    let free = self.fresh_corners((a as u8, a_next as u8), b as u8);
                    for b_next in Words([free & second[b as usize % second.len()]]).numbers() {
                        after[((b_next as usize) << shift | a_next as usize) % STATES] |= ways;
                        any |= ways;
                    }
                }
            }
        }
        any != 0
    }

    /// The free corners that a window may have, below two colors and beside one.
    #[inline(always)]
    fn corners(&self, above: (u8, u8), beside: u8) -> u64 {
        let (first, second) = above;
        (self.open)(match self.lines.transposed {
            false => [first, second, beside],
            true => [first, beside, second],
        })
    }

    /// The same where the free corner makes two new dominoes, which must not be used up either.
    #[inline(always)]
    fn fresh_corners(&self, above: (u8, u8), beside: u8) -> u64 {
        let (first, second) = above;
        (self.fresh)(match self.lines.transposed {
            false => [first, second, beside],
            true => [first, beside, second],
        })
    }

    /// From one state to those of the next position, line by line; whether there are any.
    #[inline]
    fn spread(
        &self,
        line: usize,
        at: (usize, usize),
        above: Pair,
        states: (usize, usize),
        ways: u16,
        after: &mut Ways,
    ) -> bool {
        let (here, there) = ((self.known)(line, at.0), (self.known)(line, at.1));
        if line > self.count {
            let (here, there) = (here.unwrap_or(0), there.unwrap_or(0));
            // A window known all around has been placed.
            let fits = above.known || self.corners(above.colors, here) >> there & 1 == 1;
            after[states.1] |= if fits { ways } else { 0 };
            return fits;
        }
        let shift = self.lines.shift * (line - 1);
        let known = here.is_some() && there.is_some();
        let here = (states.0 >> shift & ((1 << self.lines.shift) - 1)) as u8;
        let mut colors = there.map_or(self.lines.all, |color| 1 << color);
        if !(above.known && known) {
            colors &= self.corners(above.colors, here);
        }
        let mut any = false;
        for color in Words([colors]).numbers() {
            let pair = Pair { colors: (here, color as u8), known };
            let states = (states.0, states.1 | (color as usize) << shift);
            any |= self.spread(line + 1, at, pair, states, ways, after);
        }
        any
    }
}
