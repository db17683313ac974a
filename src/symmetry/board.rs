//! The symmetries of boards, and one canonical picture of each orbit.
//!
//! A symmetry recolors, rotates or reflects the board, and translates it along the seams that
//! are closed. It must keep the tiles: of fixed tiles as on a torus ([`Group`]); of squares that
//! may be turned, one permutation of all colors must keep the number of squares of every class.
//! And it must keep the border. A reflection turns a square over: it counts only where the
//! squares turned over are those of the set again, as MacMahon's are.
//!
//! The group is written out, as what arrives at every place, and a picture is canonical when no
//! image of it is less. The elements that leave it as it is make its orbit smaller (orbit and
//! stabilizer), so all orbits add up to the number of pictures.

use super::{Group, GroupError, Isometry, PointSymmetry};
use crate::tiles::{Kind, Members, TileId, TileSet, turn};
use crate::torus::{Board, Cell, Edges, Shape};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Places of all elements written out, at most.
const MOST: usize = 1 << 27;

/// Tells canonical pictures of a board from the other members of their orbits.
#[derive(Debug, Clone)]
pub struct BoardCanonizer {
    /// By element, which places its labels come from and how they are recolored.
    elements: Vec<(usize, usize)>,
    /// By movement: for every place of the image the place its label comes from.
    sources: Vec<Vec<u32>>,
    /// By recoloring: the permutations of labels on horizontal and on vertical edges.
    recolorings: Vec<[Vec<u8>; 2]>,
    /// By place: 0 on a horizontal edge, 1 on a vertical one.
    palette: Vec<u8>,
}

impl BoardCanonizer {
    /// For the packings of a set on a board.
    ///
    /// # Errors
    /// When there are too many symmetries to try, or finding them takes too long.
    pub fn new(set: &TileSet, shape: Shape, board: &Board) -> Result<Self, GroupError> {
        let edges = Edges { shape, topology: board.topology };
        let mut palette = vec![0; edges.labels()];
        for cell in (0..shape.cells() as u32).map(Cell) {
            let [_, east, _, west] = edges.sides(cell);
            (palette[east], palette[west]) = (1, 1);
        }
        let given = edges.given(&board.border);
        let mut canonizer =
            Self { elements: Vec::new(), sources: Vec::new(), recolorings: Vec::new(), palette };
        let down = if board.topology.is_outer(0) { 1 } else { shape.height() };
        let across = if board.topology.is_outer(1) { 1 } else { shape.width() };
        for point in points(set, shape, board)? {
            let recoloring = canonizer.recolorings.len();
            let (h, v) = (point.map.horizontal().to_vec(), point.map.vertical().to_vec());
            canonizer.recolorings.push([h, v]);
            for (rows, columns) in (0..down).flat_map(|r| (0..across).map(move |c| (r, c))) {
                let sources = sources(edges, point.isometry, (rows as i64, columns as i64));
                let keeps = sources.iter().enumerate().all(|(place, &source)| {
                    let color = |color: u8| canonizer.recolored(recoloring, source, color);
                    given[place] == given[source as usize].map(color)
                });
                if keeps {
                    canonizer.elements.push((canonizer.sources.len(), recoloring));
                    canonizer.sources.push(sources);
                }
                if canonizer.sources.len() * edges.labels() > MOST {
                    return Err(GroupError::TooMuchWork { colors: set.colors() });
                }
            }
        }
        Ok(canonizer)
    }

    /// The number of symmetries.
    pub fn order(&self) -> usize {
        self.elements.len()
    }

    /// The size of the orbit when the picture is canonical, else `None`.
    pub fn classify(&self, labels: &[u8]) -> Option<u64> {
        let mut stabilizer = 0;
        for &element in &self.elements {
            match self.image(element, labels).cmp(labels.iter().copied()) {
                Ordering::Less => return None,
                Ordering::Equal => stabilizer += 1,
                Ordering::Greater => {}
            }
        }
        (self.elements.len() as u64).checked_div(stabilizer)
    }

    /// All images of a picture, one for every symmetry.
    pub fn images<'a>(&'a self, labels: &'a [u8]) -> impl Iterator<Item = Vec<u8>> + 'a {
        self.elements.iter().map(|&element| self.image(element, labels).collect())
    }

    fn image<'a>(
        &'a self,
        (moves, recoloring): (usize, usize),
        labels: &'a [u8],
    ) -> impl Iterator<Item = u8> + 'a {
        let sources = self.sources[moves].iter();
        sources.map(move |&from| self.recolored(recoloring, from, labels[from as usize]))
    }

    /// What becomes of a color at the place it comes from.
    fn recolored(&self, recoloring: usize, from: u32, color: u8) -> u8 {
        let palette = usize::from(self.palette[from as usize]);
        self.recolorings[recoloring][palette][usize::from(color)]
    }
}

/// For every place of the image the place its label comes from: the board is turned or turned
/// over, then translated.
fn sources(edges: Edges, isometry: Isometry, (rows, columns): (i64, i64)) -> Vec<u32> {
    let shape = edges.shape;
    // Which side the north and the west side become says all.
    let becomes = |side: usize| isometry.side(Kind::Wang, side).unwrap_or(side);
    let reverses_columns = [becomes(0), becomes(3)].contains(&1);
    let reverses_rows = [becomes(0), becomes(3)].contains(&2);
    let mut sources = vec![0; edges.labels()];
    for cell in (0..shape.cells() as u32).map(Cell) {
        let (mut row, mut column) = shape.position(cell);
        if isometry.transposes() {
            (row, column) = (column, row);
        }
        if reverses_rows {
            row = shape.height() - 1 - row;
        }
        if reverses_columns {
            column = shape.width() - 1 - column;
        }
        let image = edges.sides(shape.step(shape.cell(row, column), rows, columns));
        for (side, place) in edges.sides(cell).into_iter().enumerate() {
            sources[image[becomes(side)]] = place as u32;
        }
    }
    sources
}

/// Recolorings with rotations and reflections that keep the tiles and the shape.
fn points(set: &TileSet, shape: Shape, board: &Board) -> Result<Vec<PointSymmetry>, GroupError> {
    // Sides that meet become sides that meet.
    let suits = |point: &PointSymmetry| {
        let becomes = point.isometry.side(Kind::Wang, 0).unwrap_or(0);
        board.topology.is_outer(0) == board.topology.is_outer(becomes)
    };
    if !board.rotations {
        return Ok(Group::of(set, shape, None)?.points().filter(suits).collect());
    }
    let colors = set.colors();
    // A task with two palettes has been refused.
    let shown = |tile| turn::turns(tile, colors).unwrap_or([tile; 4]);
    let class = |tile: TileId| shown(tile).into_iter().min();
    let mut squares = BTreeMap::new();
    set.allowed().for_each(|tile| *squares.entry(class(tile)).or_insert(0) += 1);
    let mut tiles: Vec<TileId> = set.allowed().flat_map(shown).collect();
    tiles.sort_unstable();
    tiles.dedup();
    let Ok(all) = TileSet::new(Kind::Wang, colors, Members::Explicit(tiles)) else {
        return Ok(vec![PointSymmetry::identity(colors)]);
    };
    let keeps = |point: &PointSymmetry| {
        point.map.horizontal() == point.map.vertical()
            && set.allowed().all(|tile| {
                let image = point.tile(Kind::Wang, colors, tile);
                image.is_some_and(|image| squares.get(&class(image)) == squares.get(&class(tile)))
            })
    };
    Ok(Group::of(&all, shape, None)?.points().filter(suits).filter(keeps).collect())
}
