//! Pictures of tiles that somebody made: a folder with a PNG for each tile, or a sheet.
//!
//! In a folder a file is named by the number of its tile, `12.png`, or by its colors in the
//! order of the digits of the number, `0-1-1-0.png`: NE, SE, SW, NW, or N, E, S, W.

use super::{AtlasError, Format, Image, Layout, TileImages, read_png};
use crate::tiles::{Colors, Kind, TileId};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// Bytes of a picture at most.
pub const PICTURE_LIMIT: u64 = 4 << 30;

/// A PNG from the disk.
///
/// # Errors
/// A file that cannot be read or is no PNG.
pub fn open_png(file: &Path) -> Result<Image, AtlasError> {
    let wrong = |message: String| AtlasError::File { file: file.into(), message };
    let input = File::open(file).map_err(|error| wrong(error.to_string()))?;
    read_png(BufReader::new(input), PICTURE_LIMIT)
        .map_err(|message| wrong(format!("expected a PNG: {message}")))
}

/// A folder with a picture for each tile.
#[derive(Debug)]
pub struct Folder {
    files: BTreeMap<TileId, PathBuf>,
    side: usize,
    format: Format,
}

impl Folder {
    /// The pictures for exactly these tiles, which are different. Every file is looked at.
    ///
    /// # Errors
    /// A missing tile, a file that belongs to none or is the second for one, pictures that are
    /// not square, or of different size or kind.
    pub fn open(
        folder: &Path,
        kind: Kind,
        colors: Colors,
        tiles: impl IntoIterator<Item = TileId>,
    ) -> Result<Self, AtlasError> {
        let wrong = |file: &Path, message: String| AtlasError::File { file: file.into(), message };
        let entries = fs::read_dir(folder).map_err(|error| wrong(folder, error.to_string()))?;
        let mut paths = Vec::new();
        for entry in entries {
            paths.push(entry.map_err(|error| wrong(folder, error.to_string()))?.path());
        }
        paths.sort();
        let mut files: BTreeMap<TileId, PathBuf> = BTreeMap::new();
        for path in paths {
            if path.extension().is_none_or(|end| !end.eq_ignore_ascii_case("png")) {
                continue;
            }
            let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
            let tile = named(stem, kind, colors).map_err(|message| wrong(&path, message))?;
            if let Some(other) = files.insert(tile, path.clone()) {
                let other = other.file_name().unwrap_or_default().display().to_string();
                return Err(wrong(
                    &path,
                    format!("is the second picture of tile {tile}, after {other}"),
                ));
            }
        }
        let mut wanted = BTreeMap::new();
        for tile in tiles {
            let Some(path) = files.remove(&tile) else {
                let sides = kind.describe(tile, colors);
                let message = format!("no picture of tile {tile} ({sides}): expected {tile}.png");
                return Err(wrong(folder, message));
            };
            wanted.insert(tile, path);
        }
        if let Some((tile, path)) = files.first_key_value() {
            return Err(wrong(path, format!("tile {tile} is not in the set")));
        }
        let mut first: Option<(PathBuf, Image)> = None;
        for path in wanted.values() {
            let image = open_png(path)?;
            let (width, height) = (image.width(), image.height());
            match &first {
                None if width != height => {
                    let message = format!("is {width} x {height} texels: expected a square");
                    return Err(wrong(path, message));
                }
                None => first = Some((path.clone(), image)),
                Some((other, known)) => {
                    let other = other.file_name().unwrap_or_default().display();
                    if (width, height) != (known.width(), known.height()) {
                        let side = known.width();
                        let message =
                            format!("is {width} x {height} texels, but {other} is {side} x {side}");
                        return Err(wrong(path, message));
                    }
                    if image.format() != known.format() {
                        let (is, was) = (in_words(image.format()), in_words(known.format()));
                        return Err(wrong(path, format!("has {is}, but {other} has {was}")));
                    }
                }
            }
        }
        let Some((_, image)) = first else {
            return Err(wrong(folder, "expected pictures of tiles".into()));
        };
        Ok(Self { files: wanted, side: image.width(), format: image.format() })
    }
}

/// The tile that a file is named after.
fn named(stem: &str, kind: Kind, colors: Colors) -> Result<TileId, String> {
    let expected = || {
        let order = kind.sides().join("-");
        format!("expected the number of a tile, or its colors {order}, as the name")
    };
    let numbers: Vec<u64> = stem
        .split('-')
        .map(|part| part.parse().map_err(|_| expected()))
        .collect::<Result<_, _>>()?;
    match numbers[..] {
        [number] => {
            let tiles = kind.tiles(colors);
            let tile = u32::try_from(number).ok().filter(|_| number < tiles);
            tile.map(TileId).ok_or_else(|| format!("tile {number} is none of 0 to {}", tiles - 1))
        }
        [_, _, _, _] => {
            let sides: Vec<u8> =
                numbers.iter().map(|&n| u8::try_from(n).unwrap_or(u8::MAX)).collect();
            kind.pack(&sides, colors).map_err(|error| error.to_string())
        }
        _ => Err(expected()),
    }
}

/// What the samples of a picture are.
pub(super) fn in_words(format: Format) -> String {
    let bits = 8 * format.sample_bytes();
    let channels = match format.channels.count() {
        1 => "gray",
        2 => "gray and alpha",
        3 => "RGB",
        _ => "RGBA",
    };
    format!("{channels} of {bits} bits")
}

impl TileImages for Folder {
    fn side(&self) -> usize {
        self.side
    }

    fn format(&self) -> Format {
        self.format
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let file = self.files.get(&tile).ok_or_else(|| missing(tile))?;
        let image = open_png(file)?;
        if image.width() != self.side
            || image.height() != self.side
            || image.format() != self.format
        {
            let message = "has changed while it was used".into();
            return Err(AtlasError::File { file: file.clone(), message });
        }
        Ok(image)
    }
}

fn missing(tile: TileId) -> AtlasError {
    AtlasError::Asked(format!("there is no picture of tile {tile}"))
}

/// A picture that shows every tile.
#[derive(Debug)]
pub struct Sheet {
    image: Image,
    layout: Layout,
}

impl Sheet {
    /// The tiles in a picture that is laid out like this.
    ///
    /// # Errors
    /// A picture of another size.
    pub fn new(image: Image, layout: Layout) -> Result<Self, AtlasError> {
        let (is, expected) = ((image.width(), image.height()), (layout.width(), layout.height()));
        if is != expected {
            let (columns, rows, block) = (layout.columns, layout.rows(), layout.block());
            return Err(AtlasError::Asked(format!(
                "the sheet is {} x {} texels: expected {} x {}, for {columns} x {rows} tiles of \
                 {block} texels",
                is.0, is.1, expected.0, expected.1
            )));
        }
        Ok(Self { image, layout })
    }

    /// The picture in a cell.
    pub fn cell(&self, cell: usize) -> Image {
        let (column, row) = self.layout.position(cell);
        let (block, gutter, side) = (self.layout.block(), self.layout.gutter, self.layout.side);
        self.image.part(column * block + gutter, row * block + gutter, side, side)
    }

    /// Where the tiles lie.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The whole picture.
    pub fn image(&self) -> &Image {
        &self.image
    }
}

impl TileImages for Sheet {
    fn side(&self) -> usize {
        self.layout.side
    }

    fn format(&self) -> Format {
        self.image.format()
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        self.layout.cell(tile).map(|cell| self.cell(cell)).ok_or_else(|| missing(tile))
    }
}
