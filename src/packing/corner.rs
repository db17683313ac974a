//! Corner packings: colors on lattice points.
//!
//! The candidates of a point are the AND of the tiles its window may still become ([`Rule`])
//! and the dominoes not used up ([`Caps`]). With a prescribed automorphism a choice writes the
//! whole orbit and places the whole orbit of its tiles. Points that complete just one window as
//! its free corner, nearly all, go the simple way; the others are tried out color by color.
//!
//! Invariant: `value` holds the colors of all points at levels pushed; `rule` and `caps` hold
//! exactly the windows and dominoes whose points are all known.

use super::caps::Caps;
use super::corner_herd::Herd;
use super::corner_plan::{CornerPlan, Step, Window};
use super::corner_tables::{allowed_rows, caps, follow, row};
use super::last_lines::{Found, LastLines};
use super::quotient::Quotient;
use super::reduction::Reduction;
use super::rule::Rule;
use super::table::Table;
use super::{Labeled, MAX_SEARCH_COLORS, Task, TaskError};
use crate::search::{Alternatives, Bounds, Problem, Visited, Words};
use crate::torus::Cell;

/// What the inner loop needs of a step.
#[derive(Debug, Clone, Copy, Default)]
struct Place {
    cell: u32,
    /// The known corners of the window, when the step has a simple one.
    known: [u32; 3],
    simple: bool,
}

/// The search for corner packings under a rule, over at most `C = 4 * W` colors and fewer than `L`
/// cells; `QUOTIENT` with a prescribed automorphism.
#[derive(Debug, Clone)]
pub struct Corner<R, const W: usize, const C: usize, const L: usize, const QUOTIENT: bool> {
    places: Table<Place, L>,
    value: Table<u8, L>,
    rule: R,
    caps: Caps<W, C>,
    /// Bits of a color in the index of a row.
    shift: u32,
    /// By level: one more than the largest color used before it.
    used: Table<u8, L>,
    /// By that number: the colors that may follow.
    follow: Table<u64, 128>,
    /// All colors.
    all: u64,
    around: Table<Around, L>,
    /// The color maps of 0, 1, … steps of the automorphism.
    maps: Vec<Vec<u8>>,
    /// By level: the points of its orbit.
    orbits: Vec<Vec<u32>>,
    cells: usize,
    /// What batches need, where there may be any.
    herd: Option<Box<Herd>>,
}

/// What a step that is not simple decides: no more than the four windows and four dominoes
/// around a point.
#[derive(Debug, Clone, Copy, Default)]
struct Around {
    cell: u32,
    /// How many there are of each.
    number: Placed,
    /// How many of each, which come first, are known but for this point.
    sieve: Placed,
    across: [(u32, u32); 2],
    along: [(u32, u32); 2],
    windows: [Window; 4],
}

/// How much of a step has been placed: dominoes and windows, each with its images.
#[derive(Debug, Clone, Copy, Default)]
struct Placed {
    across: u8,
    along: u8,
    windows: u8,
}

