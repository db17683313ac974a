//! A task in propositional logic, in the format of the SAT competitions (DIMACS CNF).
//!
//! Every point has a variable for each color, exactly one of which holds; then comes a variable
//! for each tile in each cell. A tile implies the colors it asks for, and a color of a side
//! implies one of the tiles that show it there: what follows from three known sides and the tiles
//! that are left is then found by unit propagation. Last stands how often each tile lies, by
//! counters ([`super::cardinality`]). Clauses are made twice, first to count them; none is kept.

use super::cardinality::Clauses;
use super::instance::{ExportError, Instance, Placed};
use crate::packing::Task;
use crate::tiles::Kind;
use std::io::{self, Write};

/// A task as clauses.
#[derive(Debug)]
pub struct Cnf<'a> {
    instance: Instance<'a>,
    /// For every point the variable of its color 0.
    first: Vec<i32>,
    /// The variable before those of the tiles.
    tiles_after: i32,
    /// The number of variables.
    pub variables: i32,
    /// The number of clauses.
    pub clauses: u64,
}

impl<'a> Cnf<'a> {
    /// A task that has been checked, as clauses.
    ///
    /// # Errors
    /// When it is too large.
    pub fn new(task: &'a Task) -> Result<Self, ExportError> {
        let instance = Instance::new(task)?;
        let mut variables = 0;
        let mut first = Vec::with_capacity(instance.points.len());
        for point in &instance.points {
            first.push(variables + 1);
            variables += point.colors as i32;
        }
        let mut cnf = Self { instance, first, tiles_after: variables, variables, clauses: 0 };
        let mut clauses = 0;
        cnf.variables = cnf.make(&mut |_| clauses += 1);
        cnf.clauses = clauses;
        Ok(cnf)
    }

