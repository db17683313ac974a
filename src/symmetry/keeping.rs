//! The color permutations that, followed by an isometry, map a tile set to itself.
//!
//! Colors get their images one at a time, the two palettes in turn. As soon as all colors of a
//! tile have images, its image must be in the set; and the image of a color must occur as often
//! on every side as the color does on the side it comes from. A map that takes the set *into*
//! itself takes it *onto* itself, being one to one on tiles.
//!
//! Colors that no tile shows would give many maps that act alike; they keep their order among
//! themselves, which picks one of these maps and still leaves a group.

use super::{ColorMap, GroupError, Isometry};
use crate::tiles::{Colors, Kind, Members, TileSet};

/// The largest number of color permutations kept: those of nine colors.
pub const MAX_COLOR_MAPS: usize = 362_880;

/// Sets are not listed when there are more tiles than this over their colors (C = 45).
const MAX_TILES: u64 = 1 << 22;

/// Images of tiles beyond this number are not looked up: a few seconds of work.
const MAX_WORK: u64 = 1 << 26;

/// Color permutations such that recoloring and then moving by `isometry`, which must fit the
/// set, keeps the set; at most `limit` of them are asked for.
///
/// # Errors
/// When there are more than [`MAX_COLOR_MAPS`] or the work to find them grows too large.
pub(super) fn color_maps(
    set: &TileSet,
    isometry: Isometry,
    limit: usize,
) -> Result<Vec<ColorMap>, GroupError> {
    let colors = set.colors();
    let mut maps = Vec::new();
    let Some(mut finder) = Finder::new(set, isometry)? else { return Ok(maps) };
    finder.extend(0, &mut |images| {
        let (h, v) = (images[HORIZONTAL].clone(), images[VERTICAL].clone());
        let h = if set.kind() == Kind::Wang { h } else { v.clone() };
        maps.extend(ColorMap::new(colors, h, v));
        if maps.len() > MAX_COLOR_MAPS {
            return Err(GroupError::TooManyColorMaps { colors, max: MAX_COLOR_MAPS });
        }
        Ok(maps.len() < limit)
    })?;
    Ok(maps)
}

const HORIZONTAL: usize = 0;
/// The one palette of corner tiles and dominoes counts as the vertical one, as in [`ColorMap`].
const VERTICAL: usize = 1;

/// The palette of a side of a tile.
fn palette(kind: Kind, side: usize) -> usize {
    if kind == Kind::Wang { side % 2 } else { VERTICAL }
}

/// A color of a palette; the two palettes get their images independently.
#[derive(Clone, Copy)]
struct Variable {
    palette: usize,
    color: usize,
}

struct Finder<'a> {
    set: &'a TileSet,
    /// The colors to map, in the order they get their images.
    variables: Vec<Variable>,
    /// For every variable the tiles whose last color it is, as the colors of their sides.
    completed: Vec<Vec<[u8; 4]>>,
    /// For every side the side that it becomes.
    becomes: Vec<usize>,
    /// For every side and color the number of tiles.
    occurrences: Vec<Vec<u64>>,
    /// The images given so far, by palette; those of unused colors from the start.
    images: [Vec<u8>; 2],
    /// Which images are taken, by palette.
    taken: [Vec<bool>; 2],
    /// Images of tiles looked up so far.
    work: u64,
}

/// Takes the images of a whole map; says whether to go on.
type Found<'a> = dyn FnMut(&[Vec<u8>; 2]) -> Result<bool, GroupError> + 'a;

impl<'a> Finder<'a> {
    /// `None` when it is plain that there are no such maps.
    fn new(set: &'a TileSet, isometry: Isometry) -> Result<Option<Self>, GroupError> {
        let (kind, colors) = (set.kind(), set.colors());
        let sides = kind.sides().len();
        let becomes: Option<Vec<_>> = (0..sides).map(|side| isometry.side(kind, side)).collect();
        let Some(becomes) = becomes else { return Ok(None) };
        let counts = [colors.horizontal(), colors.vertical()];
        let mut finder = Self {
            set,
            variables: interleaved(kind, colors),
            completed: vec![Vec::new(); counts[0] + counts[1]],
            becomes,
            occurrences: kind.radices(colors).into_iter().map(|radix| vec![0; radix]).collect(),
            images: counts.map(|count| vec![0; count]),
            taken: counts.map(|count| vec![false; count]),
            work: 0,
        };
        let restricted = match set.members() {
            Members::Complete | Members::Compact => false,
            Members::Pruned(pairs) => !pairs.is_empty(),
            Members::Explicit(tiles) => (tiles.len() as u64) < kind.tiles(colors),
        };
        Ok((!restricted || finder.list_tiles()?).then_some(finder))
    }