impl<R: Rule, const W: usize, const C: usize, const L: usize, const QUOTIENT: bool>
    Corner<R, W, C, L, QUOTIENT>
{
    /// The problem of a task that has been checked.
    ///
    /// `rule` is given the tiles allowed, row by row. `Ok(None)` means that what the reduction
    /// fixes already contradicts itself: there is no packing.
    ///
    /// # Errors
    /// When the pins contradict each other.
    pub fn new(
        task: &Task,
        reduction: &Reduction,
        rule: impl FnOnce(Vec<u64>) -> R,
    ) -> Result<Option<Self>, TaskError> {
        let quotient = Quotient::new(task);
        let count = task.set.colors().horizontal();
        let shift = (count - 1).checked_ilog2().map_or(0, |log| log + 1);
        let maps: Vec<Vec<u8>> =
            quotient.maps().iter().map(|map| map.horizontal().to_vec()).collect();
        let mut given = task.pins.labels().to_vec();
        for (place, color) in reduction.fixed_labels(task) {
            if given[place].is_some_and(|known| known != color) {
                return Ok(None);
            }
            given[place] = Some(color);
        }
        let fixed: Vec<bool> = given.iter().map(Option::is_some).collect();
        let plan = CornerPlan::new(task, &quotient, &fixed);
        let limit = task.set.is_compact().then_some(2);
        let allowed = allowed_rows(&task.set, shift, &maps, !task.cover, limit);
        let used = given.iter().flatten().max().map_or(0, |&color| color + 1);
        let herd = if QUOTIENT { None } else { Herd::new(task, &plan, &allowed, shift) };
        let mut problem = Self {
            places: Table::new(plan.steps.iter().map(Place::of).collect(), Place::default()),
            value: Table::new(vec![0; task.shape.cells()], 0),
            rule: rule(allowed),
            caps: caps(task),
            shift,
            used: Table::new(vec![used; plan.steps.len() + 1], 0),
            all: u64::MAX >> (MAX_SEARCH_COLORS - count),
            follow: Table::new(follow(count, reduction.ordered_from.is_some()), 0),
            around: Table::new(plan.steps.iter().map(Around::of).collect(), Around::default()),
            maps,
            orbits: plan.steps.into_iter().map(|step| step.orbit).collect(),
            cells: task.shape.cells(),
            herd: herd.map(Box::new),
        };
        for step in &plan.fixed {
            if let Err(cell) = problem.fix(step, &given) {
                let (row, column) = task.shape.position(Cell(cell));
                let message = format!(
                    "the color at row {row}, column {column} breaks the law of the set or of the automorphism"
                );
                return if task.has_pins() { Err(TaskError::Pins(message)) } else { Ok(None) };
            }
        }
        Ok(Some(problem))
    }

    /// Places what is known beforehand, or names the point that contradicts.
    fn fix(&mut self, step: &Step, given: &[Option<u8>]) -> Result<(), u32> {
        let orbit = step.orbit.iter().zip(&self.maps);
        let known = orbit.clone().find_map(|(&cell, map)| {
            let color = given[cell as usize]?;
            map.iter().position(|&image| image == color).map(|color| color as u8)
        });
        let color = known.ok_or(step.cell)?;
        for (&cell, map) in orbit {
            if given[cell as usize].is_some_and(|pin| pin != map[usize::from(color)]) {
                return Err(cell);
            }
        }
        for (&cell, map) in step.orbit.iter().zip(&self.maps) {
            self.value[cell as usize] = map[usize::from(color)];
        }
        let (_, fits) = self.place(&Around::of(step));
        if fits { Ok(()) } else { Err(step.cell) }
    }

    #[inline(always)]
    fn row(&self, known: [u8; 3]) -> usize {
        row(self.shift, known)
    }

    #[inline(always)]
    fn colors(&self, cells: [u32; 3]) -> [u8; 3] {
        cells.map(|cell| self.value[cell as usize])
    }

    /// Applies `change` to the rule for a window and its images.
    #[inline(always)]
    fn each_window(&mut self, known: [u8; 3], free: u8, change: impl Fn(&mut R, usize, u32)) {
        let row = self.row(known);
        change(&mut self.rule, row, free.into());
        if QUOTIENT {
            for power in 1..self.maps.len() {
                let map = |color: u8| self.maps[power][usize::from(color)];
                let (row, free) = (self.row(known.map(map)), map(free));
                change(&mut self.rule, row, free.into());
            }
        }
    }

    /// Applies `change` to the caps for a domino and its images; whether all are true.
    #[inline(always)]
    fn each_domino(
        &mut self,
        first: u8,
        second: u8,
        change: impl Fn(&mut Caps<W, C>, u8, u8) -> bool,
    ) -> bool {
        let mut all = change(&mut self.caps, first, second);
        if QUOTIENT {
            for map in &self.maps[1..] {
                all &= change(&mut self.caps, map[usize::from(first)], map[usize::from(second)]);
            }
        }
        all
    }

    /// Writes the color of a point and of its orbit.
    #[inline(always)]
    fn write(&mut self, level: usize, cell: u32, color: u8) {
        self.value[cell as usize] = color;
        if QUOTIENT {
            for (&cell, map) in self.orbits[level].iter().zip(&self.maps).skip(1) {
                self.value[cell as usize] = map[usize::from(color)];
            }
        }
    }

    fn ends(&self, domino: (u32, u32)) -> (u8, u8) {
        (self.value[domino.0 as usize], self.value[domino.1 as usize])
    }

    fn corners(&self, window: Window) -> ([u8; 3], u8) {
        (self.colors(window.known), self.value[window.free as usize])
    }

    /// Places what the color just written decides, up to the first violation; how far, and
    /// whether there was none.
    fn place(&mut self, around: &Around) -> (Placed, bool) {
        let mut placed = Placed::default();
        for &domino in &around.across[..around.number.across.into()] {
            let (first, second) = self.ends(domino);
            placed.across += 1;
            if !self.each_domino(first, second, Caps::take_across) {
                return (placed, false);
            }
        }
        for &domino in &around.along[..around.number.along.into()] {
            let (first, second) = self.ends(domino);
            placed.along += 1;
            if !self.each_domino(first, second, Caps::take_along) {
                return (placed, false);
            }
        }
        for &window in &around.windows[..around.number.windows.into()] {
            let (known, free) = self.corners(window);
            if self.rule.open(self.row(known)) >> free & 1 == 0 {
                return (placed, false);
            }
            placed.windows += 1;
            self.each_window(known, free, R::take);
        }
        (placed, self.rule.holds())
    }

    /// Takes back what [`Self::place`] placed.
    fn unplace(&mut self, around: &Around, placed: Placed) {
        for &window in around.windows[..placed.windows.into()].iter().rev() {
            let (known, free) = self.corners(window);
            self.each_window(known, free, R::release);
        }
        for &domino in &around.along[..placed.along.into()] {
            let (first, second) = self.ends(domino);
            self.each_domino(first, second, Caps::release_along);
        }
        for &domino in &around.across[..placed.across.into()] {
            let (first, second) = self.ends(domino);
            self.each_domino(first, second, Caps::release_across);
        }
    }

    /// Of some candidates those that fit: a sieve by what is cheap to know, then one by one.
    #[inline(never)]
    fn tried(&mut self, level: usize, candidates: u64) -> u64 {
        let around = &self.around[level];
        let cell = around.cell;
        let mut fitting = candidates;
        for &(first, _) in &around.across[..around.sieve.across.into()] {
            fitting &= self.caps.open_across(self.value[first as usize]);
        }
        for &(first, _) in &around.along[..around.sieve.along.into()] {
            fitting &= self.caps.open_along(self.value[first as usize]);
        }
        for window in &around.windows[..around.sieve.windows.into()] {
            let known = self.colors(window.known);
            fitting &= self.rule.open(self.row(known));
        }
        for color in Words([fitting]).numbers() {
            self.write(level, cell, color as u8);
            if !self.fits(level) {
                fitting &= !(1 << color);
            }
        }
        fitting
    }

    /// Whether what the color just written decides may be placed.
    fn fits(&mut self, level: usize) -> bool {
        let around = &self.around[level];
        // Without images, and with all rows and all dominoes different, nothing that is placed
        // here stands in the way of another.
        let mut apart = R::EXACT && !QUOTIENT;
        let mut rows = [usize::MAX; 4];
        for (i, &window) in around.windows[..around.number.windows.into()].iter().enumerate() {
            let (known, free) = self.corners(window);
            let row = self.row(known);
            if i >= around.sieve.windows.into() && self.rule.open(row) >> free & 1 == 0 {
                return false;
            }
            apart &= !rows.contains(&row);
            rows[i] = row;
        }
        // The sieve has asked for the first ones already.
        let across = &around.across[..around.number.across.into()];
        for &domino in &across[around.sieve.across.into()..] {
            let (first, second) = self.ends(domino);
            if !self.caps.has_across(first, second) {
                return false;
            }
        }
        let along = &around.along[..around.number.along.into()];
        for &domino in &along[around.sieve.along.into()..] {
            let (first, second) = self.ends(domino);
            if !self.caps.has_along(first, second) {
                return false;
            }
        }
        let differ = |dominoes: &[(u32, u32)]| match *dominoes {
            [a, b] => self.ends(a) != self.ends(b),
            _ => true,
        };
        apart &= differ(across) && differ(along);
        if apart {
            return true;
        }
        let around = *around;
        let (placed, fits) = self.place(&around);
        self.unplace(&around, placed);
        fits
    }

    #[inline(never)]
    fn push_general(&mut self, level: usize) {
        let around = self.around[level];
        self.place(&around);
    }

    #[inline(never)]
    fn pop_general(&mut self, level: usize) {
        let around = self.around[level];
        self.unplace(&around, around.number);
    }
}

