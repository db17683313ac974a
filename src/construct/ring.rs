//! Rings of all `C^2` dominoes over `C` colors: de Bruijn sequences of order 2, both ways.
//!
//! * The lexicographically least, `0 0 1 0 2 … 1 1 2 1 3 …`: block `b` begins at
//!   `st(b) = C^2 - (C-b)^2`, is `b b b+1 b b+2 … b C-1`, and so alternates `b` with the colors
//!   from `b` on. Which block holds a position is a square root.
//! * Wei's (2004, section 4.1): the ring for `C + 1` colors begins with the ring for `C`, so
//!   positions do not depend on `C`: dominoes whose larger color is `b` fill `b^2 … (b+1)^2 - 1`.
//!
//! There are `(C!)^C / C^2` rings in all; [`Ring::random`] gives any of them.

use super::{Digraph, NoCircuit, Seed};

/// The color at a position of the least ring over `colors` colors; `position < colors^2`.
pub fn least_color(colors: usize, position: usize) -> u8 {
    let block = colors - 1 - (colors * colors - 1 - position).isqrt();
    let offset = position - least_start(colors, block);
    (if offset.is_multiple_of(2) { block + offset / 2 } else { block }) as u8
}

/// The position in the least ring of the domino `first second`; both below `colors`.
pub fn least_position(colors: usize, first: u8, second: u8) -> usize {
    let (x, y) = (usize::from(first), usize::from(second));
    if y > x {
        least_start(colors, x) + 2 * (y - x) - 1
    } else if x == colors - 1 {
        // The last color of a block is followed by the next block, the very last by the first.
        (if y == 0 { colors * colors } else { least_start(colors, y) }) - 1
    } else {
        least_start(colors, y) + 2 * (x - y)
    }
}

/// Where block `block` of the least ring begins.
fn least_start(colors: usize, block: usize) -> usize {
    colors * colors - (colors - block) * (colors - block)
}

/// The color at a position of Wei's ring, over any number of colors above its root.
pub fn wei_color(position: usize) -> u8 {
    let block = position.isqrt();
    let offset = position - block * block;
    (if offset.is_multiple_of(2) && offset < 2 * block { offset / 2 } else { block }) as u8
}

/// The position in Wei's ring of the domino `first second`.
pub fn wei_position(first: u8, second: u8) -> usize {
    let (x, y) = (usize::from(first), usize::from(second));
    if x < y {
        y * y + 2 * x
    } else if y > 0 {
        x * x + 2 * y - 1
    } else {
        (x + 1) * (x + 1) - 1
    }
}

/// A ring of dominoes, and where each domino lies.
#[derive(Debug, Clone)]
pub struct Ring {
    colors: Vec<u8>,
    palette: usize,
    /// For every domino its position; [`NOWHERE`] if it does not occur.
    positions: Vec<u16>,
}

/// The position of a domino that is not part of a ring.
const NOWHERE: u16 = u16::MAX;

impl Ring {
    /// The least ring over `colors` colors.
    pub fn least(colors: usize) -> Self {
        Self::of(colors, (0..colors * colors).map(|p| least_color(colors, p)).collect())
    }

    /// Wei's ring over `colors` colors: it begins with that over fewer.
    pub fn wei(colors: usize) -> Self {
        Self::of(colors, (0..colors * colors).map(wei_color).collect())
    }

    /// Wei's ring backwards: it ends with that over fewer colors, backwards.
    pub fn wei_backward(colors: usize) -> Self {
        let length = colors * colors;
        Self::of(colors, (0..length).map(|p| wei_color((length - p) % length)).collect())
    }

    /// A ring of all dominoes over `colors` colors, chosen by a seed.
    pub fn random(colors: usize, seed: &mut Seed) -> Self {
        match Self::of_digraph(&Digraph::complete(colors), Some(seed)) {
            Ok(ring) => ring,
            // A complete graph has a circuit.
            Err(_) => Self::least(colors),
        }
    }

    /// The least ring, or without the least one chosen by the seed.
    pub fn choose(colors: usize, seed: Option<&mut Seed>) -> Self {
        match seed {
            None => Self::least(colors),
            Some(seed) => Self::random(colors, seed),
        }
    }

    /// A ring of the dominoes that are the arcs of a graph.
    ///
    /// # Errors
    /// Why there is none.
    pub fn of_digraph(graph: &Digraph, seed: Option<&mut Seed>) -> Result<Self, NoCircuit> {
        Ok(Self::of(graph.vertices(), graph.circuit(seed)?))
    }

    fn of(palette: usize, colors: Vec<u8>) -> Self {
        let mut positions = vec![NOWHERE; palette * palette];
        for (position, &first) in colors.iter().enumerate() {
            let second = colors[(position + 1) % colors.len()];
            positions[usize::from(first) * palette + usize::from(second)] = position as u16;
        }
        Self { colors, palette, positions }
    }

    /// The first colors of its dominoes, in order.
    pub fn colors(&self) -> &[u8] {
        &self.colors
    }

    /// The number of dominoes.
    pub fn length(&self) -> usize {
        self.colors.len()
    }

    /// Where the domino `first second` lies, both below the number of colors; `None` if it is
    /// not part of the ring.
    pub fn position(&self, first: u8, second: u8) -> Option<usize> {
        let position = self.positions[usize::from(first) * self.palette + usize::from(second)];
        (position != NOWHERE).then_some(position as usize)
    }

    /// As [`Ring::position`] for a ring of all dominoes, where every domino lies somewhere.
    pub(super) fn place(&self, first: u8, second: u8) -> usize {
        self.positions[usize::from(first) * self.palette + usize::from(second)] as usize
    }
}
