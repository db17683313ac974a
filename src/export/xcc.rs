//! A task as exact cover with colors, in the input format of Knuth's programs DLX2 and DLX3.
//!
//! Items to cover are the cells and the tiles; points are secondary items, which all options
//! that name them must give the same color. An option is a tile in a cell. (D. E. Knuth, *The
//! Art of Computer Programming* 4B, 7.2.2.1.) With multiplicities (DLX3) coverings and compact
//! sets can be said, too: a tile of a covering may be covered again, and of a compact set the
//! classes are covered twice and a tile is secondary, so it lies at most once. That a *covering*
//! takes exactly two tiles of a class, each any number of times, cannot be said.

use super::instance::{ExportError, Instance};
use crate::packing::Task;
use crate::tiles::Kind;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// The characters for colors: DLX2 and DLX3 take one each.
const COLORS: &[u8; 64] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ+-";

/// The longest name of an item that the programs take.
const LONGEST: usize = 8;

/// A task as exact cover with colors.
#[derive(Debug)]
pub struct Xcc<'a> {
    instance: Instance<'a>,
    /// For every tile the name of its orbit, or `None` when it cannot lie anywhere.
    tiles: Vec<Option<String>>,
    /// For every tile of a compact set the name of its class.
    classes: Vec<String>,
    /// The names of the items to cover, with multiplicities.
    primary: Vec<String>,
    /// The names of the items that need not be covered.
    secondary: Vec<String>,
    /// The colors of the points given beforehand.
    pins: Vec<Option<u8>>,
    /// Whether only DLX3 understands it.
    pub multiplicities: bool,
    /// The number of options.
    pub options: u64,
}

impl<'a> Xcc<'a> {
    /// A task that has been checked, as exact cover.
    ///
    /// # Errors
    /// When it is too large, or the format cannot say it.
    pub fn new(task: &'a Task) -> Result<Self, ExportError> {
        let unsayable = |why: &str| Err(ExportError::Unsayable(why.to_owned()));
        let instance = Instance::new(task)?;
        let (compact, cover) = (task.set.is_compact(), task.cover);
        if compact && cover {
            return unsayable("a covering of a compact set takes two tiles of a class, each often");
        }
        let Ok(pins) = instance.pins() else {
            return unsayable("two pins disagree under the automorphism, so there is no packing");
        };
        let mut xcc = Self {
            tiles: vec![None; instance.tiles.len()],
            classes: vec![String::new(); instance.tiles.len()],
            primary: (0..instance.cells.len()).map(|cell| instance.name("c", cell)).collect(),
            secondary: (0..instance.points.len()).map(|point| instance.point_name(point)).collect(),
            pins,
            multiplicities: compact || cover,
            options: 0,
            instance,
        };
        xcc.name_tiles();
        if compact {
            xcc.name_classes()?;
        }
        let items = xcc.primary.iter().chain(&xcc.secondary);
        let bare = items.map(|item| item.split_once('|').map_or(item.as_str(), |(_, name)| name));
        if let Some(name) = bare.into_iter().find(|name| name.len() > LONGEST) {
            return unsayable(&format!("the name {name} has more than {LONGEST} characters"));
        }
        let mut options = 0;
        xcc.each(&mut |_| {
            options += 1;
            Ok(())
        })
        .unwrap_or_default();
        xcc.options = options;
        Ok(xcc)
    }

    /// The number of items that must be covered.
    pub fn primary(&self) -> usize {
        self.primary.len()
    }

    /// The number of items that need not be covered.
    pub fn secondary(&self) -> usize {
        self.secondary.len()
    }