    /// Lists the tiles by their last color; says whether there can be maps.
    fn list_tiles(&mut self) -> Result<bool, GroupError> {
        let (kind, colors) = (self.set.kind(), self.set.colors());
        let listed = match self.set.members() {
            Members::Explicit(tiles) => tiles.len() as u64,
            _ => kind.tiles(colors),
        };
        if listed > MAX_TILES {
            return Err(GroupError::TooMuchWork { colors });
        }
        let tiles: Vec<_> = self.set.allowed().map(|tile| kind.unpack(tile, colors)).collect();
        for sides in &tiles {
            for (counts, &color) in self.occurrences.iter_mut().zip(sides) {
                counts[usize::from(color)] += 1;
            }
        }
        if !self.settle_unused() {
            return Ok(false);
        }
        let mut position = [vec![0; colors.horizontal()], vec![0; colors.vertical()]];
        for (i, variable) in self.variables.iter().enumerate() {
            position[variable.palette][variable.color] = i;
        }
        for tile in tiles {
            let sides = tile.iter().enumerate().take(kind.sides().len());
            let last = sides.map(|(i, &color)| position[palette(kind, i)][usize::from(color)]);
            self.completed[last.max().unwrap_or(0)].push(tile);
        }
        Ok(true)
    }

    /// Maps the colors that no tile shows to those that no image shows, in order, and leaves
    /// only the others as variables; says whether their numbers agree.
    fn settle_unused(&mut self) -> bool {
        let kind = self.set.kind();
        for from in [HORIZONTAL, VERTICAL] {
            // The sides of a palette all become sides of one palette.
            let side = (0..self.becomes.len()).find(|&side| palette(kind, side) == from);
            let Some(side) = side else { continue };
            let to = palette(kind, self.becomes[side]);
            let (unused, unused_there) = (self.unused(from), self.unused(to));
            if unused.len() != unused_there.len() {
                return false;
            }
            for (&color, &image) in unused.iter().zip(&unused_there) {
                self.images[from][color] = image as u8;
                self.taken[from][image] = true;
            }
            self.variables.retain(|v| v.palette != from || !unused.contains(&v.color));
        }
        true
    }

    /// The colors of a palette that no tile shows.
    fn unused(&self, of: usize) -> Vec<usize> {
        let kind = self.set.kind();
        let shown = |color: usize| {
            let mut sides = self.occurrences.iter().enumerate();
            sides.any(|(side, counts)| palette(kind, side) == of && counts[color] > 0)
        };
        (0..self.images[of].len()).filter(|&color| !shown(color)).collect()
    }

    /// Gives images to the variables from number `depth` on; says whether to go on.
    fn extend(&mut self, depth: usize, found: &mut Found<'_>) -> Result<bool, GroupError> {
        let Some(&variable) = self.variables.get(depth) else { return found(&self.images) };
        for image in 0..self.images[variable.palette].len() {
            if self.taken[variable.palette][image] || !self.occurs_alike(variable, image) {
                continue;
            }
            self.images[variable.palette][variable.color] = image as u8;
            self.taken[variable.palette][image] = true;
            let go_on = !self.keeps(depth)? || self.extend(depth + 1, found)?;
            self.taken[variable.palette][image] = false;
            if !go_on {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether `image` is on every side as often as the variable is on the side it comes from.
    fn occurs_alike(&self, variable: Variable, image: usize) -> bool {
        let kind = self.set.kind();
        self.becomes.iter().enumerate().all(|(side, &becomes)| {
            palette(kind, side) != variable.palette
                || self.occurrences[side].get(variable.color)
                    == self.occurrences[becomes].get(image)
        })
    }

    /// Whether the tiles whose last color just got its image stay in the set.
    fn keeps(&mut self, depth: usize) -> Result<bool, GroupError> {
        let (kind, colors) = (self.set.kind(), self.set.colors());
        for tile in &self.completed[depth] {
            self.work += 1;
            if self.work > MAX_WORK {
                return Err(GroupError::TooMuchWork { colors });
            }
            let mut image = [0; 4];
            for (side, &becomes) in self.becomes.iter().enumerate() {
                image[becomes] = self.images[palette(kind, side)][usize::from(tile[side])];
            }
            let image = kind.pack(&image[..self.becomes.len()], colors);
            if !image.is_ok_and(|image| self.set.allows(image)) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// All colors, the palettes in turn: a Wang tile is then complete early.
fn interleaved(kind: Kind, colors: Colors) -> Vec<Variable> {
    let variable = |palette, color| Variable { palette, color };
    (0..colors.largest())
        .flat_map(|color| [variable(HORIZONTAL, color), variable(VERTICAL, color)])
        .filter(|v| match v.palette {
            HORIZONTAL => kind == Kind::Wang && v.color < colors.horizontal(),
            _ => v.color < colors.vertical(),
        })
        .collect()
}
