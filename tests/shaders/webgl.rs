//! The shaders against Rust, bit for bit: a WebGL 2 context computes the number and the cell of every
//! tile of windows near, far and on both sides of zero, and reads the texture of some of them.
//!
//! The numbers come back on the console; the comparison is made here.

use crate::{Case, tools};
use serde_json::{Value, json};
use std::fs;
use tilepack::atlas::shader::{CellTable, Language, MapTexture, Shader};
use tilepack::torus::Shape;

/// Tiles of a side of a window.
const SIDE: i64 = 24;

/// Their south-west tiles. Wang tiles count edges twice as far as tiles.
const ORIGINS: [(i64, i64); 5] = [
    (-12, -12),
    (1_000_003, -2_000_029),
    (-(1 << 30), 5),
    ((1 << 30) - SIDE - 1, 77),
    (-345, 1 << 29),
];

const PAGE: &str = include_str!("bits.html");

/// What the page needs to know of a case.
fn job(case: &Case) -> Value {
    let shader = Shader::new(Language::GlslEs300, &case.tiling, &case.cells, "my").unwrap();
    let mut arguments = String::new();
    let map = match MapTexture::of(&case.tiling) {
        Some(map) => {
            arguments += ", map";
            // Two numbers a texel, of which the second may be of no use.
            let texels = map.data.chunks(map.channels);
            let texels: Vec<u32> =
                texels.flat_map(|t| [t[0], t.get(1).copied().unwrap_or(0)]).collect();
            json!({ "width": map.width, "height": map.height, "data": texels })
        }
        None => Value::Null,
    };
    let sides = format!("my_sides(at.x, at.y{arguments})");
    let table = match case.cells.as_formula() {
        Some(_) => Value::Null,
        None => {
            let table = CellTable::new(&case.cells).unwrap();
            arguments += ", table";
            json!({ "width": table.width, "height": table.height, "data": table.cells })
        }
    };
    let cell = format!("my_cell(sides{})", if table.is_null() { "" } else { ", table" });
    json!({
        "functions": shader.functions(), "sides": sides, "cell": cell, "map": map, "table": table,
        "texture": format!("my_texture(position{arguments}, atlas)"),
        "width": case.cells.shape().width(), "height": case.cells.shape().height(),
    })
}

#[test]
fn shaders_are_rust_bit_for_bit() {
    let Some(chromium) = tools::find("chromium") else { return };
    let cases = Case::all();
    let jobs: Vec<Value> = cases.iter().map(job).collect();
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("bits.html");
    let text = PAGE
        .replace("/*JOBS*/[]", &json!(jobs).to_string().replace('<', "\\u003c"))
        .replace("/*ORIGINS*/[]", &json!(ORIGINS).to_string())
        .replace("/*SIDE*/0", &SIDE.to_string());
    fs::write(&page, text).unwrap();
    let answers = tools::browse(&chromium, &page);
    let answers: Value = serde_json::from_str(&answers).unwrap_or_else(|_| panic!("{answers}"));
    assert_eq!(answers.as_array().unwrap().len(), cases.len());
    for (case, answer) in cases.iter().zip(answers.as_array().unwrap()) {
        same_tiles(case, &answer["tiles"]);
        same_texture(case, &answer["texture"]);
    }
}

/// Number, column and row of every tile, rows from the south.
fn same_tiles(case: &Case, windows: &Value) {
    let windows = windows.as_array().unwrap();
    assert_eq!(windows.len(), ORIGINS.len(), "{}", case.name);
    for ((x, y), window) in ORIGINS.into_iter().zip(windows) {
        let numbers: Vec<u64> =
            window.as_array().unwrap().iter().map(|number| number.as_u64().unwrap()).collect();
        assert_eq!(numbers.len() as i64, 3 * SIDE * SIDE);
        for (at, found) in numbers.chunks(3).enumerate() {
            let (x, y) = (x + at as i64 % SIDE, y + at as i64 / SIDE);
            let tile = case.tiling.tile(x, y);
            let (row, column) = case.cells.find(tile).unwrap();
            let expected = [tile.0.into(), column as u64, row as u64];
            assert_eq!(found, expected, "{}: ({x}, {y})", case.name);
            assert_eq!(case.packing.tile(Shape::cell(case.packing.shape, row, column)), tile);
        }
    }
}

/// An atlas of 2 x 2 texels a tile, each with its own color: every quarter of a tile shows the right
/// one, north up.
fn same_texture(case: &Case, texels: &Value) {
    let side = 16i64;
    let texels = texels.as_array().unwrap();
    assert_eq!(texels.len() as i64, 3 * side * side, "{}", case.name);
    for (at, found) in texels.chunks(3).enumerate() {
        // Half tiles from (-4, -4) on.
        let (x, y) = (at as i64 % side - 8, at as i64 / side - 8);
        let tile = case.tiling.tile(x.div_euclid(2), y.div_euclid(2));
        let (row, column) = case.cells.find(tile).unwrap();
        let texel_x = 2 * column as i64 + x.rem_euclid(2);
        let texel_y = 2 * row as i64 + 1 - y.rem_euclid(2);
        let expected = [texel_x % 256, texel_y % 256, texel_x / 256 * 16 + texel_y / 256];
        let found: Vec<i64> = found.iter().map(|value| value.as_i64().unwrap()).collect();
        assert_eq!(found, expected, "{}: half tile ({x}, {y})", case.name);
    }
}
