//! The guarantee: within the strip nothing shows but what the colors of a side say. Checked texel
//! by texel, by code that knows nothing of how the tiles were made.

use crate::{GRAY, RGB, noise};
use std::collections::HashMap;
use tilepack::atlas::{Channels, Depth, Format, Image, Light};
use tilepack::search::Stop;
use tilepack::texture::{Made, Method, Order, Shape, Stock, TextureError, make};
use tilepack::tiles::{Colors, Kind, TileId};

fn all(kind: Kind, colors: Colors) -> Vec<TileId> {
    (0..kind.tiles(colors)).map(|tile| TileId(tile as u32)).collect()
}

fn order(kind: Kind, colors: &str, method: Method, side: usize, strip: usize) -> Order {
    let shape = Shape { moves: 200, ..Shape::new(side, strip).unwrap() };
    let colors = colors.parse().unwrap();
    Order { kind, colors, shape, method, seed: 5, candidates: 3, tries: 2 }
}

fn made(stock: &Stock, order: Order) -> Made {
    make(stock, &all(order.kind, order.colors), order, (&(), &()), &|_| {}).unwrap()
}

/// What a texel may depend on: within the strip the colors of the side (of both, or the corner's,
/// where two strips cross), else the tile.
fn keeps_the_strip(made: &Made, images: &HashMap<TileId, Image>) {
    let Order { kind, colors, shape, .. } = made.order;
    let (side, strip) = (shape.side, shape.strip);
    let mut known: HashMap<(usize, usize, Vec<u8>), Vec<u16>> = HashMap::new();
    for (&tile, image) in images {
        let s = kind.unpack(tile, colors);
        for y in 0..side {
            for x in 0..side {
                let (west, east) = (x < strip, x >= side - strip);
                let (north, south) = (y < strip, y >= side - strip);
                let key = match kind {
                    // NE, SE, SW, NW.
                    Kind::Corner => match (north, east, south, west) {
                        (true, true, ..) => vec![s[0]],
                        (_, true, true, _) => vec![s[1]],
                        (_, _, true, true) => vec![s[2]],
                        (true, _, _, true) => vec![s[3]],
                        (true, ..) => vec![s[3], s[0]],
                        (_, true, ..) => vec![s[0], s[1]],
                        (_, _, true, _) => vec![s[2], s[1]],
                        (.., true) => vec![s[3], s[2]],
                        _ => continue,
                    },
                    // N, E, S, W; nothing in the corners.
                    _ => match (north || south, east || west) {
                        (true, true) => vec![],
                        (true, false) => vec![if north { s[0] } else { s[2] }],
                        (false, true) => vec![if east { s[1] } else { s[3] }],
                        _ => continue,
                    },
                };
                let count = image.format().channels.count();
                let samples: Vec<u16> = (0..count).map(|c| image.sample(x, y, c)).collect();
                let first = known.entry((x, y, key)).or_insert_with(|| samples.clone());
                assert_eq!(*first, samples, "tile {tile}, column {x}, row {y}");
            }
        }
    }
}

fn drawn(made: &Made, stock: &Stock, map: usize) -> HashMap<TileId, Image> {
    made.tiles.iter().map(|(&tile, quilt)| (tile, quilt.draw(stock, map))).collect()
}

#[test]
fn tiles_keep_the_strip_whatever_the_method() {
    let fine = Format { channels: Channels::Gray, depth: Depth::Sixteen, light: Light::Linear };
    let deep = Format { depth: Depth::Sixteen, ..RGB };
    for (kind, colors, method, side, strip, format) in [
        (Kind::Corner, "2", Method::Ng, 32, 4, RGB),
        (Kind::Corner, "3", Method::Ng, 24, 6, fine),
        (Kind::Corner, "2", Method::Schlomer, 32, 3, GRAY),
        (Kind::Corner, "2", Method::Ng, 8, 2, GRAY),
        (Kind::Wang, "2", Method::Cohen, 32, 4, deep),
        (Kind::Wang, "3,2", Method::Cohen, 20, 5, GRAY),
        (Kind::Wang, "2,3", Method::Ng, 24, 2, RGB),
        (Kind::Wang, "2", Method::Schlomer, 8, 1, GRAY),
    ] {
        let stock = Stock::new(vec![vec![noise(64, 56, format, 3)]], None).unwrap();
        let order = order(kind, colors, method, side, strip);
        let made = made(&stock, order);
        let images = drawn(&made, &stock, 0);
        keeps_the_strip(&made, &images);
        assert!(images.values().all(|image| image.format() == format));
        // Tiles differ where they may.
        let different: std::collections::HashSet<&[u8]> =
            images.values().map(|image| image.data()).collect();
        assert!(different.len() > images.len() / 2, "{} {method:?}", different.len());
    }
}

