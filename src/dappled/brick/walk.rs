//! The positions along a row or a column: a walk that stays or moves to another position.
//!
//! In a row a joint keeps its position in h-tiles and changes it in v-tiles, whatever happens in
//! other rows and in columns. So with labels given, every line is a walk of its own: `k` moves on
//! the complete graph of `c` positions. From a position to itself there are
//! `((c-1)^k + (c-1)(-1)^k) / c` of them, to another one `((c-1)^k - (-1)^k) / c`. By these numbers a
//! walk with given ends is chosen, all of them alike.

use super::FREE;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

/// How many walks of `moves` moves lead from a position to itself, or to a certain other one:
/// exactly as long as there are few, then in proportion, to 12 digits.
pub fn weight(moves: usize, same: bool, positions: u8) -> u64 {
    let others = u64::from(positions) - 1;
    let sign = if moves.is_multiple_of(2) { 1 } else { -1 };
    if others == 1 {
        return u64::from(same == (sign == 1));
    }
    if moves < 10 {
        let all = others.pow(moves as u32) as i64;
        let back = if same { all + others as i64 * sign } else { all - sign };
        return (back / (others as i64 + 1)) as u64;
    }
    let part = sign as f64 / (others as f64).powf(moves as f64);
    let back = if same { 1.0 + others as f64 * part } else { 1.0 - part };
    (back * (1_u64 << 50) as f64) as u64
}

/// One of the positions, each as often as its weight says.
fn choose(random: &mut Pcg64Mcg, weights: impl Iterator<Item = (u8, u64)> + Clone) -> Option<u8> {
    let all: u64 = weights.clone().map(|(_, weight)| weight).sum();
    if all == 0 {
        return None;
    }
    let mut left = random.random_range(0..all);
    for (position, weight) in weights {
        if left < weight {
            return Some(position);
        }
        left -= weight;
    }
    None
}

/// A walk along a line: `moves` says for every tile whether the position changes there. Ends may be
/// given, or [`FREE`]; `closed` ones are the same. None if there is no walk.
pub(super) fn walk(
    moves: &[bool],
    (from, to): (u8, u8),
    closed: bool,
    positions: u8,
    random: &mut Pcg64Mcg,
) -> Option<Vec<u8>> {
    let mut left = moves.iter().filter(|&&moves| moves).count();
    let weighted = |left: usize, to: u8| {
        let of = move |x: u8| if to == FREE { 1 } else { weight(left, x == to, positions) };
        (0..positions).map(move |x| (x, of(x)))
    };
    let first = if from == FREE && closed { to } else { from };
    let first = match first {
        FREE if closed => {
            choose(random, (0..positions).map(|x| (x, weight(left, true, positions))))?
        }
        FREE => choose(random, weighted(left, to))?,
        given => given,
    };
    let to = if closed { first } else { to };
    if to != FREE && weight(left, first == to, positions) == 0 {
        return None;
    }
    let mut walk = Vec::with_capacity(moves.len() + 1);
    walk.push(first);
    let mut at = first;
    for &moves in moves {
        if moves {
            left -= 1;
            at = choose(random, weighted(left, to).filter(|&(x, _)| x != at))?;
        }
        walk.push(at);
    }
    Some(walk)
}
