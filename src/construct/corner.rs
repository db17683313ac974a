//! Tori of all corner tiles: which construction gives a torus of a shape, and the torus.
//!
//! A torus of `R x S = C^4` cells (rows, columns; both sides at least 3, see
//! [`super::registry`]) comes directly for `C^2 x C^2`, and for `C` odd, `C^3 x C`; else as a
//! product over coprime numbers of colors, or as the extension of a torus over fewer colors.
//! [`Plan::search`] tries all ways to take the shape apart. That it finds none proves nothing.

use super::Seed;
use super::corner_even::EvenTorus;
use super::corner_odd::OddTorus;
use super::corner_tall::TallTorus;
use super::extend::Extended;
use super::product::Product;

/// The colors of a tile: NW and NE, SW and SE.
pub type Window = [[u8; 2]; 2];

/// How to make a torus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Plan {
    /// The square over an odd number of colors.
    Odd(usize),
    /// The square over an even number of colors.
    Even(usize),
    /// `C^3` high and `C` wide, or the other way round.
    Tall {
        /// The number of colors.
        colors: usize,
        /// Whether the long side lies along the rows.
        wide: bool,
    },
    /// The product of two tori.
    Product(Box<Plan>, Box<Plan>),
    /// A smaller torus, extended.
    Extended {
        /// How to make the smaller torus.
        base: Box<Plan>,
        /// How many times as many colors.
        k: usize,
        /// How many of the four factors `k` lengthen the columns.
        m: usize,
    },
}

impl Plan {
    /// A way to make a torus of this many rows and columns, the simplest first; `None` if none
    /// is known, or the shape has not `colors^4` cells.
    pub fn search(colors: usize, height: usize, width: usize) -> Option<Self> {
        let square = colors * colors;
        if colors == 0 || (height as u64) * (width as u64) != (square as u64).pow(2) {
            return None;
        }
        let odd = !colors.is_multiple_of(2);
        if height == square && width == square {
            return Some(if odd { Plan::Odd(colors) } else { Plan::Even(colors) });
        }
        if height < 3 || width < 3 {
            return None;
        }
        if odd && height.min(width) == colors {
            return Some(Plan::Tall { colors, wide: width > height });
        }
        let factors = || (2..colors).filter(|&factor| colors.is_multiple_of(factor));
        let product = factors().find_map(|first| {
            let second = colors / first;
            if gcd(first, second) != 1 || first > second {
                return None;
            }
            let part = |of: usize| gcd(of, first.pow(4));
            let (r, s) = (part(height), part(width));
            let one = Self::search(first, r, s)?;
            let other = Self::search(second, height / r, width / s)?;
            Some(Plan::Product(Box::new(one), Box::new(other)))
        });
        product.or_else(|| {
            factors().find_map(|k| {
                (0..=4).find_map(|m| {
                    let (down, along) = (k.pow(m), k.pow(4 - m));
                    if !height.is_multiple_of(down) || !width.is_multiple_of(along) {
                        return None;
                    }
                    let base = Self::search(colors / k, height / down, width / along)?;
                    Some(Plan::Extended { base: Box::new(base), k, m: m as usize })
                })
            })
        })
    }

    /// Makes the torus: the closed form, or the member that a seed chooses.
    pub fn build(&self, mut seed: Option<&mut Seed>) -> CornerTorus {
        match self {
            &Plan::Odd(colors) => CornerTorus::Odd { colors, torus: OddTorus::new(colors, seed) },
            &Plan::Even(colors) => {
                CornerTorus::Even { colors, torus: Box::new(EvenTorus::new(colors, seed)) }
            }
            &Plan::Tall { colors, wide } => {
                CornerTorus::Tall { colors, torus: TallTorus::new(colors, wide, seed) }
            }
            Plan::Product(one, other) => {
                let one = one.build(seed.as_deref_mut());
                CornerTorus::Product(Product::new(one, other.build(seed)))
            }
            Plan::Extended { base, k, m } => {
                CornerTorus::Extended(Extended::new(base.build(seed), *k, *m))
            }
        }
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// A torus with every window over its colors exactly once.
#[derive(Debug, Clone)]
pub enum CornerTorus {
    /// See [`super::corner_odd`].
    Odd {
        /// The number of colors.
        colors: usize,
        /// The torus.
        torus: OddTorus,
    },
    /// See [`super::corner_even`].
    Even {
        /// The number of colors.
        colors: usize,
        /// The torus.
        torus: Box<EvenTorus>,
    },
    /// See [`super::corner_tall`].
    Tall {
        /// The number of colors.
        colors: usize,
        /// The torus.
        torus: TallTorus,
    },
    /// See [`super::product`].
    Product(Product),
    /// See [`super::extend`].
    Extended(Extended),
}

impl CornerTorus {
    /// The number of colors.
    pub fn colors(&self) -> usize {
        match self {
            Self::Odd { colors, .. } | Self::Even { colors, .. } | Self::Tall { colors, .. } => {
                *colors
            }
            Self::Product(torus) => torus.colors(),
            Self::Extended(torus) => torus.colors(),
        }
    }

    /// Rows and columns.
    pub fn sides(&self) -> (usize, usize) {
        match self {
            Self::Odd { torus, .. } => (torus.side(), torus.side()),
            Self::Even { torus, .. } => (torus.side(), torus.side()),
            Self::Tall { torus, .. } => torus.sides(),
            Self::Product(torus) => torus.sides(),
            Self::Extended(torus) => torus.sides(),
        }
    }

    /// Writes the colors of a row, as many as there are columns.
    pub fn row(&self, row: usize, colors: &mut [u8]) {
        match self {
            Self::Odd { torus, .. } => torus.row(row, colors),
            Self::Even { torus, .. } => torus.row(row, colors),
            Self::Tall { torus, .. } => torus.row(row, colors),
            Self::Product(torus) => torus.row(row, colors),
            Self::Extended(torus) => torus.row(row, colors),
        }
    }

    /// The row and column of the cell with this window of colors, each below [`Self::colors`].
    pub fn find(&self, window: Window) -> (usize, usize) {
        match self {
            Self::Odd { torus, .. } => torus.find(window),
            Self::Even { torus, .. } => torus.find(window),
            Self::Tall { torus, .. } => torus.find(window),
            Self::Product(torus) => torus.find(window),
            Self::Extended(torus) => torus.find(window),
        }
    }

    /// The construction in words: `4x4 over 2 colors, extended to 3 times the colors`.
    pub fn name(&self) -> String {
        match self {
            Self::Odd { .. } => "rotated rings".to_owned(),
            Self::Even { .. } => "numbered 4x4 blocks".to_owned(),
            Self::Tall { .. } => "raised and rotated triangular numbers".to_owned(),
            Self::Product(torus) => {
                let (one, other) = torus.factors();
                format!("product of {} and {}", one.part(), other.part())
            }
            Self::Extended(torus) => format!("extension of {}", torus.base().part()),
        }
    }

    /// The same as a part of another name.
    fn part(&self) -> String {
        let (height, width) = self.sides();
        format!("{width}x{height} over {} colors ({})", self.colors(), self.name())
    }
}
