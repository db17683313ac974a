//! Is a packing recursive?
//!
//! A packing of all tiles over `C` colors is recursive when the block in its south-west, as large
//! as a packing over `C - 1` colors, is one: it has only the first `C - 1` colors, closes on its
//! own as a torus, holds every tile over these colors once, and is recursive itself. A packing
//! over two colors has nothing to show; where a tile of one color stands in its corner, that is a
//! block, too. Of Wang tiles both palettes lose a color at a time, while both have two or more;
//! a block is `CV^2` wide and `CH^2` high. A block of dominoes is the beginning of a ring that
//! runs along a row, and the end of one that runs down a column.
//!
//! Whether the whole is a packing is for [`super::check`] to say. No code is shared with it.
//!
//! Source: Lagae 2007, section 5.5, figures 5.11 and 5.12.

use super::Place;
use crate::tiles::{Kind, Members};
use crate::torus::{Packing, Shape};
use std::fmt;

/// A block of a packing, at its south-west.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Block {
    /// Colors of north and south edges; of corners and dominoes.
    pub horizontal: u8,
    /// Colors of east and west edges; the same number for corners and dominoes.
    pub vertical: u8,
    /// Its columns.
    pub width: usize,
    /// Its rows.
    pub height: usize,
    /// Its north-west tile.
    pub at: Place,
}

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { horizontal: h, vertical: v, width, height, at } = self;
        write!(f, "{width}x{height} block over {h}")?;
        if h != v {
            write!(f, ",{v}")?;
        }
        write!(f, " color{} at {at}", if (*h, *v) == (1, 1) { "" } else { "s" })
    }
}

/// Why a packing is not recursive.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NotRecursive {
    /// Recursion is about all tiles over some colors, each of them once.
    #[error("only a packing of a complete set can be recursive")]
    Set,
    /// The blocks of another torus have no sides to begin with.
    #[error("size {found}: a recursive packing over these colors has size {expected}")]
    Size {
        /// Of the packing.
        found: Shape,
        /// What it would have to be.
        expected: String,
    },
    /// A tile of a block shows a color that the block may not have.
    #[error("the {block} has color {color} ({part} of the tile at {at})")]
    Color {
        /// The block.
        block: Block,
        /// The tile.
        at: Place,
        /// `NE`, `west`.
        part: &'static str,
        /// The color.
        color: u64,
    },
    /// Tiles that meet when the block is a torus do not fit.
    #[error(
        "the {block} does not close: {part} of the tile at {at} is {}, but {other} of the tile at \
         {neighbor} is {}", .colors[0], .colors[1]
    )]
    Seam {
        /// The block.
        block: Block,
        /// A tile.
        at: Place,
        /// Its side or corner.
        part: &'static str,
        /// The tile to its east or south, around the block.
        neighbor: Place,
        /// Its side or corner.
        other: &'static str,
        /// The colors there.
        colors: [u8; 2],
    },
    /// A tile occurs again.
    #[error("the {block} has tile {tile} again at {at}")]
    Repeated {
        /// The block.
        block: Block,
        /// Its number in the whole packing.
        tile: u32,
        /// The second place.
        at: Place,
    },
}

/// How deep a packing is recursive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recursion {
    /// The blocks that are packings, from the largest on; each lies in the one before.
    pub blocks: Vec<Block>,
    /// Why the next one is none, if there should be one.
    pub fault: Option<NotRecursive>,
}

/// Looks for the blocks of a packing, which is taken to be one.
pub fn check_recursion(packing: &Packing) -> Recursion {
    let mut blocks = Vec::new();
    let (set, shape) = (&packing.set, packing.shape);
    if packing.cover || *set.members() != Members::Complete {
        return Recursion { blocks, fault: Some(NotRecursive::Set) };
    }
    let (mut h, mut v) = (set.colors().horizontal(), set.colors().vertical());
    if set.kind() == Kind::Domino {
        h = v;
    }
    let sides = |h: usize, v: usize| match set.kind() {
        Kind::Domino if shape.height() > 1 => (1, h * h),
        Kind::Domino => (v * v, 1),
        Kind::Corner | Kind::Wang => (v * v, h * h),
    };
    let (width, height) = sides(h, v);
    if (shape.width(), shape.height()) != (width, height) || packing.tiles.len() != width * height {
        let expected = format!("{width}x{height}");
        return Recursion { blocks, fault: Some(NotRecursive::Size { found: shape, expected }) };
    }
    let tiles = Digits { packing, h: h as u64, v: v as u64 };
    while h.min(v) > 1 {
        (h, v) = (h - 1, v - 1);
        let (width, height) = sides(h, v);
        let at = Place { row: shape.height() - height, column: 0 };
        // There are at most 255 colors.
        let block = Block { horizontal: h as u8, vertical: v as u8, width, height, at };
        match tiles.check(block) {
            Ok(()) => blocks.push(block),
            // Over two colors there need not be a block.
            Err(_) if h.min(v) == 1 => break,
            Err(fault) => return Recursion { blocks, fault: Some(fault) },
        }
    }
    Recursion { blocks, fault: None }
}

