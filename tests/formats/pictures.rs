//! Pictures: the SVG as another program renders it, and our own texels, show the colors of tiles
//! where they belong.

use crate::{complete, packing, text};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use tilepack::atlas::picture::{Scene, look, raster, sheets, svg};
use tilepack::atlas::{Image, demo};
use tilepack::tiles::{Kind, Members, TileId};
use tilepack::torus::Packing;

fn written(scene: &Scene, size: u32) -> String {
    text(|out| Ok(svg::write_svg(out, scene, size, "a <title>")?))
}

/// The picture as another program draws it.
fn rendered(scene: &Scene, size: u32) -> Pixmap {
    let svg = written(scene, size);
    assert!(!svg.contains("<text") && !svg.contains("font"));
    let round = |side: f32| side.round() as u32;
    let tree = Tree::from_str(&svg, &Options::default()).unwrap();
    let mut pixmap = Pixmap::new(round(tree.size().width()), round(tree.size().height())).unwrap();
    resvg::render(&tree, Transform::identity(), &mut pixmap.as_mut());
    pixmap
}

/// Where a tile shows nothing but the color of each side.
fn places(kind: Kind) -> [(f64, f64); 4] {
    match kind {
        // In the disc, off its number.
        Kind::Corner => [(0.72, 0.05), (0.72, 0.95), (0.28, 0.95), (0.28, 0.05)],
        _ => [(0.2, 0.08), (0.92, 0.2), (0.2, 0.92), (0.08, 0.2)],
    }
}

fn near(a: [u8; 3], b: [u8; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 2)
}

/// The tiles of a picture, the first at (x, y), are these.
fn shows(scene: &Scene, packing: &Packing, tiles: &[(TileId, f64, f64)]) {
    // Lines of more than a texel: the other program draws thinner ones its own way.
    const SIZE: u32 = 80;
    let (ours, theirs) = (raster::draw(scene, SIZE), rendered(scene, SIZE));
    let (width, height) = (ours.width(), ours.height());
    assert_eq!((theirs.width() as usize, theirs.height() as usize), (width, height));
    let of = |image: &Image, x: usize, y: usize| [0, 1, 2].map(|c| image.sample(x, y, c) as u8);
    let their = |x: usize, y: usize| {
        let texel = theirs.pixel(x as u32, y as u32).unwrap();
        [texel.red(), texel.green(), texel.blue()]
    };
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    for &(tile, x, y) in tiles {
        let sides = kind.unpack(tile, colors);
        for (side, (dx, dy)) in places(kind).into_iter().enumerate() {
            let at = |v: f64| (v * f64::from(SIZE)) as usize;
            let (x, y) = (at(x + dx), at(y + dy));
            let color = look(kind, colors, side, sides[side]);
            assert!(near(of(&ours, x, y), color), "tile {tile}, side {side}");
            assert!(near(their(x, y), color), "tile {tile}, side {side}, rendered");
        }
    }
    // Elsewhere both differ at outlines only, and there not by much.
    let mut sum = 0u64;
    let mut far = 0;
    for (x, y) in (0..width * height).map(|i| (i % width, i / width)) {
        let pairs = of(&ours, x, y).into_iter().zip(their(x, y));
        let apart = pairs.map(|(a, b)| u64::from(a.abs_diff(b))).max().unwrap();
        sum += apart;
        far += usize::from(apart > 64);
    }
    let texels = width * height;
    assert!(sum as f64 / (texels as f64) < 2.0, "{}", sum as f64 / texels as f64);
    assert!(far * 500 < texels, "{far} of {texels}");
}

fn some() -> [Packing; 3] {
    let compact = packing(Kind::Corner, "3", Members::Compact);
    [complete(Kind::Wang, "2,3"), complete(Kind::Corner, "2"), compact]
}

#[test]
fn the_preview_shows_the_packing() {
    for packing in some() {
        let w = packing.shape.width();
        let scene = sheets::preview(&packing, 48, true);
        let tiles = packing.tiles.iter().enumerate();
        let tiles = tiles.map(|(i, &tile)| (tile, (i % w + 1) as f64, (i / w + 1) as f64));
        shows(&scene, &packing, &tiles.collect::<Vec<_>>());
    }
}

#[test]
fn the_contact_sheet_shows_each_tile_once() {
    for packing in some() {
        let scene = sheets::contact_sheet(&packing, 48);
        let mut sorted = packing.tiles.clone();
        sorted.sort_unstable();
        // Distances as in the module.
        let columns = ((scene.width - 1.8) / 1.3).round() as usize + 1;
        let at = |i: usize| (0.4 + (i % columns) as f64 * 1.3, 0.4 + (i / columns) as f64 * 1.6);
        let tiles = sorted.iter().enumerate().map(|(i, &tile)| (tile, at(i).0, at(i).1));
        shows(&scene, &packing, &tiles.collect::<Vec<_>>());
    }
}

#[test]
fn the_demo_shows_the_tiling() {
    for packing in some() {
        let demo = demo::tiling(&packing, "9x5".parse().unwrap(), 3);
        let scene = sheets::tiling(&packing, &demo, 48, false);
        let tiles = demo.tiles.iter().enumerate();
        let tiles = tiles.map(|(i, &tile)| (tile, (i % 9) as f64, (i / 9) as f64));
        shows(&scene, &packing, &tiles.collect::<Vec<_>>());
    }
}

/// Opposite sides of the picture show the tiles beyond the seam, faded.
#[test]
fn around_the_preview_the_torus_goes_on() {
    let packing = complete(Kind::Corner, "3");
    let image = raster::draw(&sheets::preview(&packing, 16, false), 16);
    let texel = |x: usize, y: usize| [0, 1, 2].map(|c| i32::from(image.sample(x, y, c)));
    let side = 9 * 16;
    for y in 4..side {
        for x in 3..13 {
            let (ghost, real) = (texel(x, y + 18), texel(x + side, y + 18));
            if y + 18 > side + 12 {
                continue;
            }
            for (ghost, real) in ghost.into_iter().zip(real) {
                assert!(
                    (ghost - (255 * 65 + real * 35) / 100).abs() <= 2,
                    "{x} {y}: {ghost} {real}"
                );
            }
        }
    }
}

#[test]
fn large_pictures_stay_small() {
    let packing = complete(Kind::Corner, "8");
    assert_eq!(packing.tiles.len(), 4096);
    let svg = written(&sheets::preview(&packing, 64, false), 64);
    assert!(svg.len() < 1_500_000, "{}", svg.len());
    assert_eq!(svg, written(&sheets::preview(&packing, 64, false), 64));
    let numbered = sheets::preview(&complete(Kind::Corner, "4"), 64, false).shapes.len();
    let plain = sheets::preview(&complete(Kind::Corner, "4"), 16, false).shapes.len();
    assert!(plain < numbered);
    assert!(svg.contains("<title>a &lt;title&gt;</title>"));
}
