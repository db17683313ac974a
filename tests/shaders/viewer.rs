//! The viewer in a headless browser, driven by a script: it draws, packed equals assembled through
//! the exact levels and not beyond, hands and keys move it, it names the tile under the cursor and
//! counts its copies as the library does, for every tiling of the page.
//!
//! The atlas is of noise: within a strip of every side a texel depends on the colors of that side
//! alone, and all else on the tile.

use crate::{constructed, tools};
use serde_json::{Value, json};
use std::fs;
use tilepack::atlas::viewer::{self, Scene};
use tilepack::atlas::{Arrangement, Layout, Light};
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet, notation};
use tilepack::tiling::hash::{hash3, mix};
use tilepack::tiling::{
    Coloring, Compact, Halton, Probabilities, Sums, Tiling, alternating, mixed,
};
use tilepack::torus::{Packing, Shape};

const SIDE: usize = 32;
const STRIP: usize = 4;

/// What the script finds out; it runs after the scripts of the page.
const DRIVER: &str = include_str!("viewer.js");

/// Red, green and blue of the texel of a tile.
fn noise(kind: Kind, sides: [u8; 4], tile: TileId, x: usize, y: usize) -> [f64; 3] {
    let strip = |at: usize| match at {
        at if at < STRIP => Some(false),
        at if at >= SIDE - STRIP => Some(true),
        _ => None,
    };
    let [a, b, c, d] = sides.map(u32::from);
    // A texel near a corner knows the corner's color, one near an edge those of both its ends; of
    // Wang tiles the edge has a color, and the corner nothing.
    let (ends, edges) = match kind {
        Kind::Corner => ([a, b, c, d], [16 * d + a, 16 * a + b, 16 * c + b, 16 * d + c]),
        _ => ([0; 4], [a, b, c, d]),
    };
    let ([ne, se, sw, nw], [north, east, south, west]) = (ends, edges);
    let knows = match (strip(x), strip(y)) {
        (Some(false), Some(false)) => nw,
        (Some(true), Some(false)) => ne,
        (Some(false), Some(true)) => sw,
        (Some(true), Some(true)) => se,
        (Some(false), None) => 100 + west,
        (Some(true), None) => 100 + east,
        (None, Some(false)) => 400 + north,
        (None, Some(true)) => 400 + south,
        (None, None) => 10_000 + tile.0,
    };
    let at = (y * SIDE + x) as u32;
    let bits = hash3(5, knows, at);
    [0, 1, 2].map(|channel| f64::from(mix(bits + channel) >> 24) / 255.0)
}

