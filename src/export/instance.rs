//! A task as other solvers see it: points with colors, and tiles that may lie in cells.
//!
//! A *point* is a label of the torus ([`Lattice`](crate::torus::Lattice)) or, with an
//! automorphism, one of every orbit of labels; the others follow from it. An *option* puts a tile
//! into a cell (again one of every orbit) and asks for the colors of its points.
//!
//! How often tiles lie is said from the definition: the law of a tile lists all options that put
//! it anywhere on the torus, those of the other cells of an orbit being images. An option that
//! shows the tile twice is listed twice. One law for every orbit of tiles is enough.

use crate::packing::Task;
use crate::symmetry::ColorMap;
use crate::tiles::{Kind, Members, TileId};
use crate::torus::Cell;
use std::collections::{BTreeMap, BTreeSet};

/// The largest number of options that is written: some ten GB of text. With all counters there are
/// then fewer than 2^31 variables.
pub const MAX_OPTIONS: u64 = 1 << 28;

/// Why a task cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ExportError {
    /// Too many options.
    #[error(
        "{cells} cells and {tiles} tiles make {options} ways to put a tile into a cell: at most \
         {MAX_OPTIONS} are written"
    )]
    TooLarge {
        /// Cells, one of every orbit.
        cells: u64,
        /// Tiles that may occur.
        tiles: u64,
        /// Their product.
        options: u64,
    },
    /// Boards with outer sides, or squares that are turned.
    #[error("only packings of tori with tiles that are not turned are exported")]
    Board,
    /// The format has no words for it.
    #[error("exact cover with colors cannot say it: {0}")]
    Unsayable(String),
}

/// A label that is its own variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Point {
    /// Its position in the array of labels.
    pub label: usize,
    /// The colors it can have.
    pub colors: usize,
}

/// A tile in a cell, by their positions in [`Instance::cells`] and [`Instance::tiles`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Placed {
    /// The cell.
    pub cell: usize,
    /// The tile.
    pub tile: usize,
}

/// A task taken apart.
#[derive(Debug)]
pub struct Instance<'a> {
    /// The task.
    pub task: &'a Task,
    /// The points.
    pub points: Vec<Point>,
    /// One cell of every orbit: the first.
    pub cells: Vec<Cell>,
    /// The tiles that may occur, in increasing order.
    pub tiles: Vec<TileId>,
    /// For every label its point, and how many steps of the automorphism lead from it.
    ties: Vec<(usize, usize)>,
    /// What takes the color of a label back to that of its point, by steps.
    back: Vec<ColorMap>,
}

impl<'a> Instance<'a> {
    /// Takes a task apart that has been checked.
    ///
    /// # Errors
    /// When it is too large.
    pub fn new(task: &'a Task) -> Result<Self, ExportError> {
        if !task.board.is_plain() {
            return Err(ExportError::Board);
        }
        let (shape, colors) = (task.shape, task.set.colors());
        let (order, step, maps) = match &task.automorphism {
            None => (1, (0, 0), vec![ColorMap::identity(colors)]),
            Some(automorphism) => {
                let order = automorphism.order(shape);
                let step = (i64::from(automorphism.dy), i64::from(automorphism.dx));
                (order, step, automorphism.powers(order, colors))
            }
        };
        let cells = (shape.cells() / order) as u64;
        let tiles = match task.set.members() {
            Members::Complete | Members::Compact => task.set.kind().tiles(colors),
            Members::Pruned(_) | Members::Explicit(_) => task.set.size(),
        };
        let options = cells.saturating_mul(tiles);
        if options > MAX_OPTIONS {
            return Err(ExportError::TooLarge { cells, tiles, options });
        }
        let per_cell = task.lattice().per_cell();
        let mut instance = Self {
            task,
            points: Vec::new(),
            cells: Vec::new(),
            tiles: task.set.allowed().collect(),
            ties: vec![(usize::MAX, 0); task.lattice().labels()],
            back: maps.iter().map(ColorMap::inverse).collect(),
        };
        for cell in (0..shape.cells() as u32).map(Cell) {
            if instance.ties[per_cell * cell.index()].0 != usize::MAX {
                continue;
            }
            instance.cells.push(cell);
            for of_cell in 0..per_cell {
                let label = per_cell * cell.index() + of_cell;
                for steps in 0..order {
                    let (rows, columns) = (step.0 * steps as i64, step.1 * steps as i64);
                    let image = shape.step(cell, rows, columns).index();
                    instance.ties[per_cell * image + of_cell] = (instance.points.len(), steps);
                }
                let colors = instance.palette(label);
                instance.points.push(Point { label, colors });
            }
        }
        Ok(instance)
    }

    /// The point that decides a label.
    pub fn point(&self, label: usize) -> usize {
        self.ties[label].0
    }

