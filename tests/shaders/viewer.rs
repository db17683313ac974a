//! The viewer in a headless browser, driven by a script: it draws, packed equals assembled through
//! the exact levels and not beyond, hands and keys move it, and it names the tile under the cursor.
//!
//! The atlas is of noise: within a strip of every side a texel depends on the colors of that side
//! alone, and all else on the tile.

use crate::{constructed, tools};
use serde_json::{Value, json};
use std::fs;
use tilepack::atlas::Light;
use tilepack::atlas::viewer::{self, Scene};
use tilepack::tiles::{Colors, Kind, TileId, notation};
use tilepack::tiling::hash::{hash3, mix};
use tilepack::tiling::{Coloring, Tiling, mixed};
use tilepack::torus::Packing;

const SIDE: usize = 32;
const STRIP: usize = 4;

/// What the script finds out; it runs after the scripts of the page.
const DRIVER: &str = include_str!("viewer.js");

/// Red, green and blue of the texel of a corner tile.
fn noise(sides: [u8; 4], tile: TileId, x: usize, y: usize) -> [f64; 3] {
    let [ne, se, sw, nw] = sides.map(u32::from);
    let strip = |at: usize| match at {
        at if at < STRIP => Some(false),
        at if at >= SIDE - STRIP => Some(true),
        _ => None,
    };
    // A texel near a corner knows the corner's color, one near an edge those of both its ends.
    let knows = match (strip(x), strip(y)) {
        (Some(east), Some(south)) => match (east, south) {
            (false, false) => nw,
            (true, false) => ne,
            (false, true) => sw,
            (true, true) => se,
        },
        (Some(false), None) => 100 + 16 * nw + sw,
        (Some(true), None) => 100 + 16 * ne + se,
        (None, Some(false)) => 400 + 16 * nw + ne,
        (None, Some(true)) => 400 + 16 * sw + se,
        (None, None) => 10_000 + tile.0,
    };
    let at = (y * SIDE + x) as u32;
    let bits = hash3(5, knows, at);
    [0, 1, 2].map(|channel| f64::from(mix(bits + channel) >> 24) / 255.0)
}

/// The PNG files of all mip levels, each half of the one before: means of four in linear light.
fn atlas(packing: &Packing) -> Vec<Vec<u8>> {
    let colors = packing.set.colors();
    let (width, height) = (packing.shape.width() * SIDE, packing.shape.height() * SIDE);
    let mut level: Vec<[f64; 3]> = (0..width * height)
        .map(|at| {
            let (x, y) = (at % width, at / width);
            let tile = packing.tile(packing.shape.cell(y / SIDE, x / SIDE));
            let sides = packing.set.kind().unpack(tile, colors);
            noise(sides, tile, x % SIDE, y % SIDE)
        })
        .collect();
    let mut files = Vec::new();
    let (mut width, mut height) = (width, height);
    while width >= packing.shape.width() {
        files.push(png(&level, width, height));
        let half: Vec<[f64; 3]> = (0..width / 2 * (height / 2))
            .map(|at| {
                let from = at / (width / 2) * 2 * width + at % (width / 2) * 2;
                let four = [from, from + 1, from + width, from + width + 1];
                [0, 1, 2].map(|c| four.iter().map(|&at| level[at][c]).sum::<f64>() / 4.0)
            })
            .collect();
        (level, width, height) = (half, width / 2, height / 2);
    }
    files
}

fn png(level: &[[f64; 3]], width: usize, height: usize) -> Vec<u8> {
    let encode = |light: f64| match light {
        light if light <= 0.003_130_8 => 12.92 * light,
        light => 1.055 * light.powf(1.0 / 2.4) - 0.055,
    };
    let samples: Vec<u8> =
        level.iter().flatten().map(|&light| (encode(light) * 255.0).round() as u8).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().unwrap().write_image_data(&samples).unwrap();
    file
}

fn page(packing: &Packing, seed: u32) -> String {
    let mut page = Vec::new();
    let scene = Scene {
        packing,
        levels: atlas(packing),
        side: SIDE,
        strip: STRIP,
        exact_to_lod: Some(2),
        light: Light::Srgb,
        seed,
        title: "Noise & <tiles>".to_owned(),
    };
    viewer::write(&mut page, &scene).unwrap();
    String::from_utf8(page).unwrap()
}

