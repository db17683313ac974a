//! Corner packings: colors on lattice points.
//!
//! The candidates of a point are the AND of the tiles its window may still become ([`Rule`])
//! and the counts not used up ([`Caps`]). With a prescribed automorphism a choice writes the
//! whole orbit and places the whole orbit of its tiles.
//!
//! Invariant: `value` holds the colors of all points at levels pushed; `rule` and `caps` hold
//! exactly the windows and dominoes whose points are all known.

use super::caps::{Caps, colors};
use super::corner_plan::{CornerPlan, Step};
use super::quotient::Quotient;
use super::reduction::Reduction;
use super::rule::Rule;
use super::{Labeled, Task, TaskError};
use crate::search::{Alternatives, Problem, Words};
use crate::tiles::{Kind, TileSet};

/// The search for corner packings under a rule; `QUOTIENT` with a prescribed automorphism.
#[derive(Debug, Clone)]
pub struct Corner<R, const QUOTIENT: bool> {
    steps: Vec<Step>,
    value: Vec<u8>,
    rule: R,
    caps: Caps,
    /// Bits of a color in the index of a row.
    shift: u32,
    /// The color maps of 0, 1, … steps of the automorphism.
    maps: Vec<Vec<u8>>,
    /// By level: one more than the largest color used before it.
    used: Vec<u8>,
    /// By that number: the colors that may follow.
    follow: Vec<u64>,
}

