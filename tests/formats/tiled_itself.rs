//! The map editor Tiled, and a reader that others wrote, find in our files what is meant.

use crate::{Noise, Place, complete, text};
use serde_json::Value;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Output};
use tilepack::atlas::formats::Sheet;
use tilepack::atlas::formats::tiled::{MAX_COLORS, write_tmx, write_tsx};
use tilepack::atlas::formats::tsj::write_tsj;
use tilepack::atlas::formats::wangsets::{self, Choice};
use tilepack::atlas::{Format, Image, Light, TileImages, assemble, demo, open_png, write_png};
use tilepack::tiles::{Kind, Members};
use tilepack::torus::Packing;

const TILE: usize = 6;

/// Packings, and margin and spacing of their pictures.
fn sheets() -> [(Packing, u64, u64); 2] {
    [(complete(Kind::Corner, "3"), 0, 0), (complete(Kind::Wang, "3,2"), 2, 3)]
}

fn sheet(packing: &Packing, margin: u64, spacing: u64) -> Sheet<'_> {
    Sheet { packing, image: "atlas.png", tile: TILE as u64, margin, spacing }
}

/// A program of Tiled, which draws on no screen.
fn tiled(place: &Place, program: &str, args: &[&str]) -> Option<Output> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    if !folders.iter().any(|folder| folder.join(program).is_file()) {
        assert!(std::env::var_os("CI").is_none(), "{program} (Debian: tiled) is not installed");
        let _ = writeln!(std::io::stderr(), "skipped: {program} is not installed");
        return None;
    }
    let mut command = Command::new(program);
    command.args(args).current_dir(place.path(""));
    command.env("QT_QPA_PLATFORM", "offscreen").env("XDG_RUNTIME_DIR", place.path(""));
    Some(command.output().unwrap())
}

/// The picture of a sheet; what is between its tiles is transparent.
fn picture(sheet: &Sheet<'_>) -> Image {
    let (width, height) = sheet.size();
    let mut image = Image::new(width as usize, height as usize, Format::RGBA8);
    for (cell, &tile) in sheet.packing.tiles.iter().enumerate() {
        let (x, y) = sheet.corner(cell);
        image.blit(&Noise(TILE).draw(tile).unwrap(), x as usize, y as usize);
    }
    image
}

#[test]
fn tiled_draws_the_same_tiling() {
    for (packing, margin, spacing) in sheets() {
        let sheet = sheet(&packing, margin, spacing);
        let place = Place::new();
        let mut png = Vec::new();
        write_png(&mut png, &picture(&sheet), &[]).unwrap();
        let demo = demo::tiling(&packing, "13x7".parse().unwrap(), 4);
        place.write("atlas.png", png);
        place.write("set.tsx", text(|out| write_tsx(out, &sheet, "set")));
        place.write("map.tmx", text(|out| Ok(write_tmx(out, &sheet, &demo, "set.tsx")?)));
        let args = ["--no-smoothing", "map.tmx", "out.png"];
        let Some(output) = tiled(&place, "tmxrasterizer", &args) else { return };
        assert!(output.status.success(), "{output:?}");
        let theirs = open_png(&place.path("out.png")).unwrap().with_light(Light::Srgb);
        let ours = assemble(&Noise(TILE), &demo.tiles, 13).unwrap();
        assert!(theirs == ours, "{}", packing.set.kind());
    }
}

#[test]
fn tiled_keeps_the_colors() {
    for (packing, margin, spacing) in sheets() {
        let sheet = sheet(&packing, margin, spacing);
        let place = Place::new();
        let ours = text(|out| write_tsx(out, &sheet, "set"));
        // Without the picture Tiled would count no tiles.
        let mut png = Vec::new();
        write_png(&mut png, &picture(&sheet), &[]).unwrap();
        place.write("ours.tsx", &ours).write("atlas.png", png);
        let Some(output) =
            tiled(&place, "tiled", &["--export-tileset", "json", "ours.tsx", "back.tsj"])
        else {
            return;
        };
        assert!(output.status.success(), "{output:?}");
        let read = |text: &str| wangsets::read(text, Choice::default()).unwrap();
        let back = place.read("back.tsj");
        assert_eq!(read(&back), read(&ours));
        let back: Value = serde_json::from_str(&back).unwrap();
        let mine: Value = serde_json::from_str(&text(|out| write_tsj(out, &sheet, "set"))).unwrap();
        assert_eq!(back["wangsets"], mine["wangsets"]);
        for field in ["columns", "tilecount", "margin", "spacing", "image", "imagewidth", "name"] {
            assert_eq!(back[field], mine[field], "{field}");
        }
    }
}

