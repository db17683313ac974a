//! From a dappled tiling to others with more or fewer of a tile, a cell at a time.
//!
//! A step changes one cell that is not given, so that the tiling stays dappled; steps away from the
//! number that is wanted are taken now and then (Metropolis, at a temperature of their own). All
//! numbers on the way are those of dappled tilings.

use crate::dappled::{FREE, Field, Rule};
use crate::search::Stop;
use rand::RngExt;
use rand_pcg::Pcg64;

/// Steps that are tried for each cell.
const EFFORT: usize = 400;
/// How likely a step away is.
const AWAY: f64 = 0.05;

/// A dappled tiling that changes.
pub(super) struct Walk<'a> {
    rule: &'a Rule,
    partial: &'a Field,
    tile: u8,
    /// For every cell its windows: a set, and cells in `members`.
    windows: Vec<(u64, u32, u32)>,
    members: Vec<u32>,
    first: Vec<u32>,
    of_cell: Vec<u32>,
}

impl<'a> Walk<'a> {
    /// Walks among the completions of a partial tiling.
    pub(super) fn new(rule: &'a Rule, partial: &'a Field, tile: u8) -> Self {
        let cells = partial.cells().len();
        let (mut windows, mut members) = (Vec::new(), Vec::new());
        let mut first = vec![0; cells + 1];
        for window in rule.windows() {
            let begin = members.len() as u32;
            members.extend(&window.cells);
            windows.push((window.set, begin, members.len() as u32));
            window.cells.iter().for_each(|&cell| first[cell as usize + 1] += 1);
        }
        for cell in 0..cells {
            first[cell + 1] += first[cell];
        }
        let mut place = first.clone();
        let mut of_cell = vec![0; members.len()];
        for (number, &(_, from, to)) in (0u32..).zip(&windows) {
            for &cell in &members[from as usize..to as usize] {
                of_cell[place[cell as usize] as usize] = number;
                place[cell as usize] += 1;
            }
        }
        Self { rule, partial, tile, windows, members, first, of_cell }
    }

    /// How many of the tile a tiling has.
    pub(super) fn number(&self, tiling: &Field) -> u32 {
        tiling.cells().iter().filter(|&&tile| tile == self.tile).count() as u32
    }

    /// Walks towards a number, until it is reached or the effort is spent; `met` is told of every
    /// tiling on the way, the first included, with its number.
    pub(super) fn towards(
        &self,
        tiling: &mut Field,
        wanted: u32,
        random: &mut Pcg64,
        stop: &dyn Stop,
        mut met: impl FnMut(u32, &Field),
    ) {
        let cells = tiling.cells().len();
        let mut number = self.number(tiling);
        met(number, tiling);
        for step in 0..EFFORT * cells {
            if number == wanted || step % 4096 == 4095 && stop.should_stop() {
                return;
            }
            let cell = random.random_range(0..cells);
            let old = tiling.cells()[cell];
            let new = match self.rule.tiles() {
                0 | 1 => return,
                tiles => (old + random.random_range(1..tiles as u8)) % tiles as u8,
            };
            let nearer = match (old == self.tile, new == self.tile) {
                (true, _) => number > wanted,
                (_, true) => number < wanted,
                _ => true,
            };
            if self.partial.cells()[cell] != FREE || !nearer && !random.random_bool(AWAY) {
                continue;
            }
            tiling.cells_mut()[cell] = new;
            if !self.stays(tiling, cell) {
                tiling.cells_mut()[cell] = old;
                continue;
            }
            number += u32::from(new == self.tile);
            number -= u32::from(old == self.tile);
            met(number, tiling);
        }
    }

    /// Whether all windows of a cell are kept.
    fn stays(&self, tiling: &Field, cell: usize) -> bool {
        let own = &self.of_cell[self.first[cell] as usize..self.first[cell + 1] as usize];
        own.iter().all(|&window| {
            let (set, from, to) = self.windows[window as usize];
            let mut members = self.members[from as usize..to as usize].iter();
            members.any(|&cell| set >> tiling.cells()[cell as usize] & 1 == 0)
        })
    }
}