/// What the script says about the page of a packing.
fn driven(packing: &Packing, seed: u32) -> Option<Value> {
    let page = page(packing, seed);
    let bare =
        page.lines().filter(|line| !line.contains("id=\"level-")).map(str::len).sum::<usize>();
    assert!(bare < 100_000, "{bare} bytes without the atlas");
    assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("{{"));
    // To be looked at: KEEP_VIEWER names a folder.
    if let Some(folder) = std::env::var_os("KEEP_VIEWER") {
        let name = format!("viewer-{}.html", packing.shape);
        fs::write(std::path::Path::new(&folder).join(name), &page).unwrap();
    }
    let chromium = tools::find("chromium")?;
    let early = "<script>window.failures = [];\
                 window.addEventListener('error', event => failures.push(event.message));\
                 console.error = console.warn = (...all) => failures.push(all.join(' '));</script>";
    let page = page.replacen("<head>", &format!("<head>{early}"), 1);
    let page = page.replace("</body>", &format!("<script>{DRIVER}</script></body>"));
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("viewer.html");
    fs::write(&file, page).unwrap();
    let answers = tools::browse(&chromium, &file);
    Some(serde_json::from_str(&answers).unwrap_or_else(|_| panic!("{answers}")))
}

fn largest(answers: &Value, name: &str) -> u64 {
    answers[name].as_u64().unwrap_or_else(|| panic!("{name} in {answers}"))
}

/// Tiles that the page names are those of Rust.
fn names_tiles(answers: &Value, tiling: &Tiling, packing: &Packing) {
    let tiles = answers["tiles"].as_array().unwrap();
    assert!(tiles.len() >= 5, "{answers}");
    for found in tiles {
        let (x, y) = (found["x"].as_i64().unwrap(), found["y"].as_i64().unwrap());
        let tile = tiling.tile(x, y);
        let cell = packing.tiles.iter().position(|&other| other == tile).unwrap();
        let (row, column) = (cell / packing.shape.width(), cell % packing.shape.width());
        let expected = json!({
            "x": x, "y": y, "tile": tile.0, "sides": tiling.sides(x, y), "row": row, "column": column,
        });
        assert_eq!(*found, expected);
    }
}

#[test]
fn the_viewer_of_a_complete_set() {
    let packing = constructed(Kind::Corner, "3");
    let Some(answers) = driven(&packing, 7) else { return };
    assert_eq!(answers["failures"], json!([]), "{answers}");
    // Exact through the LOD of the strip, wherever it is, and not beyond.
    for name in ["lod 0", "lod 0.5", "lod 1", "lod 1.5", "lod 2", "far", "magnified", "4 : 1"] {
        assert_eq!(largest(&answers, name), 0, "{name}: {answers}");
    }
    for name in ["lod 2.5", "lod 3", "lod 4", "16 : 1", "row-major"] {
        assert!(largest(&answers, name) > 2, "{name}: {answers}");
    }
    assert!(largest(&answers, "hardware") <= 6, "{answers}");
    let coloring = Coloring::Hash { seed: 7 };
    let tiling = Tiling::new(Kind::Corner, packing.set.colors(), coloring).unwrap();
    names_tiles(&answers, &tiling, &packing);
    for name in ["drag", "wheel", "pinch", "arrow", "plus", "view key", "bias key", "borders key"] {
        assert_eq!(answers[name], json!(true), "{name}: {answers}");
    }
    for name in ["help", "fold", "resize", "hover"] {
        assert_eq!(answers[name], json!(true), "{name}: {answers}");
    }
}

#[test]
fn the_viewer_of_a_compact_set() {
    // A packing of the 54 tiles, repeated and mixed: the tiling of a map.
    let text = fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/compact-corner-3.txt"));
    let input = tilepack::store::Input::from_bytes("compact", text.unwrap()).unwrap();
    let claim = tilepack::store::Claim {
        kind: Some(Kind::Corner),
        colors: Some(Colors::one(3).unwrap()),
        members: notation::parse_members("compact").unwrap(),
        ..Default::default()
    };
    let packing = tilepack::store::read_solution(&input, &claim).unwrap().packing;
    assert!(tilepack::verify::check(&packing).is_valid());
    let found = mixed(&packing, 7).unwrap();
    assert!(found.changed > 100, "{}", found.changed);
    let Some(answers) = driven(&packing, 7) else { return };
    assert_eq!(answers["failures"], json!([]), "{answers}");
    for name in ["lod 0", "lod 2", "far", "4 : 1"] {
        assert_eq!(largest(&answers, name), 0, "{name}: {answers}");
    }
    assert!(largest(&answers, "lod 3") > 2, "{answers}");
    let tiling = Tiling::new(Kind::Corner, packing.set.colors(), Coloring::Map(found.map));
    names_tiles(&answers, &tiling.unwrap(), &packing);
}