/// The tiles of a packing, read color by color.
struct Digits<'a> {
    packing: &'a Packing,
    h: u64,
    v: u64,
}

impl Digits<'_> {
    /// The colors of a tile, as the digits of its number from the first on, each with its name
    /// and whether it is of a vertical edge.
    fn parts(&self, at: Place) -> Vec<(&'static str, bool, u64)> {
        let names: &[_] = match self.packing.set.kind() {
            Kind::Corner => &[("NE", false), ("SE", false), ("SW", false), ("NW", false)],
            Kind::Wang => &[("north", false), ("east", true), ("south", false), ("west", true)],
            Kind::Domino => &[("first", true), ("second", true)],
        };
        let mut rest =
            u64::from(self.packing.tiles[at.row * self.packing.shape.width() + at.column].0);
        let mut parts = Vec::with_capacity(names.len());
        for &(name, vertical) in names.iter().rev() {
            let radix = if vertical { self.v } else { self.h };
            parts.push((name, vertical, rest % radix));
            rest /= radix;
        }
        parts.reverse();
        parts
    }

    fn check(&self, block: Block) -> Result<(), NotRecursive> {
        let (h, v) = (block.horizontal.into(), block.vertical.into());
        let places = || (0..block.width * block.height).map(|i| (i / block.width, i % block.width));
        let place = |row: usize, column: usize| Place {
            row: block.at.row + row % block.height,
            column: block.at.column + column % block.width,
        };
        let mut seen = vec![false; block.width * block.height];
        for (row, column) in places() {
            let at = place(row, column);
            let mut number = 0;
            for (part, vertical, color) in self.parts(at) {
                let radix = if vertical { v } else { h };
                if color >= radix {
                    return Err(NotRecursive::Color { block, at, part, color });
                }
                number = number * radix + color;
            }
            // As many tiles as numbers, see the sides of the block.
            if std::mem::replace(&mut seen[number as usize], true) {
                let tile = self.packing.tiles[at.row * self.packing.shape.width() + at.column].0;
                return Err(NotRecursive::Repeated { block, tile, at });
            }
        }
        for (row, column) in places() {
            self.meet(block, place(row, column), place(row, column + 1), self.eastward())?;
            self.meet(block, place(row, column), place(row + 1, column), self.southward())?;
        }
        Ok(())
    }

    /// Which digit of a tile meets which of the tile to its east.
    fn eastward(&self) -> &'static [(usize, usize)] {
        match self.packing.set.kind() {
            Kind::Corner => &[(0, 3), (1, 2)],
            Kind::Wang => &[(1, 3)],
            Kind::Domino if self.packing.shape.height() > 1 => &[],
            Kind::Domino => &[(1, 0)],
        }
    }

    /// Which digit of a tile meets which of the tile to its south.
    fn southward(&self) -> &'static [(usize, usize)] {
        match self.packing.set.kind() {
            Kind::Corner => &[(2, 3), (1, 0)],
            Kind::Wang => &[(2, 0)],
            Kind::Domino if self.packing.shape.height() > 1 => &[(1, 0)],
            Kind::Domino => &[],
        }
    }

    fn meet(
        &self,
        block: Block,
        this: Place,
        next: Place,
        pairs: &[(usize, usize)],
    ) -> Result<(), NotRecursive> {
        let (ours, theirs) = (self.parts(this), self.parts(next));
        for &(a, b) in pairs {
            let ((part, _, color), (other, _, meets)) = (ours[a], theirs[b]);
            if color != meets {
                let (at, neighbor, colors) = (this, next, [color as u8, meets as u8]);
                return Err(NotRecursive::Seam { block, at, part, neighbor, other, colors });
            }
        }
        Ok(())
    }
}
