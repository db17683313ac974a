//! Texts for engines: golden files, and what they say.

use crate::{complete, text};
use serde_json::Value;
use tilepack::atlas::demo;
use tilepack::atlas::formats::texturepacker::{Frames, write_frames};
use tilepack::atlas::formats::{Sheet, godot::write_tres, obj};
use tilepack::tiles::Kind;
use tilepack::torus::Packing;

fn sheet(packing: &Packing) -> Sheet<'_> {
    Sheet { packing, image: "atlas.png", tile: 32, margin: 1, spacing: 2 }
}

#[track_caller]
fn golden(name: &str, written: &str) {
    let file = format!("{}/tests/formats/golden/{name}", env!("CARGO_MANIFEST_DIR"));
    let expected = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(expected == written, "{name} differs; it would be:\n{written}");
}

#[test]
fn godot() {
    let (corner, wang) = (complete(Kind::Corner, "2"), complete(Kind::Wang, "1,2"));
    golden("corner.tres", &text(|out| Ok(write_tres(out, &sheet(&corner))?)));
    golden("wang.tres", &text(|out| Ok(write_tres(out, &sheet(&wang))?)));
}

#[test]
fn frames() {
    let packing = complete(Kind::Wang, "1,2");
    let write = |frames| text(|out| Ok(write_frames(out, &sheet(&packing), frames)?));
    let (named, listed) = (write(Frames::Named), write(Frames::Listed));
    golden("hash.json", &named);
    let [named, listed]: [Value; 2] =
        [named, listed].map(|text| serde_json::from_str(&text).unwrap());
    assert_eq!(named["meta"], listed["meta"]);
    for (cell, tile) in packing.tiles.iter().enumerate() {
        let frame = &listed["frames"][cell];
        assert_eq!(frame["filename"], format!("tile-{tile}"));
        let same = &named["frames"][format!("tile-{tile}")];
        assert!(same.as_object().unwrap().iter().all(|(key, value)| frame[key] == *value));
        assert_eq!(frame["frame"]["x"], 1 + cell % 4 * 34);
    }
    // A tile that a covering shows again has a name of its own.
    let mut cover = packing.clone();
    cover.tiles[1] = cover.tiles[0];
    let text = text(|out| Ok(write_frames(out, &sheet(&cover), Frames::Named)?));
    let frames: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(frames["frames"].as_object().unwrap().len(), 4);
    assert!(frames["frames"]["tile-0-2"].is_object());
}

/// A reader of a few lines: every face is a square at its place with the picture of its tile.
#[test]
fn model() {
    let packing = complete(Kind::Corner, "2");
    let sheet = sheet(&packing);
    let (width, height) = sheet.size();
    let demo = demo::tiling(&packing, "5x3".parse().unwrap(), 2);
    let text = text(|out| Ok(obj::write_obj(out, &sheet, &demo, "a.mtl")?));
    let numbers =
        |line: &str| -> Vec<f64> { line.split(' ').skip(1).map(|n| n.parse().unwrap()).collect() };
    let of =
        |key: &'static str| text.lines().filter(move |line| line.split(' ').next() == Some(key));
    let vertices: Vec<_> = of("v").map(numbers).collect();
    let coordinates: Vec<_> = of("vt").map(numbers).collect();
    assert_eq!((vertices.len(), of("f").count(), of("mtllib").count()), (24, 15, 1));
    for (place, face) in of("f").enumerate() {
        let (x, y) = ((place % 5) as f64, (2 - place / 5) as f64);
        let cell = packing.tiles.iter().position(|tile| *tile == demo.tiles[place]).unwrap();
        let (left, top) = sheet.corner(cell);
        for (corner, (dx, dy)) in face.split(' ').skip(1).zip([(0, 0), (1, 0), (1, 1), (0, 1)]) {
            let index: Vec<usize> = corner.split('/').map(|n| n.parse().unwrap()).collect();
            assert_eq!(vertices[index[0] - 1], [x + f64::from(dx), y + f64::from(dy), 0.0]);
            let uv = &coordinates[index[1] - 1];
            let (u, v) = (left + 32 * dx as u64, height - top - 32 * (1 - dy as u64));
            assert!((uv[0] - u as f64 / width as f64).abs() < 1e-8, "{uv:?}");
            assert!((uv[1] - v as f64 / height as f64).abs() < 1e-8, "{uv:?}");
        }
    }
    let material = crate::text(|out| Ok(obj::write_mtl(out, "atlas.png")?));
    assert!(material.starts_with("newmtl atlas\n") && material.ends_with("map_Kd atlas.png\n"));
    assert!(text.contains("\nusemtl atlas\n"));
}