impl<R: Rule, const QUOTIENT: bool> Corner<R, QUOTIENT> {
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
        let levels = plan.steps.len();
        let largest = (1u64 << (count - 1)) | ((1u64 << (count - 1)) - 1);
        let follow = (0..=count as u32)
            .map(|used| match reduction.ordered_from {
                Some(_) => largest & u64::MAX.checked_shl(used + 1).map_or(u64::MAX, |high| !high),
                None => largest,
            })
            .collect();
        let mut problem = Self {
            steps: plan.steps,
            value: vec![0; task.shape.cells()],
            rule: rule(allowed),
            caps: caps(task, shift),
            shift,
            maps,
            used: vec![0; levels + 1],
            follow,
        };
        for step in &plan.fixed {
            if let Err(cell) = problem.fix(step, &given) {
                let (row, column) = task.shape.position(crate::torus::Cell(cell));
                return match task.has_pins() {
                    true => Err(TaskError::Pins(format!(
                        "the color at row {row}, column {column} breaks the law of the set or of the automorphism"
                    ))),
                    false => Ok(None),
                };
            }
        }
        let largest_fixed = given.iter().flatten().max().map_or(0, |&color| color + 1);
        problem.used[0] = largest_fixed;
        Ok(Some(problem))
    }

    /// Places what is known beforehand, or names the point that contradicts.
    fn fix(&mut self, step: &Step, given: &[Option<u8>]) -> Result<(), u32> {
        let orbit = step.orbit.iter().zip(&self.maps);
        let known = orbit.clone().find_map(|(&cell, map)| {
            let color = given[cell as usize]?;
            map.iter().position(|&image| image == color).map(|x| x as u8)
        });
        let color = known.ok_or(step.cell)?;
        for (&cell, map) in orbit {
            if given[cell as usize].is_some_and(|pin| pin != map[usize::from(color)]) {
                return Err(cell);
            }
        }
        if self.place_checked(step, color) { Ok(()) } else { Err(step.cell) }
    }

    #[inline(always)]
    fn row(&self, known: [u8; 3]) -> usize {
        let [a, b, c] = known.map(usize::from);
        (a << self.shift | b) << self.shift | c
    }

    #[inline(always)]
    fn write(&mut self, cell: u32, orbit: &[u32], color: u8) {
        self.value[cell as usize] = color;
        if QUOTIENT {
            for (&cell, map) in orbit.iter().zip(&self.maps).skip(1) {
                self.value[cell as usize] = map[usize::from(color)];
            }
        }
    }

    /// Applies `change` to a window and to its images.
    #[inline(always)]
    fn each_image(&mut self, known: [u8; 3], free: u8, change: impl Fn(&mut R, usize, u32)) {
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

    /// Applies `change` to a pair of colors and to its images.
    #[inline(always)]
    fn each_pair(&mut self, first: u8, second: u8, change: impl Fn(&mut Caps, u8, u8)) {
        change(&mut self.caps, first, second);
        if QUOTIENT {
            for map in &self.maps[1..] {
                change(&mut self.caps, map[usize::from(first)], map[usize::from(second)]);
            }
        }
    }

    /// Places the color of a step; true when nothing was violated. Either way it is placed as
    /// far as `unplace_general` with the number of windows taken undoes.
    fn place_general(&mut self, step: &Step, color: u8) -> (usize, bool) {
        self.write(step.cell, &step.orbit, color);
        self.each_pair(color, color, |caps, color, _| caps.take_color(color));
        for &(a, b) in &step.across {
            let (a, b) = (self.value[a as usize], self.value[b as usize]);
            self.each_pair(a, b, Caps::take_across);
        }
        for &(a, b) in &step.along {
            let (a, b) = (self.value[a as usize], self.value[b as usize]);
            self.each_pair(a, b, Caps::take_along);
        }
        if !self.caps.hold() {
            return (0, false);
        }
        for (taken, window) in step.windows.iter().enumerate() {
            let (known, free) = colors(window, &self.value);
            if self.rule.open(self.row(known)) >> free & 1 == 0 {
                return (taken, false);
            }
            self.each_image(known, free, R::take);
        }
        (step.windows.len(), self.rule.holds())
    }

    fn unplace_general(&mut self, step: &Step, color: u8, windows: usize) {
        for window in step.windows[..windows].iter().rev() {
            let (known, free) = colors(window, &self.value);
            self.each_image(known, free, R::release);
        }
        for &(a, b) in &step.along {
            let (a, b) = (self.value[a as usize], self.value[b as usize]);
            self.each_pair(a, b, Caps::release_along);
        }
        for &(a, b) in &step.across {
            let (a, b) = (self.value[a as usize], self.value[b as usize]);
            self.each_pair(a, b, Caps::release_across);
        }
        self.each_pair(color, color, |caps, color, _| caps.release_color(color));
    }

    /// Places a color if nothing is violated.
    fn place_checked(&mut self, step: &Step, color: u8) -> bool {
        let (windows, fits) = self.place_general(step, color);
        if !fits {
            self.unplace_general(step, color, windows);
        }
        fits
    }

    /// Of some candidates those that fit, each tried out.
    #[inline(never)]
    fn tried(&mut self, level: usize, candidates: u64) -> u64 {
        let steps = std::mem::take(&mut self.steps);
        let step = &steps[level];
        let mut fitting = candidates;
        for color in Words([candidates]).numbers() {
            let (windows, fits) = self.place_general(step, color as u8);
            self.unplace_general(step, color as u8, windows);
            if !fits {
                fitting &= !(1 << color);
            }
        }
        self.steps = steps;
        fitting
    }

    #[inline(never)]
    fn push_general(&mut self, level: usize, color: u8) {
        let steps = std::mem::take(&mut self.steps);
        self.place_general(&steps[level], color);
        self.steps = steps;
    }

    #[inline(never)]
    fn pop_general(&mut self, level: usize, color: u8) {
        let steps = std::mem::take(&mut self.steps);
        self.unplace_general(&steps[level], color, steps[level].windows.len());
        self.steps = steps;
    }
}

impl<R: Rule, const QUOTIENT: bool> Problem for Corner<R, QUOTIENT> {
    type Alternatives = Words<1>;

    fn levels(&self) -> usize {
        self.steps.len()
    }

