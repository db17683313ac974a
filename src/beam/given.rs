//! Cells given beforehand, and the frame in which rows are scanned.
//!
//! A beam scans short rows, so a wide torus is first reflected through its SW-NE diagonal. Where
//! cells are given, the torus is also rotated in itself so that the scan begins at the north-west
//! of where they lie thickest: then the given cells come first in a row, and what is chosen after
//! them is chosen knowing them.
//!
//! Invariant: [`Frame::restore`] undoes [`Frame::given`]'s change of places.

use crate::torus::{Pins, Shape};

/// The colors of cells given beforehand, in the order of the scan; empty when there are none.
#[derive(Debug, Clone)]
pub(super) struct Given {
    width: usize,
    height: usize,
    colors: Vec<Option<u8>>,
}

impl Given {
    /// The color given to a cell; rows and columns wrap.
    #[inline(always)]
    pub(super) fn color(&self, row: usize, column: usize) -> Option<usize> {
        if self.colors.is_empty() {
            return None;
        }
        let (row, column) = (row % self.height, column % self.width);
        self.colors[row * self.width + column].map(usize::from)
    }

    /// Whether no cell is given.
    pub(super) fn is_empty(&self) -> bool {
        self.colors.is_empty()
    }

    /// Whether all these cells are given.
    #[inline(always)]
    pub(super) fn all(&self, cells: &[(usize, usize)]) -> bool {
        !self.colors.is_empty() && cells.iter().all(|&(r, c)| self.color(r, c).is_some())
    }
}

/// The cells of the window whose north-west is here.
#[inline(always)]
pub(super) fn around(row: usize, column: usize) -> [(usize, usize); 4] {
    [(row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1)]
}

/// A torus as it is scanned.
#[derive(Debug)]
pub(super) struct Frame {
    /// For every cell in the order of the scan its place in the torus.
    places: Vec<usize>,
    width: usize,
    height: usize,
    /// By place.
    pins: Vec<Option<u8>>,
}

impl Frame {
    /// For a torus, reflected or not; `None` when there are not as many pins as cells.
    pub(super) fn new(shape: Shape, turned: bool, pins: Option<&Pins>) -> Option<Self> {
        let (w, h) = (shape.width(), shape.height());
        let (width, height) = if turned { (h, w) } else { (w, h) };
        let place = |row: usize, column: usize| match turned {
            true => (h - 1 - column) * w + (w - 1 - row),
            false => row * w + column,
        };
        let pins = pins.filter(|pins| pins.pinned() > 0).map_or(&[][..], Pins::labels);
        if !pins.is_empty() && pins.len() != w * h {
            return None;
        }
        let count = |row: usize, column: usize| {
            pins.get(place(row, column)).is_some_and(Option::is_some) as usize
        };
        let rows: Vec<usize> =
            (0..height).map(|row| (0..width).map(|column| count(row, column)).sum()).collect();
        let columns: Vec<usize> =
            (0..width).map(|column| (0..height).map(|row| count(row, column)).sum()).collect();
        let (top, left) = (steepest(&rows), steepest(&columns));
        let places = (0..w * h)
            .map(|i| place((top + i / width) % height, (left + i % width) % width))
            .collect();
        Some(Self { places, width, height, pins: pins.to_vec() })
    }

    /// What is given, in the order of the scan.
    pub(super) fn given(&self) -> Given {
        let colors = match self.pins.is_empty() {
            true => Vec::new(),
            false => self.places.iter().map(|&place| self.pins[place]).collect(),
        };
        Given { width: self.width, height: self.height, colors }
    }

    /// The colors by place, from those in the order of the scan.
    pub(super) fn restore(&self, cells: &[u8]) -> Vec<u8> {
        let mut colors = vec![0; cells.len()];
        for (&place, &color) in self.places.iter().zip(cells) {
            colors[place] = color;
        }
        colors
    }
}

/// Where a line has most more pins than the line before it; the first such line.
fn steepest(lines: &[usize]) -> usize {
    let before = |at: usize| lines[(at + lines.len() - 1) % lines.len()];
    let rise = |at: &usize| lines[*at] as i64 - before(*at) as i64;
    (0..lines.len()).rev().max_by_key(rise).unwrap_or(0)
}