/// Why content has to be compared: the exit code says nothing.
#[test]
fn tiled_drops_what_it_does_not_understand_without_a_word() {
    let (packing, margin, spacing) = &sheets()[0];
    let good = text(|out| write_tsx(out, &sheet(packing, *margin, *spacing), "set"));
    let bad = good.replacen("wangid=\"0,", "wangid=\"", 1);
    let place = Place::new();
    place.write("bad.tsx", &bad);
    let args = ["--export-tileset", "json", "bad.tsx", "back.tsj"];
    let Some(output) = tiled(&place, "tiled", &args) else { return };
    assert!(output.status.success());
    let back = place.read("back.tsj");
    assert!(wangsets::read(&back, Choice::default()).is_err(), "{back}");
    let error = wangsets::read(&bad, Choice::default()).unwrap_err();
    assert_eq!((error.line, error.column), (10, 4));
}

#[test]
fn the_crate_tiled_reads_the_colors_and_the_map() {
    for (packing, margin, spacing) in sheets() {
        let sheet = sheet(&packing, margin, spacing);
        let place = Place::new();
        let demo = demo::tiling(&packing, "5x4".parse().unwrap(), 1);
        place.write("set.tsx", text(|out| write_tsx(out, &sheet, "a <set> & \"more\"")));
        place.write("map.tmx", text(|out| Ok(write_tmx(out, &sheet, &demo, "set.tsx")?)));
        let map = tiled::Loader::new().load_tmx_map(place.path("map.tmx")).unwrap();
        let tileset = &map.tilesets()[0];
        assert_eq!(tileset.name, "a <set> & \"more\"");
        let (width, height) = sheet.size();
        let image = tileset.image.as_ref().unwrap();
        assert_eq!((image.width as u64, image.height as u64), (width, height));
        assert_eq!((u64::from(tileset.margin), u64::from(tileset.spacing)), (margin, spacing));
        assert_eq!(tileset.columns as usize, packing.shape.width());
        assert_eq!(tileset.transformations, tiled::Transformations::default());

        let set = &tileset.wang_sets[0];
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        let is_wang = kind == Kind::Wang;
        let h = colors.horizontal();
        assert_eq!(set.wang_colors.len(), if is_wang { h + colors.vertical() } else { h });
        assert_eq!(set.wang_tiles.len(), packing.tiles.len());
        for (cell, &tile) in packing.tiles.iter().enumerate() {
            let [a, b, c, d] = kind.unpack(tile, colors).map(|color| color + 1);
            let h = h as u8;
            let expected = match is_wang {
                true => [a, 0, h + b, 0, c, 0, h + d, 0],
                false => [0, a, 0, b, 0, c, 0, d],
            };
            assert_eq!(set.wang_tiles[&(cell as u32)].wang_id.0, expected);
        }
        let layer = map.get_layer(0).unwrap().as_tile_layer().unwrap();
        for (place, &tile) in demo.tiles.iter().enumerate() {
            let there = layer.get_tile(place as i32 % 5, place as i32 / 5).unwrap();
            assert_eq!(packing.tiles[there.id() as usize], tile);
        }
    }
}

#[test]
fn tiled_knows_so_many_colors() {
    let wide = |kind, colors: &str| {
        let one = Members::Explicit(vec![tilepack::tiles::TileId(0)]);
        crate::row(kind, colors, one)
    };
    let write = |packing: &Packing| {
        let sheet = Sheet { packing, image: "a.png", tile: 8, margin: 0, spacing: 0 };
        let mut out = Vec::new();
        write_tsx(&mut out, &sheet, "set").and_then(|()| write_tsj(&mut out, &sheet, "set"))
    };
    assert_eq!(MAX_COLORS, 254);
    write(&wide(Kind::Corner, "254")).unwrap();
    write(&wide(Kind::Wang, "100,154")).unwrap();
    let error = write(&wide(Kind::Corner, "255")).unwrap_err().to_string();
    assert!(error.contains("255 corner colors") && error.contains("at most 254"), "{error}");
    let error = write(&wide(Kind::Wang, "200,55")).unwrap_err().to_string();
    assert!(error.contains("200 colors of horizontal and 55 of vertical"), "{error}");
}