    /// The row and column of the cell that a label belongs to.
    pub fn position(&self, label: usize) -> (usize, usize) {
        self.task.shape.position(Cell((label / self.task.lattice().per_cell()) as u32))
    }

    /// The points with the colors given beforehand, or the label that two pins disagree on.
    ///
    /// # Errors
    /// The label.
    pub fn pins(&self) -> Result<Vec<Option<u8>>, usize> {
        let mut pinned = vec![None; self.points.len()];
        for (label, color) in self.task.pins.labels().iter().enumerate() {
            let Some(color) = color else { continue };
            let (point, color) = self.tied(label, *color);
            if pinned[point].replace(color).is_some_and(|known| known != color) {
                return Err(label);
            }
        }
        Ok(pinned)
    }

    /// The number of colors of a label.
    fn palette(&self, label: usize) -> usize {
        let colors = self.task.set.colors();
        match self.task.set.kind() {
            Kind::Wang if label.is_multiple_of(2) => colors.horizontal(),
            Kind::Wang | Kind::Corner | Kind::Domino => colors.vertical(),
        }
    }

    /// The point of a label, and the color it has when the label has this one.
    fn tied(&self, label: usize, color: u8) -> (usize, u8) {
        let (point, steps) = self.ties[label];
        let map = &self.back[steps];
        let horizontal = self.task.set.kind() == Kind::Wang && label.is_multiple_of(2);
        let images = if horizontal { map.horizontal() } else { map.vertical() };
        (point, images[usize::from(color)])
    }

    /// All labels, from the colors of the points.
    pub fn labels(&self, colors: &[u8]) -> Vec<u8> {
        let label = |label: usize| {
            let (point, _) = self.ties[label];
            let shows = |&color: &u8| self.tied(label, color).1 == colors[point];
            (0..self.palette(label) as u8).find(shows).unwrap_or(0)
        };
        (0..self.ties.len()).map(label).collect()
    }

    /// Every option: a tile in a cell.
    pub fn options(&self) -> impl Iterator<Item = Placed> + use<> {
        let tiles = self.tiles.len();
        (0..self.cells.len())
            .flat_map(move |cell| (0..tiles).map(move |tile| Placed { cell, tile }))
    }

    /// The points that an option asks for, with their colors, each once, in the order of the
    /// sides; `None` when it asks for two colors of one point.
    pub fn asks(&self, option: Placed) -> Option<Vec<(usize, u8)>> {
        let set = &self.task.set;
        let sides = self.task.lattice().sides(self.cells[option.cell]);
        let shown = set.kind().unpack(self.tiles[option.tile], set.colors());
        let mut asked: Vec<(usize, u8)> = Vec::with_capacity(sides.len());
        for (label, color) in sides.into_iter().zip(shown) {
            let (point, color) = self.tied(label, color);
            match asked.iter().find(|known| known.0 == point) {
                Some(&(_, known)) if known != color => return None,
                Some(_) => {}
                None => asked.push((point, color)),
            }
        }
        Some(asked)
    }

    /// The tiles that show a tile somewhere when they lie in one of [`Instance::cells`], as
    /// positions: one for each cell of an orbit.
    pub fn sources(&self, tile: usize) -> Vec<usize> {
        let set = &self.task.set;
        let source = |map: &ColorMap| map.tile(set.kind(), set.colors(), self.tiles[tile]);
        // The set is kept, so none is missing.
        self.back.iter().filter_map(|map| self.tiles.binary_search(&source(map)).ok()).collect()
    }

    /// One tile of every orbit, as positions.
    pub fn tile_orbits(&self) -> Vec<usize> {
        let first = |&tile: &usize| self.sources(tile).into_iter().min() == Some(tile);
        (0..self.tiles.len()).filter(first).collect()
    }

    /// Of a compact set the classes of tiles with the same fixed sides, one of every orbit, each
    /// as positions of tiles.
    pub fn class_orbits(&self) -> Vec<Vec<usize>> {
        let mut classes: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for tile in 0..self.tiles.len() {
            classes.entry(self.class(tile)).or_default().push(tile);
        }
        let mut seen = BTreeSet::new();
        let mut first = Vec::new();
        for (class, tiles) in classes {
            if seen.insert(class) {
                seen.extend(self.sources(tiles[0]).into_iter().map(|source| self.class(source)));
                first.push(tiles);
            }
        }
        first
    }

    /// The fixed sides of a tile of a compact set: (NW, SW, SE), or (N, W).
    pub fn class(&self, tile: usize) -> u32 {
        let set = &self.task.set;
        let [a, b, c, d] = set.kind().unpack(self.tiles[tile], set.colors()).map(u32::from);
        match set.kind() {
            Kind::Corner => (b << 16) | (c << 8) | d,
            Kind::Wang | Kind::Domino => (a << 8) | d,
        }
    }
}
