//! Tiles to be used once more than the set asks, so that a torus of more cells is filled exactly.
//!
//! In every torus each domino occurs as often on the north as on the south side of a tile, and as
//! often west as east. The tiles of a set are balanced in this way, so those used again must be,
//! too. The tiles that a small torus shows are: a tile of one color, which is the torus of one
//! cell, and those of a few cells. Enough of them are chosen at random, with as few as possible
//! chosen twice.

use super::random::Random;
use super::rule::{Times, Window};

/// Tori tried before the excess is filled with tiles of one color.
const TRIES: usize = 200;

/// What may be chosen.
pub(super) struct Excess {
    /// Tiles to add.
    pub(super) number: usize,
    /// For the tiles of the set, by colors.
    pub(super) allowed: Vec<bool>,
    pub(super) colors: usize,
    /// Sizes of the small tori.
    pub(super) sizes: Vec<(usize, usize)>,
}

impl Excess {
    /// None at all.
    pub(super) fn none() -> Self {
        Self { number: 0, allowed: Vec::new(), colors: 0, sizes: Vec::new() }
    }

    /// The tiles of a random choice.
    pub(super) fn choose(&self, random: &mut Random) -> Vec<Window> {
        let mut chosen: Vec<Window> = Vec::new();
        let mut tries = 0;
        while chosen.len() < self.number {
            let left = self.number - chosen.len();
            tries += 1;
            let (w, h) = self.sizes[random.below(self.sizes.len())];
            let (w, h) = if w * h > left || tries > TRIES { (1, 1) } else { (w, h) };
            let cells: Vec<usize> = (0..w * h).map(|_| random.below(self.colors)).collect();
            let at = |r: usize, c: usize| cells[r % h * w + c % w];
            let window = |r, c| [at(r, c), at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)];
            let shown: Vec<Window> = (0..w * h).map(|i| window(i / w, i % w)).collect();
            let fits = |tile: &Window| {
                let index = tile.iter().fold(0, |i, c| i * self.colors + c);
                let again = chosen.iter().filter(|&other| other == tile).count();
                let most = if tries > TRIES { usize::from(Times::MOST) - 4 } else { 1 };
                self.allowed[index] && again < most
            };
            if shown.iter().all(fits) {
                chosen.extend(shown);
            } else if tries > 100 * TRIES {
                break;
            }
        }
        chosen
    }
}