    /// The cells, tiles and points.
    pub fn instance(&self) -> &Instance<'a> {
        &self.instance
    }

    /// The variable that says a point has a color.
    pub fn color(&self, point: usize, color: u8) -> i32 {
        self.first[point] + i32::from(color)
    }

    /// The variable that says a tile lies in a cell.
    pub fn tile(&self, placed: Placed) -> i32 {
        let number = placed.cell * self.instance.tiles.len() + placed.tile;
        self.tiles_after + 1 + number as i32
    }

    /// Gives every clause to `emit`; the number of variables.
    pub fn make(&self, emit: &mut dyn FnMut(&[i32])) -> i32 {
        let instance = &self.instance;
        let options = (instance.cells.len() * instance.tiles.len()) as i32;
        let mut clauses = Clauses { variables: self.tiles_after + options, emit };
        for (point, about) in instance.points.iter().enumerate() {
            let colors: Vec<i32> = (0..about.colors as u8).map(|c| self.color(point, c)).collect();
            clauses.exactly_one(&colors);
        }
        self.pins(&mut clauses);
        for cell in 0..instance.cells.len() {
            self.cell(cell, &mut clauses);
        }
        self.laws(&mut clauses);
        clauses.variables
    }

    fn pins(&self, clauses: &mut Clauses<'_>) {
        match self.instance.pins() {
            Ok(pins) => {
                for (point, color) in pins.into_iter().enumerate() {
                    if let Some(color) = color {
                        clauses.clause(&[self.color(point, color)]);
                    }
                }
            }
            // Two pins disagree, which the empty clause says.
            Err(_) => clauses.clause(&[]),
        }
    }

    /// Tiles and the colors around a cell imply each other.
    fn cell(&self, cell: usize, clauses: &mut Clauses<'_>) {
        let mut showing: Vec<(i32, Vec<i32>)> = Vec::new();
        let lattice = self.instance.task.lattice();
        for label in lattice.sides(self.instance.cells[cell]) {
            let point = self.instance.point(label);
            if showing.iter().any(|(color, _)| *color == self.color(point, 0)) {
                continue;
            }
            for color in 0..self.instance.points[point].colors as u8 {
                let color = self.color(point, color);
                showing.push((color, vec![-color]));
            }
        }
        for tile in 0..self.instance.tiles.len() {
            let placed = Placed { cell, tile };
            let variable = self.tile(placed);
            let Some(asked) = self.instance.asks(placed) else {
                clauses.clause(&[-variable]);
                continue;
            };
            for (point, color) in asked {
                let color = self.color(point, color);
                clauses.clause(&[-variable, color]);
                if let Some((_, shown)) = showing.iter_mut().find(|(known, _)| *known == color) {
                    shown.push(variable);
                }
            }
        }
        for (_, shown) in showing {
            clauses.clause(&shown);
        }
    }

    /// How often tiles lie.
    fn laws(&self, clauses: &mut Clauses<'_>) {
        let (instance, task) = (&self.instance, self.instance.task);
        let compact = task.set.is_compact();
        let mut used = vec![0; instance.tiles.len()];
        for tile in instance.tile_orbits() {
            let anywhere = self.anywhere(tile);
            match (compact, task.cover) {
                (false, false) => clauses.exactly_one(&anywhere),
                (false, true) => clauses.clause(&anywhere),
                (true, false) => clauses.at_most_one(&anywhere),
                (true, true) => {
                    // Whether the tile is one of the set that is covered.
                    let is_used = clauses.fresh();
                    for source in instance.sources(tile) {
                        used[source] = is_used;
                    }
                    for &lies in &anywhere {
                        clauses.clause(&[-lies, is_used]);
                    }
                    let mut some = anywhere;
                    some.push(-is_used);
                    clauses.clause(&some);
                }
            }
        }
        if !compact {
            return;
        }
        for class in instance.class_orbits() {
            let counted: Vec<i32> = match task.cover {
                true => class.iter().map(|&tile| used[tile]).collect(),
                false => class.iter().flat_map(|&tile| self.anywhere(tile)).collect(),
            };
            clauses.exactly_two(&counted);
        }
    }

    /// All options that put a tile anywhere on the torus.
    fn anywhere(&self, tile: usize) -> Vec<i32> {
        let sources = self.instance.sources(tile);
        let cells = 0..self.instance.cells.len();
        let lies = |cell| {
            let placed = move |&tile: &usize| self.tile(Placed { cell, tile });
            sources.iter().map(placed)
        };
        cells.flat_map(lies).collect()
    }

    /// Writes the clauses in the format DIMACS CNF, `about` in a comment.
    ///
    /// # Errors
    /// What the output reports.
    pub fn write(&self, out: &mut dyn Write, about: &str) -> io::Result<()> {
        self.write_comments(out, about)?;
        writeln!(out, "p cnf {} {}", self.variables, self.clauses)?;
        let mut written = Ok(());
        self.make(&mut |clause| {
            if written.is_ok() {
                written = write_clause(out, clause);
            }
        });
        written
    }

    fn write_comments(&self, out: &mut dyn Write, about: &str) -> io::Result<()> {
        let instance = &self.instance;
        let (first, last) = (self.tiles_after + 1, self.tiles_after as usize);
        let options = instance.cells.len() * instance.tiles.len();
        writeln!(out, "c {about}")?;
        writeln!(out, "c models are its answers, one for one")?;
        writeln!(out, "c 1 to {last}: colors, {}", what(instance.task.set.kind()))?;
        for (point, about) in instance.points.iter().enumerate() {
            let (row, column) = instance.position(about.label);
            let (low, high) = (self.color(point, 0), self.color(point, about.colors as u8 - 1));
            let side = match (instance.task.set.kind(), about.label % 2) {
                (Kind::Wang, 0) => "N of ",
                (Kind::Wang, _) => "W of ",
                _ => "",
            };
            writeln!(out, "c {low} to {high}: {side}row {row}, column {column}")?;
        }
        writeln!(
            out,
            "c {first} to {}: tile t in cell k is {first} + {} k + t, cells and tiles numbered from 0",
            last + options,
            instance.tiles.len()
        )?;
        let tiles: Vec<String> = instance.tiles.iter().map(|tile| tile.0.to_string()).collect();
        if tiles.iter().enumerate().any(|(i, tile)| *tile != i.to_string()) {
            writeln!(out, "c tiles t = 0, 1, ...: {}", tiles.join(" "))?;
        }
        writeln!(out, "c the rest: counters")
    }
}

fn what(kind: Kind) -> &'static str {
    match kind {
        Kind::Corner => "of the north-west corner of each cell",
        Kind::Wang => "of the north and west side of each cell",
        Kind::Domino => "of the first end of each domino",
    }
}

fn write_clause(out: &mut dyn Write, clause: &[i32]) -> io::Result<()> {
    for literal in clause {
        write!(out, "{literal} ")?;
    }
    writeln!(out, "0")
}