impl Place {
    fn of(step: &Step) -> Self {
        let known = step.simple.unwrap_or_default();
        Self { cell: step.cell, known, simple: step.simple.is_some() }
    }
}

impl Around {
    fn of(step: &Step) -> Self {
        let numbers = |across: usize, along: usize, windows: usize| Placed {
            across: across as u8,
            along: along as u8,
            windows: windows as u8,
        };
        let mut around = Self {
            cell: step.cell,
            number: numbers(step.across.len(), step.along.len(), step.windows.len()),
            sieve: numbers(step.sieve.across, step.sieve.along, step.sieve.windows),
            ..Self::default()
        };
        around.across[..step.across.len()].copy_from_slice(&step.across);
        around.along[..step.along.len()].copy_from_slice(&step.along);
        around.windows[..step.windows.len()].copy_from_slice(&step.windows);
        around
    }
}

impl<R: Rule, const W: usize, const C: usize, const L: usize, const QUOTIENT: bool> Problem
    for Corner<R, W, C, L, QUOTIENT>
{
    type Alternatives = Words<1>;

    fn levels(&self) -> usize {
        self.orbits.len()
    }

    #[inline(always)]
    fn alternatives(&mut self, level: usize) -> Words<1> {
        let place = &self.places[level];
        let follow = self.follow[usize::from(self.used[level])];
        if place.simple && R::EXACT {
            let known = self.colors(place.known);
            return Words([follow & self.caps.open(known) & self.rule.open(self.row(known))]);
        }
        Words([self.tried(level, follow)])
    }

    #[inline(always)]
    fn push(&mut self, level: usize, choice: u32) {
        let color = choice as u8;
        self.used[level + 1] = self.used[level].max(color + 1);
        let place = self.places[level];
        self.write(level, place.cell, color);
        if !place.simple {
            return self.push_general(level);
        }
        let known = self.colors(place.known);
        self.each_domino(known[2], color, Caps::take_across);
        self.each_domino(known[1], color, Caps::take_along);
        self.each_window(known, color, R::take);
    }

    #[inline(always)]
    fn pop(&mut self, level: usize, choice: u32) {
        let color = choice as u8;
        let place = &self.places[level];
        if !place.simple {
            return self.pop_general(level);
        }
        let known = self.colors(place.known);
        self.each_window(known, color, R::release);
        self.each_domino(known[1], color, Caps::release_along);
        self.each_domino(known[2], color, Caps::release_across);
    }

    fn gathers_from(&self) -> Option<usize> {
        self.herd.as_ref().map(|herd| herd.from())
    }

    fn gather(&mut self, level: usize) -> bool {
        let Some(herd) = &mut self.herd else { return false };
        // While the order of colors is open it takes part in every choice.
        if self.follow[usize::from(self.used[level])] != self.all {
            return false;
        }
        let rows = |known| self.rule.open(row(self.shift, known));
        herd.gather(level, rows, &self.caps, |cell| self.value[cell as usize]);
        true
    }

    fn expand(&mut self, bounds: Bounds) -> Result<Visited, u64> {
        self.herd.as_mut().map_or(Ok(Visited::default()), |herd| herd.expand(bounds))
    }
}

impl<R: Rule, const W: usize, const C: usize, const L: usize, const QUOTIENT: bool> Labeled
    for Corner<R, W, C, L, QUOTIENT>
{
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
        labels.extend((0..self.cells).map(|cell| self.value[cell]));
    }

    fn is_hopeless(&self, last: &LastLines, level: usize, found: &mut Found) -> bool {
        let color = |cell: u32| self.value[cell as usize];
        let open = |known| self.rule.open(self.row(known));
        last.is_hopeless(level, found, color, open, |known| open(known) & self.caps.open(known))
    }
}
