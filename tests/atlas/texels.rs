//! The texels of atlases and of their levels, gutters and tables.

use super::{FINE, corner, noise, wang};
use std::io::Cursor;
use tilepack::atlas::light::Decoder;
use tilepack::atlas::light::{decode, encode};
use tilepack::atlas::{
    Arrangement, Channels, Depth, Format, Gutter, Image, Layout, Light, Scene, TileImages,
    assemble, chain, read_png, tables, write_png,
};
use tilepack::tiles::TileId;

#[test]
fn an_atlas_is_its_tiles_side_by_side() {
    for packing in [corner(3), wang(2, 3)] {
        let images = noise(&packing, 16, 2, Format::RGBA8);
        let layout = Layout::new(&packing, Arrangement::Packed, 16, 0).unwrap();
        let scene =
            Scene { layout: &layout, packing: &packing, gutter: Gutter::Clamp, images: &images };
        let levels = scene.levels(layout.levels()).unwrap();
        assert_eq!(levels.len(), 5);
        let expected = assemble(&images, &packing.tiles, packing.shape.width()).unwrap();
        assert_eq!(levels[0], expected);
        for (cell, &tile) in packing.tiles.iter().enumerate() {
            let shown = layout.tiles[layout.cell(tile).unwrap()];
            assert_eq!((shown, layout.tiles[cell]), (tile, tile));
        }
    }
}

/// A texel of level n is the mean of 4^n texels, in light, to the nearest sample.
#[test]
fn levels_are_means() {
    for (channels, depth, light) in [
        (Channels::Rgba, Depth::Eight, Light::Srgb),
        (Channels::Gray, Depth::Sixteen, Light::Linear),
        (Channels::GrayAlpha, Depth::Sixteen, Light::Srgb),
        (Channels::Rgb, Depth::Eight, Light::Linear),
    ] {
        let format = Format { channels, depth, light };
        let packing = corner(2);
        let image = noise(&packing, 16, 2, format).draw(TileId(5)).unwrap();
        let levels = chain(image.clone(), 5, &Decoder::new(format));
        let max = f64::from(format.max());
        for (level, small) in levels.iter().enumerate().skip(1) {
            let size = 1 << level;
            for at in 0..small.width() * small.height() * channels.count() {
                let (texel, channel) = (at / channels.count(), at % channels.count());
                let (x, y) = (texel % small.width(), texel / small.width());
                let alpha = channels.has_alpha() && channel + 1 == channels.count();
                let encoded = light == Light::Srgb && !alpha;
                let mut sum = 0.0;
                for inner in 0..size * size {
                    let (dx, dy) = (inner % size, inner / size);
                    let code = image.sample(x * size + dx, y * size + dy, channel);
                    let code = f64::from(code) / max;
                    sum += if encoded { f64::from(decode(code as f32)) } else { code };
                }
                let mean = sum / (size * size) as f64;
                let code = if encoded { f64::from(encode(mean as f32)) } else { mean };
                let is = f64::from(small.sample(x, y, channel));
                assert!(
                    (is - code * max).abs() < 0.51 + max / 8e5,
                    "{format:?} {is} {}",
                    code * max
                );
            }
        }
    }
}

/// A gutter shows what lies around the tile in the packing.
#[test]
fn gutters_show_neighbors() {
    let packing = corner(2);
    let images = noise(&packing, 8, 2, FINE);
    let whole = assemble(&images, &packing.tiles, 4).unwrap();
    for arrangement in [Arrangement::Packed, Arrangement::ByNumber] {
        let layout = Layout::new(&packing, arrangement, 8, 3).unwrap();
        let scene =
            Scene { layout: &layout, packing: &packing, gutter: Gutter::Neighbor, images: &images };
        let atlas = &scene.levels(1).unwrap()[0];
        for (cell, &tile) in layout.tiles.iter().enumerate() {
            let (column, row) = layout.position(cell);
            let there = packing.tiles.iter().position(|&other| other == tile).unwrap();
            for at in 0..14 * 14 {
                let (x, y) = (at % 14, at / 14);
                let from = |tile: usize, at: usize| (tile * 8 + at + 32 - 3) % 32;
                let expected = whole.sample(from(there % 4, x), from(there / 4, y), 0);
                assert_eq!(atlas.sample(column * 14 + x, row * 14 + y, 0), expected);
            }
        }
    }
}

#[test]
fn clamped_gutters_repeat_the_border() {
    let packing = corner(2);
    let images = noise(&packing, 4, 1, FINE);
    let layout = Layout::new(&packing, Arrangement::Packed, 4, 2).unwrap();
    let scene =
        Scene { layout: &layout, packing: &packing, gutter: Gutter::Clamp, images: &images };
    let atlas = &scene.levels(1).unwrap()[0];
    let tile = images.draw(layout.tiles[0]).unwrap();
    for at in 0..64 {
        let (x, y) = (at % 8, at / 8);
        let inner = |at: usize| at.clamp(2, 5) - 2;
        assert_eq!(atlas.sample(x, y, 0), tile.sample(inner(x), inner(y), 0));
    }
}

#[test]
fn tables_lead_there_and_back() {
    for packing in [corner(3), corner(4), wang(2, 3)] {
        let layout = Layout::new(&packing, Arrangement::Packed, 8, 0).unwrap();
        let mut text = Vec::new();
        tables::write_json(&mut text, &layout, 2).unwrap();
        let json: serde_json::Value = serde_json::from_slice(&text).unwrap();
        let cells = json["cells"].as_array().unwrap();
        assert_eq!(cells.len(), packing.tiles.len());
        for entry in cells {
            let number = |at: usize| entry[at].as_u64().unwrap() as usize;
            assert_eq!(json["tiles"][number(2)][number(1)], entry[0]);
        }
        let (tile_picture, cell_picture) =
            (tables::tile_picture(&layout).unwrap(), tables::cell_picture(&layout).unwrap());
        let width = cell_picture.width();
        for (cell, &tile) in layout.tiles.iter().enumerate() {
            let (column, row) = layout.position(cell);
            assert_eq!(u32::from(tile_picture.sample(column, row, 0)), tile.0);
            let (x, y) = (tile.index() % width, tile.index() / width);
            assert_eq!(usize::from(cell_picture.sample(x, y, 0)), cell);
        }
        let mut csv = Vec::new();
        tables::write_csv(&mut csv, &layout).unwrap();
        assert_eq!(String::from_utf8(csv).unwrap().lines().count(), packing.tiles.len() + 1);
    }
}

/// Pictures that are read by another decoder are what was written.
#[test]
fn png_files_are_what_others_read() {
    let packing = corner(4);
    let image = assemble(&noise(&packing, 8, 2, Format::RGBA8), &packing.tiles, 16).unwrap();
    let mut file = Vec::new();
    write_png(&mut file, &image, &[("Comment", "a")]).unwrap();
    let mut reader = png::Decoder::new(Cursor::new(&file)).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut data).unwrap();
    assert_eq!(data, image.data());
    let text = &reader.info().uncompressed_latin1_text[0];
    assert_eq!((text.keyword.as_str(), text.text.as_str()), ("Comment", "a"));
    // A picture that is cut off, or spoilt, is an error and no panic.
    for cut in (0..file.len()).step_by(97) {
        assert!(read_png(Cursor::new(&file[..cut]), 1 << 20).is_err());
    }
    assert!(read_png(Cursor::new(&file), 1000).unwrap_err().contains("limit"));
    let mut spoilt = file.clone();
    spoilt[60] ^= 0x40;
    let _: Result<Image, String> = read_png(Cursor::new(&spoilt), 1 << 20);
}
