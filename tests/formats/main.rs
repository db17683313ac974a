//! Packings in the formats of other programs: what these programs, or readers that others wrote,
//! find in them, and what must be refused.
//!
//! Where Tiled is not installed its tests say so and pass; under `CI` they fail.

#![allow(clippy::unwrap_used, clippy::panic)]

mod bad_input;
mod demos;
mod files;
mod pictures;
mod puzzles;
mod textures;
mod tiled_itself;
mod wangsets;

use std::path::PathBuf;
use std::process::Command;
use tempfile::TempDir;
use tilepack::atlas::{AtlasError, Format, Image, TileImages};
use tilepack::construct::registry::construct;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Packing, Shape};

/// A constructed packing.
fn packing(kind: Kind, colors: &str, members: Members) -> Packing {
    let set = TileSet::new(kind, colors.parse().unwrap(), members).unwrap();
    let shape = Shape::default_for(&set).unwrap();
    construct(&set, shape, None).unwrap().packing()
}

/// All tiles over some colors.
fn complete(kind: Kind, colors: &str) -> Packing {
    packing(kind, colors, Members::Complete)
}

/// The tiles of a set in a row: a list of tiles, no packing.
fn row(kind: Kind, colors: &str, members: Members) -> Packing {
    let colors: Colors = colors.parse().unwrap();
    let set = TileSet::new(kind, colors, members).unwrap();
    let tiles: Vec<TileId> = set.allowed().collect();
    let shape = Shape::new(tiles.len() as u64, 1).unwrap();
    Packing::new(set, shape, false, tiles)
}

/// Tiles of noise: each texel of each tile differs.
struct Noise(usize);

impl TileImages for Noise {
    fn side(&self) -> usize {
        self.0
    }

    fn format(&self) -> Format {
        Format::RGBA8
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let mut image = Image::new(self.0, self.0, Format::RGBA8);
        for (x, y) in (0..self.0 * self.0).map(|i| (i % self.0, i / self.0)) {
            let at = (tile.index() * self.0 + y) * self.0 + x;
            let word = (at as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
            let samples = [word as u8, (word >> 8) as u8, (word >> 16) as u8, 255];
            for (channel, sample) in samples.into_iter().enumerate() {
                image.set_sample(x, y, channel, sample.into());
            }
        }
        Ok(image)
    }
}

/// What a run of the program came to.
#[derive(Debug)]
struct Run {
    code: i32,
    stdout: String,
    stderr: String,
}

/// A folder in which the program runs.
struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    fn write(&self, file: &str, content: impl AsRef<[u8]>) -> &Self {
        std::fs::write(self.path(file), content).unwrap();
        self
    }

    fn read(&self, file: &str) -> String {
        std::fs::read_to_string(self.path(file)).unwrap()
    }

    /// Runs the program with arguments separated by blanks.
    fn run(&self, args: &str) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tilepack"));
        let output = command.args(args.split_whitespace()).current_dir(&self.0).output().unwrap();
        Run {
            code: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

/// What a writer writes, as text.
fn text(write: impl FnOnce(&mut dyn std::io::Write) -> Result<(), AtlasError>) -> String {
    let mut out = Vec::new();
    write(&mut out).unwrap();
    String::from_utf8(out).unwrap()
}
