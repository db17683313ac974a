//! Whether the seams of a folded torus can fit the tiles at all.
//!
//! Let all cycles of the color permutation have lengths divisible by `q`, and number the colors
//! along every cycle modulo `q`. The difference between the ends of a domino is then the same
//! for all its images, so the tiles say what the differences along all rows add up to. But along
//! one row they add up to the steps that the seam takes: `height * east` in all. The same for
//! columns, where the shift of the seam takes steps back. If the two disagree there is no
//! packing, and none with tiles used again that are those of a small torus, which add nothing.
//!
//! Source: this project.

use super::rule::Window;
use crate::torus::Fold;

/// Whether the sums agree, for tiles of which one stands for all its images.
pub(super) fn fit(fold: &Fold, tiles: &[Window]) -> bool {
    let Some(images) = fold.powers().get(1) else { return true };
    let (numbers, q) = numbers(images);
    let (east, south, shift) = fold.seams();
    let sum = |ends: fn(&Window) -> [usize; 2]| {
        let difference = |tile: &Window| {
            let [from, to] = ends(tile).map(|color| numbers[color]);
            (to + q - from) % q
        };
        tiles.iter().map(difference).sum::<usize>() % q
    };
    let back = shift % q * (east % q);
    let (along, down) = (fold.height() * east, fold.width() * south + q * q - back);
    along % q == sum(|&[nw, ne, ..]| [nw, ne]) && down % q == sum(|&[nw, _, sw, _]| [nw, sw])
}

/// Colors numbered along their cycles, modulo the greatest common divisor of all lengths, and
/// that divisor.
fn numbers(images: &[u8]) -> (Vec<usize>, usize) {
    let (mut numbers, mut q) = (vec![usize::MAX; images.len()], 0);
    for first in 0..images.len() {
        let (mut color, mut number) = (first, 0);
        while numbers[color] == usize::MAX {
            numbers[color] = number;
            (color, number) = (usize::from(images[color]), number + 1);
        }
        // Nothing was numbered when the cycle has been seen.
        q = gcd(number, q);
    }
    numbers.iter_mut().for_each(|number| *number %= q);
    (numbers, q)
}

/// The greatest common divisor; `gcd(0, n) = n`.
fn gcd(a: usize, b: usize) -> usize {
    if a == 0 { b } else { gcd(b % a, a) }
}