#[test]
fn maps_are_cut_like_their_picture() {
    let color = noise(64, 64, RGB, 1);
    let heights = Format { channels: Channels::Gray, depth: Depth::Sixteen, light: Light::Linear };
    // A map that says where each texel comes from.
    let mut place = Image::new(64, 64, heights);
    for at in 0..64 * 64 {
        place.set_sample(at % 64, at / 64, 0, at as u16);
    }
    let stock = Stock::new(vec![vec![color.clone(), place]], None).unwrap();
    let made = made(&stock, order(Kind::Corner, "2", Method::Ng, 32, 4));
    let (colors, places) = (drawn(&made, &stock, 0), drawn(&made, &stock, 1));
    keeps_the_strip(&made, &places);
    for (tile, image) in &colors {
        for at in 0..32 * 32 {
            let (x, y) = (at % 32, at / 32);
            let from = usize::from(places[tile].sample(x, y, 0));
            for channel in 0..3 {
                let sample = color.sample(from % 64, from / 64, channel);
                assert_eq!(image.sample(x, y, channel), sample);
            }
        }
    }
}

#[test]
fn several_examples_are_all_used() {
    let images = (0..3).map(|seed| vec![noise(60, 50 + seed, GRAY, seed as u64)]).collect();
    let stock = Stock::new(images, None).unwrap();
    for method in [Method::Schlomer, Method::Ng] {
        let made = made(&stock, order(Kind::Corner, "3", method, 24, 3));
        keeps_the_strip(&made, &drawn(&made, &stock, 0));
        for (&tile, quilt) in &made.tiles {
            // The corner shows the example of its color.
            let nw = made.order.kind.unpack(tile, made.order.colors)[3];
            assert_eq!(stock.locate(quilt.at(0, 0)).0, usize::from(nw));
        }
        // A tile of one color shows one example.
        let one = &made.tiles[&TileId(0)];
        assert!(one.texels.iter().all(|&texel| stock.locate(texel).0 == 0));
    }
}

#[test]
fn threads_do_not_matter_and_seeds_do() {
    let stock = Stock::new(vec![vec![noise(64, 64, GRAY, 9)]], None).unwrap();
    let order = order(Kind::Corner, "2", Method::Ng, 32, 4);
    let with = |threads: usize, order: Order| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| made(&stock, order))
    };
    let first = with(1, order);
    assert_eq!(first.tiles, with(3, order).tiles);
    assert_eq!(first.candidates.len(), 3);
    assert_eq!(first.candidates[first.taken], *first.candidates.iter().min().unwrap());
    assert_ne!(first.tiles, with(2, Order { seed: 6, ..order }).tiles);
}

/// Asks to stop at once.
struct Now;

impl Stop for Now {
    fn should_stop(&self) -> bool {
        true
    }
}

#[test]
fn a_limit_ends_the_trying_and_a_signal_all() {
    let stock = Stock::new(vec![vec![noise(64, 64, GRAY, 9)]], None).unwrap();
    let order = order(Kind::Corner, "2", Method::Ng, 32, 4);
    let tiles = all(order.kind, order.colors);
    let short = make(&stock, &tiles, order, (&Now, &()), &|_| {}).unwrap();
    assert!(short.cut_short && short.candidates.len() == 1 && short.tiles.len() == 16);
    keeps_the_strip(&short, &drawn(&short, &stock, 0));
    let stopped = make(&stock, &tiles, order, (&(), &Now), &|_| {});
    assert!(matches!(stopped, Err(TextureError::Stopped)));
}
