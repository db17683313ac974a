//! Which Wang tiles may still be placed: the law of the set, kept while the search runs.
//!
//! Tiles are numbered densely, in the order of the set, and a state is a few words.

use super::table::Table;
use crate::search::{Alternatives, Words};

/// The law of a set of Wang tiles.
///
/// What is open after the choices of all levels below one is asked for by that level.
pub trait WangRule<const N: usize>: Clone + Send + Sync {
    /// Whether [`WangRule::open`] decides alone even where a tile brings images along.
    const EXACT: bool;

    /// Whether what is open at a level is kept by level, and is what was open at the one before
    /// less the tile taken there.
    const BY_LEVEL: bool = false;

    /// The tiles that may be placed at `level`.
    fn open(&self, level: usize) -> Words<N>;

    /// Whether a tile together with its images may be placed at `level`.
    fn fits(&mut self, level: usize, images: &[u32]) -> bool;

    /// Places a tile and its images, itself first, at `level`.
    fn take(&mut self, level: usize, images: &[u32]);

    /// Takes back what was placed at `level`.
    fn release(&mut self, level: usize, images: &[u32]);

    /// Places tiles before level 0, for good.
    fn fix(&mut self, images: &[u32]) {
        self.take(0, images);
    }
}

/// Every tile exactly once.
///
/// The free tiles are kept level by level, so that nothing has to be taken back.
#[derive(Debug, Clone)]
pub struct Once<const N: usize, const L: usize> {
    free: Table<Words<N>, L>,
}

impl<const N: usize, const L: usize> Once<N, L> {
    /// All of `tiles` tiles are free.
    pub fn new(tiles: usize) -> Self {
        Self { free: Table::new(vec![Words::below(tiles)], Words::EMPTY) }
    }
}

impl<const N: usize, const L: usize> WangRule<N> for Once<N, L> {
    const EXACT: bool = true;
    const BY_LEVEL: bool = true;

    #[inline(always)]
    fn open(&self, level: usize) -> Words<N> {
        self.free[level]
    }

    fn fits(&mut self, level: usize, images: &[u32]) -> bool {
        let mut free = self.free[level];
        images.iter().all(|&image| {
            let was_free = free.contains(image);
            free.remove(image);
            was_free
        })
    }

    #[inline(always)]
    fn take(&mut self, level: usize, images: &[u32]) {
        let mut free = self.free[level];
        for &image in images {
            free.remove(image);
        }
        self.free[level + 1] = free;
    }

    #[inline(always)]
    fn release(&mut self, _: usize, _: &[u32]) {}

    fn fix(&mut self, images: &[u32]) {
        self.take(0, images);
        self.free[0] = self.free[1];
    }
}

/// The classes of a compact set: the tiles with the same north and west colors, of which two
/// are taken.
#[derive(Debug, Clone)]
struct Classes<const N: usize> {
    of: Vec<u32>,
    tiles: Vec<Words<N>>,
    taken: Vec<u32>,
}

impl<const N: usize> Classes<N> {
    /// `of` is the class of every tile.
    fn new(of: Vec<u32>) -> Self {
        let classes = of.iter().max().map_or(0, |&class| class as usize + 1);
        let mut tiles = vec![Words::EMPTY; classes];
        for (tile, &class) in of.iter().enumerate() {
            tiles[class as usize].insert(tile as u32);
        }
        Self { of, tiles, taken: vec![0; classes] }
    }

    fn class(&self, tile: u32) -> usize {
        self.of[tile as usize] as usize
    }

    /// Counts a new tile of its class; the class when it is full now.
    fn fill(&mut self, tile: u32) -> Option<Words<N>> {
        let class = self.class(tile);
        self.taken[class] += 1;
        (self.taken[class] == 2).then(|| self.tiles[class])
    }

    /// Takes back what `fill` counted; the class when it is no longer full.
    fn empty(&mut self, tile: u32) -> Option<Words<N>> {
        let class = self.class(tile);
        self.taken[class] -= 1;
        (self.taken[class] == 1).then(|| self.tiles[class])
    }
}