    fn name_tiles(&mut self) {
        let (compact, cover) = (self.instance.task.set.is_compact(), self.instance.task.cover);
        for tile in self.instance.tile_orbits() {
            let name = format!("t{}", self.instance.tiles[tile].0);
            let sources = self.instance.sources(tile);
            // A tile that the automorphism leaves in place would lie twice.
            let twice = sources[1..].contains(&sources[0]);
            if compact && twice {
                continue;
            }
            let most = self.instance.cells.len();
            match (compact, cover) {
                (true, _) => self.secondary.push(name.clone()),
                (false, true) => self.primary.push(format!("1:{most}|{name}")),
                (false, false) => self.primary.push(name.clone()),
            }
            for source in sources {
                self.tiles[source] = Some(name.clone());
            }
        }
    }

    fn name_classes(&mut self) -> Result<(), ExportError> {
        let mut names: BTreeMap<u32, String> = BTreeMap::new();
        for class in self.instance.class_orbits() {
            let own = self.instance.class(class[0]);
            let images: Vec<u32> = {
                let sources = self.instance.sources(class[0]);
                sources.into_iter().map(|tile| self.instance.class(tile)).collect()
            };
            // How often a tile in one cell shows the class.
            let shown = images.iter().filter(|&&image| image == own).count();
            if shown > 2 {
                let why = "the automorphism shows a class more than twice, so there is no packing";
                return Err(ExportError::Unsayable(why.to_owned()));
            }
            let name = format!("k{}", names.len());
            let name_and_number = if shown == 2 { name.clone() } else { format!("2|{name}") };
            self.primary.push(name_and_number);
            for image in images {
                names.insert(image, name.clone());
            }
        }
        for tile in 0..self.classes.len() {
            if let Some(name) = names.get(&self.instance.class(tile)) {
                self.classes[tile].clone_from(name);
            }
        }
        Ok(())
    }

    /// Gives every option, as the items it covers, to `take`.
    fn each(&self, take: &mut dyn FnMut(&[String]) -> io::Result<()>) -> io::Result<()> {
        for placed in self.instance.options() {
            let Some(tile) = &self.tiles[placed.tile] else { continue };
            let Some(asked) = self.instance.asks(placed) else { continue };
            let fits = |&(point, color): &(usize, u8)| self.pins[point].is_none_or(|p| p == color);
            if !asked.iter().all(fits) {
                continue;
            }
            let mut items = vec![self.primary[placed.cell].clone(), tile.clone()];
            if self.instance.task.set.is_compact() {
                items.push(self.classes[placed.tile].clone());
            }
            for (point, color) in asked {
                let color = char::from(COLORS[usize::from(color) % COLORS.len()]);
                items.push(format!("{}:{color}", self.secondary[point]));
            }
            take(&items)?;
        }
        Ok(())
    }

    /// Writes the problem, `about` in a comment.
    ///
    /// # Errors
    /// What the output reports.
    pub fn write(&self, out: &mut dyn Write, about: &str) -> io::Result<()> {
        let points = match self.instance.task.set.kind() {
            Kind::Corner => "p12: the color of the north-west corner of cell 12",
            Kind::Wang => "n12, w12: the colors of the north and west side of cell 12",
            Kind::Domino => "p12: the color of the first end of domino 12",
        };
        let program = if self.multiplicities { "DLX3" } else { "DLX2" };
        writeln!(out, "| {about}")?;
        writeln!(out, "| for {program}; c12: cell 12, row by row; t5: tile 5; {points}")?;
        writeln!(out, "{} | {}", self.primary.join(" "), self.secondary.join(" "))?;
        self.each(&mut |items| writeln!(out, "{}", items.join(" ")))
    }
}

impl Instance<'_> {
    /// The name of a cell.
    fn name(&self, what: &str, cell: usize) -> String {
        format!("{what}{}", self.cells[cell].0)
    }

    fn point_name(&self, point: usize) -> String {
        let label = self.points[point].label;
        match (self.task.set.kind(), label % 2) {
            (Kind::Wang, 0) => format!("n{}", label / 2),
            (Kind::Wang, _) => format!("w{}", label / 2),
            _ => format!("p{label}"),
        }
    }
}
