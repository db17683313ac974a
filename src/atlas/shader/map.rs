//! The map of a coloring as a texture of whole numbers: what its shader reads besides the atlas.
//!
//! * a color map: the labels of its cells, rows from the north;
//! * blocks of four: the patterns, then where their classes begin, 256 in a row;
//! * permutations: each a row, its size first;
//! * probabilities: cells by rows from the north, in each a texel for every color: the threshold and
//!   the alias.

use crate::tiles::Kind;
use crate::tiling::{Coloring, Compact, PATTERNS, Tiling};

/// A texture of unsigned numbers of 32 bits.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MapTexture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Numbers of a texel: 1 or 2.
    pub channels: usize,
    /// The numbers, row by row from the first.
    pub data: Vec<u32>,
    /// What a texel is, for people.
    pub words: String,
}

/// The patterns, or beginnings, in a row.
const ROW: usize = 256;

impl MapTexture {
    /// The texture that the shader of a tiling needs; most need none.
    pub fn of(tiling: &Tiling) -> Option<Self> {
        match tiling.coloring() {
            Coloring::Map(map) => {
                let shape = map.shape();
                let (channels, words) = match tiling.kind() {
                    Kind::Corner => {
                        (1, "one unsigned number: the color of the north-west corner of a cell")
                    }
                    _ => (
                        2,
                        "two unsigned numbers: the colors of the north and the west edge of a cell",
                    ),
                };
                Some(Self {
                    width: shape.width(),
                    height: shape.height(),
                    channels,
                    data: map.labels().iter().copied().map(u32::from).collect(),
                    words: words.to_owned(),
                })
            }
            Coloring::Compact(Compact::Block4(_)) => {
                let patterns = PATTERNS.patterns.iter().copied().map(u32::from);
                let mut data: Vec<u32> = patterns.chain(PATTERNS.begins.iter().copied()).collect();
                data.resize(data.len().next_multiple_of(ROW), 0);
                let words = "one unsigned number, the same for every seed: the patterns of 4 x 4 \
                             tiles by classes, then where these begin";
                let height = data.len() / ROW;
                Some(Self { width: ROW, height, channels: 1, data, words: words.to_owned() })
            }
            Coloring::Permuted(hash) => {
                let longest = hash.tables().iter().map(Vec::len).max().unwrap_or(0);
                let rows = hash.tables().iter().map(|table| {
                    let mut row = vec![table.len() as u32];
                    row.extend(table.iter().copied().map(u32::from));
                    row.resize(longest + 1, 0);
                    row
                });
                let data = rows.flatten().collect();
                let words =
                    "one unsigned number: in every row the size of a table, then its entries";
                let (width, height) = (longest + 1, hash.tables().len());
                Some(Self { width, height, channels: 1, data, words: words.to_owned() })
            }
            Coloring::Probabilities(map) => {
                let columns = map.columns().iter();
                let words =
                    "two unsigned numbers of 32 bits: threshold and alias of a color in a cell";
                Some(Self {
                    width: map.shape().width() * map.colors(),
                    height: map.shape().height(),
                    channels: 2,
                    data: columns.flat_map(|c| [c.threshold, c.alias.into()]).collect(),
                    words: words.to_owned(),
                })
            }
            _ => None,
        }
    }
}
