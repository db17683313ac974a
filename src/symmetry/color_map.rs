//! Permutations of the colors: one of each palette.
//!
//! Corner tiles and dominoes have one palette, so both permutations are then the same. Invariant: each is a
//! permutation of `0..CH` or `0..CV`.

use crate::tiles::{Colors, Kind, TileId};

/// A permutation of the horizontal and one of the vertical palette.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ColorMap {
    horizontal: Vec<u8>,
    vertical: Vec<u8>,
}

impl ColorMap {
    /// The map that changes nothing.
    pub fn identity(colors: Colors) -> Self {
        Self::shift(colors, 0)
    }

    /// Adds `amount` to every color, modulo the number of colors of its palette.
    pub fn shift(colors: Colors, amount: usize) -> Self {
        let palette = |count: usize| (0..count).map(|c| ((c + amount) % count) as u8).collect();
        Self { horizontal: palette(colors.horizontal()), vertical: palette(colors.vertical()) }
    }

    /// The map with these images, or `None` when they are not permutations of the palettes.
    pub fn new(colors: Colors, horizontal: Vec<u8>, vertical: Vec<u8>) -> Option<Self> {
        let permutes = |images: &[u8], count: usize| {
            let mut sorted = images.to_vec();
            sorted.sort_unstable();
            sorted.iter().map(|&c| usize::from(c)).eq(0..count)
        };
        (permutes(&horizontal, colors.horizontal()) && permutes(&vertical, colors.vertical()))
            .then_some(Self { horizontal, vertical })
    }

    /// The images of the colors of north and south edges, or of corners.
    pub fn horizontal(&self) -> &[u8] {
        &self.horizontal
    }

    /// The images of the colors of east and west edges, or of corners.
    pub fn vertical(&self) -> &[u8] {
        &self.vertical
    }

    /// First `self`, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        let compose = |a: &[u8], b: &[u8]| a.iter().map(|&c| b[usize::from(c)]).collect();
        Self {
            horizontal: compose(&self.horizontal, &next.horizontal),
            vertical: compose(&self.vertical, &next.vertical),
        }
    }

    /// The map that undoes this one.
    pub fn inverse(&self) -> Self {
        let invert = |images: &[u8]| {
            let mut inverse = vec![0; images.len()];
            for (color, &image) in images.iter().enumerate() {
                inverse[usize::from(image)] = color as u8;
            }
            inverse
        };
        Self { horizontal: invert(&self.horizontal), vertical: invert(&self.vertical) }
    }

    /// The map with the two palettes exchanged; they must be of one size.
    pub fn exchanged(&self) -> Self {
        Self { horizontal: self.vertical.clone(), vertical: self.horizontal.clone() }
    }

    /// The map as tiles with one palette see it, in [`ColorMap::tile`] as everywhere: the
    /// vertical permutation for both.
    pub fn of_one_palette(&self) -> Self {
        Self { horizontal: self.vertical.clone(), vertical: self.vertical.clone() }
    }

    /// Whether it changes nothing.
    pub fn is_identity(&self) -> bool {
        let fixes = |images: &[u8]| images.iter().enumerate().all(|(c, &i)| c == usize::from(i));
        fixes(&self.horizontal) && fixes(&self.vertical)
    }

    /// The tile with every color replaced by its image.
    pub fn tile(&self, kind: Kind, colors: Colors, tile: TileId) -> TileId {
        let sides = kind.unpack(tile, colors);
        let palettes: [&[u8]; 2] = match kind {
            Kind::Wang => [&self.horizontal, &self.vertical],
            Kind::Corner | Kind::Domino => [&self.vertical, &self.vertical],
        };
        let mut image = 0;
        for (i, (&color, radix)) in sides.iter().zip(kind.radices(colors)).enumerate() {
            image = image * radix as u32 + u32::from(palettes[i % 2][usize::from(color)]);
        }
        TileId(image)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn composition_inverse_and_tiles() {
        let colors = Colors::pair(3, 2).unwrap();
        let map = ColorMap::new(colors, vec![2, 0, 1], vec![1, 0]).unwrap();
        assert!(map.then(&map.inverse()).is_identity());
        let moved: Vec<_> =
            Kind::Wang.unpack(map.tile(Kind::Wang, colors, TileId(0)), colors).into();
        assert_eq!(moved, [2, 1, 2, 1]);
        assert_eq!(ColorMap::new(colors, vec![2, 0, 0], vec![1, 0]), None);
        assert_eq!(ColorMap::new(colors, vec![1, 0], vec![1, 0]), None);
    }
}