/// Two different tiles of every class, each once: a compact set chosen by the search.
#[derive(Debug, Clone)]
pub struct Pairs<const N: usize> {
    free: Words<N>,
    full: Words<N>,
    classes: Classes<N>,
}

impl<const N: usize> Pairs<N> {
    /// Nothing is taken; `class` is the class of every tile.
    pub fn new(class: Vec<u32>) -> Self {
        let free = Words::below(class.len());
        Self { free, full: Words::EMPTY, classes: Classes::new(class) }
    }
}

impl<const N: usize> WangRule<N> for Pairs<N> {
    const EXACT: bool = true;

    #[inline(always)]
    fn open(&self, _: usize) -> Words<N> {
        self.free & !self.full
    }

    fn fits(&mut self, level: usize, images: &[u32]) -> bool {
        tried(self, level, images)
    }

    fn take(&mut self, _: usize, images: &[u32]) {
        for &tile in images {
            self.free.remove(tile);
            if let Some(class) = self.classes.fill(tile) {
                self.full |= class;
            }
        }
    }

    fn release(&mut self, _: usize, images: &[u32]) {
        for &tile in images.iter().rev() {
            self.free.insert(tile);
            if let Some(class) = self.classes.empty(tile) {
                self.full &= !class;
            }
        }
    }
}

/// Every tile at least once, or two different ones of every class at least once.
///
/// The law is kept by counting the spare cells; see [`super::rule::Cover`].
#[derive(Debug, Clone)]
pub struct Cover<const N: usize> {
    free: Words<N>,
    full: Words<N>,
    uses: Vec<u32>,
    spare: i64,
    classes: Option<Classes<N>>,
}

impl<const N: usize> Cover<N> {
    /// Nothing is taken; `spare` is the number of cells beyond the number of tiles, `class` the
    /// class of every tile for compact sets.
    pub fn new(tiles: usize, spare: u64, class: Option<Vec<u32>>) -> Self {
        Self {
            free: Words::below(tiles),
            full: Words::EMPTY,
            uses: vec![0; tiles],
            spare: spare as i64,
            classes: class.map(Classes::new),
        }
    }
}

impl<const N: usize> WangRule<N> for Cover<N> {
    const EXACT: bool = false;

    fn open(&self, _: usize) -> Words<N> {
        let fresh = self.free & !self.full;
        if self.spare > 0 { fresh | !self.free } else { fresh }
    }

    fn fits(&mut self, level: usize, images: &[u32]) -> bool {
        tried(self, level, images)
    }

    fn take(&mut self, _: usize, images: &[u32]) {
        for &tile in images {
            self.uses[tile as usize] += 1;
            if self.uses[tile as usize] > 1 {
                self.spare -= 1;
                continue;
            }
            self.free.remove(tile);
            if let Some(class) = self.classes.as_mut().and_then(|classes| classes.fill(tile)) {
                self.full |= class;
            }
        }
    }

    fn release(&mut self, _: usize, images: &[u32]) {
        for &tile in images.iter().rev() {
            self.uses[tile as usize] -= 1;
            if self.uses[tile as usize] > 0 {
                self.spare += 1;
                continue;
            }
            self.free.insert(tile);
            if let Some(class) = self.classes.as_mut().and_then(|classes| classes.empty(tile)) {
                self.full &= !class;
            }
        }
    }
}

/// Whether all images are open when placed one after the other; leaves the rule as it was.
fn tried<const N: usize, R: WangRule<N>>(rule: &mut R, level: usize, images: &[u32]) -> bool {
    let placed = images.iter().take_while(|&&image| {
        let open = rule.open(level).contains(image);
        if open {
            rule.take(level, &[image]);
        }
        open
    });
    let placed = placed.count();
    rule.release(level, &images[..placed]);
    placed == images.len()
}