    #[inline(always)]
    fn alternatives(&mut self, level: usize) -> Words<1> {
        let step = &self.steps[level];
        let follow = self.follow[usize::from(self.used[level])];
        Words([match step.simple {
            Some(known) if R::EXACT => {
                let known = known.map(|cell| self.value[cell as usize]);
                follow & self.caps.open(known) & self.rule.open(self.row(known))
            }
            _ => self.tried(level, follow & self.caps.open_colors()),
        }])
    }

    #[inline(always)]
    fn push(&mut self, level: usize, choice: u32) {
        let color = choice as u8;
        self.used[level + 1] = self.used[level].max(color + 1);
        let step = &self.steps[level];
        let Some(known) = step.simple else { return self.push_general(level, color) };
        let known = known.map(|cell| self.value[cell as usize]);
        if QUOTIENT {
            for (&cell, map) in step.orbit.iter().zip(&self.maps) {
                self.value[cell as usize] = map[usize::from(color)];
            }
        } else {
            self.value[step.cell as usize] = color;
        }
        self.each_pair(color, color, |caps, color, _| caps.take_color(color));
        self.each_pair(known[2], color, Caps::take_across);
        self.each_pair(known[1], color, Caps::take_along);
        self.each_image(known, color, R::take);
    }

    #[inline(always)]
    fn pop(&mut self, level: usize, choice: u32) {
        let color = choice as u8;
        let Some(known) = self.steps[level].simple else { return self.pop_general(level, color) };
        let known = known.map(|cell| self.value[cell as usize]);
        self.each_image(known, color, R::release);
        self.each_pair(known[1], color, Caps::release_along);
        self.each_pair(known[2], color, Caps::release_across);
        self.each_pair(color, color, |caps, color, _| caps.release_color(color));
    }
}

impl<R: Rule, const QUOTIENT: bool> Labeled for Corner<R, QUOTIENT> {
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
        labels.extend_from_slice(&self.value);
    }
}

/// A tile as the colors of a window's known corners and free corner.
fn window_colors(set: &TileSet, sides: [u8; 4]) -> [u8; 4] {
    let [ne, se, sw, nw] = sides;
    if set.is_compact() { [sw, se, nw, ne] } else { [nw, ne, sw, se] }
}

/// For every row the tiles that may be placed: those of the set that an automorphism lets
/// occur. A tile takes its images along; in a packing they must be different tiles, and of a
/// row at most `limit` may be taken.
fn allowed_rows(
    set: &TileSet,
    shift: u32,
    maps: &[Vec<u8>],
    packing: bool,
    limit: Option<usize>,
) -> Vec<u64> {
    let mut rows = vec![0; 1 << (3 * shift)];
    let mut images: Vec<(usize, u8)> = Vec::with_capacity(maps.len());
    for tile in set.allowed() {
        let sides = window_colors(set, Kind::Corner.unpack(tile, set.colors()));
        let image = |map: &Vec<u8>| {
            let [a, b, c, free] = sides.map(|color| map[usize::from(color)]);
            let [a, b, c] = [a, b, c].map(usize::from);
            ((a << shift | b) << shift | c, free)
        };
        images.clear();
        images.extend(maps.iter().map(image));
        let (row, free) = images[0];
        images.sort_unstable();
        let twice = images.windows(2).any(|pair| pair[0] == pair[1]);
        images.dedup();
        let crowded =
            limit.is_some_and(|limit| images.iter().filter(|image| image.0 == row).count() > limit);
        if !(crowded || packing && twice) {
            rows[row] |= 1 << free;
        }
    }
    rows
}

fn caps(task: &Task, shift: u32) -> Caps {
    let set = &task.set;
    let tiles =
        set.allowed().map(|tile| window_colors(set, Kind::Corner.unpack(tile, set.colors())));
    let spare = (task.shape.cells() as u64 - set.size()) as i32;
    let weight = if set.is_compact() { (2, set.colors().horizontal() as i32) } else { (1, 1) };
    Caps::new(shift, tiles, weight, spare)
}