/// The PNG files of all mip levels, each half of the one before: means of four in linear light.
/// Gutters show the neighbors in the packing.
fn atlas(packing: &Packing, layout: &Layout) -> Vec<Vec<u8>> {
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let (mut width, mut height) = (layout.width(), layout.height());
    let (block, gutter) = (layout.block(), layout.gutter as i64);
    let side = SIDE as i64;
    let mut level: Vec<[f64; 3]> = (0..width * height)
        .map(|at| {
            let (x, y) = (at % width, at / width);
            let tile = layout.tiles[y / block * layout.columns + x / block];
            let (x, y) = ((x % block) as i64 - gutter, (y % block) as i64 - gutter);
            let at = packing.tiles.iter().position(|&other| other == tile).unwrap();
            let at = tilepack::torus::Cell(at as u32);
            let tile = packing.tile(packing.shape.step(at, y.div_euclid(side), x.div_euclid(side)));
            let (x, y) = (x.rem_euclid(side) as usize, y.rem_euclid(side) as usize);
            noise(kind, kind.unpack(tile, colors), tile, x, y)
        })
        .collect();
    let mut files = Vec::new();
    for _ in 0..layout.levels() {
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

fn page(packing: &Packing, layout: &Layout, seed: u32) -> String {
    let mut page = Vec::new();
    let scene = Scene {
        packing,
        layout,
        levels: atlas(packing, layout),
        strip: STRIP,
        exact_to_lod: Some(2),
        light: Light::Srgb,
        seed,
        title: "Noise & <tiles>".to_owned(),
    };
    viewer::write(&mut page, &scene).unwrap();
    String::from_utf8(page).unwrap()
}

/// What the script says about the page of a packing; all its figures only where it is thorough.
fn driven(packing: &Packing, layout: &Layout, seed: u32, thorough: bool) -> Option<Value> {
    let page = page(packing, layout, seed);
    let bare =
        page.lines().filter(|line| !line.contains("id=\"level-")).map(str::len).sum::<usize>();
    assert!(bare < 110_000, "{bare} bytes without the atlas");
    assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("{{"));
    // To be looked at: KEEP_VIEWER names a folder.
    if let Some(folder) = std::env::var_os("KEEP_VIEWER") {
        let (kind, shape) = (packing.set.kind(), packing.shape);
        let name = format!("viewer-{kind}-{shape}-{}.html", layout.gutter);
        fs::write(std::path::Path::new(&folder).join(name), &page).unwrap();
    }
    let chromium = tools::find("chromium")?;
    let early = "<script>window.failures = [];\
                 window.addEventListener('error', event => failures.push(event.message));\
                 console.error = console.warn = (...all) => failures.push(all.join(' '));</script>";
    let page = page.replacen("<head>", &format!("<head>{early}"), 1);
    let driver = format!("<script>const thorough = {thorough};{DRIVER}</script></body>");
    let page = page.replace("</body>", &driver);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("viewer.html");
    fs::write(&file, page).unwrap();
    let answers = tools::browse(&chromium, &file);
    let answers: Value = serde_json::from_str(&answers).unwrap_or_else(|_| panic!("{answers}"));
    assert_eq!(answers["failures"], json!([]), "{answers}");
    Some(answers)
}

fn largest(answers: &Value, name: &str) -> u64 {
    answers[name].as_u64().unwrap_or_else(|| panic!("{name} in {answers}"))
}

#[track_caller]
fn all_true(answers: &Value, names: &[&str]) {
    for name in names {
        assert_eq!(answers[name], json!(true), "{name}: {answers}");
    }
}

/// What the page says of its tilings is what the library has there: tiles near and far, the copies
/// of a tile in a window, the same in the picture. `coloring` gives the rule for a name and a seed.
fn tilings_are_those(
    answers: &Value,
    packing: &Packing,
    layout: &Layout,
    names: &[&str],
    coloring: impl Fn(&str, u32) -> Coloring,
) {
    let found = answers["tilings"].as_array().unwrap();
    let mut listed: Vec<&str> = found.iter().map(|one| one["name"].as_str().unwrap()).collect();
    listed.dedup();
    assert_eq!(listed, names);
    for one in found {
        let (name, seed) = (one["name"].as_str().unwrap(), one["seed"].as_u64().unwrap());
        let rule = coloring(name, seed as u32);
        let tiling = Tiling::new(packing.set.kind(), packing.set.colors(), rule).unwrap();
        let tiles = one["tiles"].as_array().unwrap();
        assert!(tiles.len() >= 7, "{one}");
        for told in tiles {
            let (x, y) = (told["x"].as_i64().unwrap(), told["y"].as_i64().unwrap());
            let tile = tiling.tile(x, y);
            let (column, row) = layout.position(layout.cell(tile).unwrap());
            let expected = json!({
                "x": x, "y": y, "tile": tile.0, "sides": tiling.sides(x, y), "row": row, "column": column,
            });
            assert_eq!(*told, expected, "{name} {seed}");
        }
        for view in one["views"].as_array().unwrap() {
            let extent: Vec<i64> =
                view["extent"].as_array().unwrap().iter().map(|at| at.as_i64().unwrap()).collect();
            let shape = Shape::new(extent[2] as u64, extent[3] as u64).unwrap();
            let window = tiling.window(extent[0], extent[1], shape);
            let copies = window.iter().filter(|tile| json!(tile.0) == view["tile"]).count();
            assert!(copies > 0, "{view}");
            assert_eq!(view["count"], json!([copies, window.len()]), "{name} {seed}");
            assert_eq!(view["shown"], json!(copies), "{name} {seed}: {view}");
        }
        // Each draws, exactly so, and another picture than the one before.
        assert_eq!(one["differences"], json!([0, 0]), "{name} {seed}: {one}");
        assert_eq!(one["another"], json!(true), "{name} {seed}");
    }
    assert_eq!(answers["time"], json!(true), "{answers}");
}

/// Hash, Halton, colors that fade: the rules of complete sets.
fn of_complete(kind: Kind, colors: usize, name: &str, seed: u32) -> Coloring {
    match name {
        "hash" => Coloring::Hash { seed },
        "halton" => {
            let grid = Shape::new(4096, 4096).unwrap();
            Coloring::Halton(Halton::of_tiles(kind, grid).unwrap())
        }
        _ => {
            let mut weights = vec![0.1 / colors as f64; 48 * colors];
            for cell in 0..48 {
                let (first, share) = (cell * colors / 48, 0.9 * (cell * colors % 48) as f64 / 48.0);
                weights[cell * colors + first] += 0.9 - share;
                weights[cell * colors + (first + 1) % colors] += share;
            }
            let shape = Shape::new(48, 1).unwrap();
            let map = Probabilities::new(shape, [2, 2], colors, &weights, seed).unwrap();
            Coloring::Probabilities(map)
        }
    }
}

#[test]
fn the_viewer_of_a_complete_set() {
    let packing = constructed(Kind::Corner, "3");
    let layout = Layout::new(&packing, Arrangement::Packed, SIDE, 0).unwrap();
    let Some(answers) = driven(&packing, &layout, 7, true) else { return };
    // Exact through the LOD of the strip, wherever it is, and not beyond.
    for name in ["lod 0", "lod 0.5", "lod 1", "lod 1.5", "lod 2", "far", "magnified", "4 : 1"] {
        assert_eq!(largest(&answers, name), 0, "{name}: {answers}");
    }
    for name in ["lod 2.5", "lod 3", "lod 4", "16 : 1", "row-major"] {
        assert!(largest(&answers, name) > 2, "{name}: {answers}");
    }
    assert!(largest(&answers, "hardware") <= 6, "{answers}");
    let names = ["hash", "halton", "fade"];
    tilings_are_those(&answers, &packing, &layout, &names, |name, seed| {
        of_complete(Kind::Corner, 3, name, seed)
    });
    all_true(&answers, &["drag", "wheel", "pinch", "arrow", "plus", "view key", "bias key"]);
    all_true(
        &answers,
        &["borders key", "help", "fold", "resize", "hover", "tiling key", "new key"],
    );
    all_true(&answers, &["repeats key", "held", "let go", "clock", "link"]);
}

#[test]
fn the_viewer_of_wang_tiles() {
    let packing = constructed(Kind::Wang, "2,3");
    let layout = Layout::new(&packing, Arrangement::Packed, SIDE, 0).unwrap();
    let Some(answers) = driven(&packing, &layout, 3, false) else { return };
    let names = ["hash", "halton"];
    tilings_are_those(&answers, &packing, &layout, &names, |name, seed| {
        of_complete(Kind::Wang, 0, name, seed)
    });
    assert!(largest(&answers, "row-major") > 2, "{answers}");
    assert!(largest(&answers, "hardware") <= 6, "{answers}");
}

#[test]
fn the_viewer_of_a_sheet_with_gutters() {
    // By number, so nothing fits; but gutters as wide as the strip show what would. The 27 tiles whose
    // edges are sums of colors on corners.
    let tiles = [
        69, 16, 76, 56, 33, 0, 12, 28, 57, 64, 61, 48, 23, 80, 11, 40, 4, 36, 8, 72, 44, 52, 68,
        19, 47, 32, 24,
    ];
    let set = TileSet::new(Kind::Wang, Colors::one(3).unwrap(), Members::Explicit(alternating(3)));
    let shape = Shape::new(9, 3).unwrap();
    let packing = Packing::new(set.unwrap(), shape, false, tiles.map(TileId).to_vec());
    assert!(tilepack::verify::check(&packing).is_valid());
    let layout = Layout::new(&packing, Arrangement::ByNumber, SIDE, STRIP).unwrap();
    let Some(answers) = driven(&packing, &layout, 3, false) else { return };
    tilings_are_those(&answers, &packing, &layout, &["sums"], |_, seed| {
        Coloring::Sums(Sums::one_hash(Colors::one(3).unwrap(), seed).unwrap())
    });
    assert!(largest(&answers, "hardware") <= 6, "{answers}");
}

#[test]
fn the_viewer_of_a_set_with_a_direct_tiling() {
    // The 54 tiles of the difference set over three colors.
    let tiles = [
        18, 60, 56, 47, 79, 71, 50, 61, 2, 63, 23, 24, 69, 68, 32, 64, 14, 3, 36, 67, 59, 38, 31,
        10, 39, 40, 4, 48, 52, 7, 27, 19, 33, 28, 46, 16, 55, 74, 26, 15, 57, 11, 12, 75, 35, 0,
        72, 80, 44, 22, 51, 43, 76, 8,
    ];
    let set = TileSet::new(Kind::Corner, Colors::one(3).unwrap(), Members::Compact).unwrap();
    let shape = Shape::new(9, 6).unwrap();
    let packing = Packing::new(set, shape, false, tiles.map(TileId).to_vec());
    assert!(tilepack::verify::check(&packing).is_valid());
    let layout = Layout::new(&packing, Arrangement::Packed, SIDE, 0).unwrap();
    let Some(answers) = driven(&packing, &layout, 11, false) else { return };
    tilings_are_those(&answers, &packing, &layout, &["difference"], |_, seed| {
        Coloring::Compact(Compact::of(3, seed).unwrap())
    });
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
    let layout = Layout::new(&packing, Arrangement::Packed, SIDE, 0).unwrap();
    let found = mixed(&packing, 7).unwrap();
    assert!(found.changed > 100, "{}", found.changed);
    let Some(answers) = driven(&packing, &layout, 7, false) else { return };
    tilings_are_those(&answers, &packing, &layout, &["map"], |_, _| {
        Coloring::Map(found.map.clone())
    });
}
