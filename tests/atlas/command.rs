//! `atlas` and `lint` as users meet them.

use serde_json::Value;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use tempfile::TempDir;
use tilepack::atlas::{Image, read_png, write_png};

struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    /// Exit code, standard output, standard error.
    fn run(&self, args: &str) -> (i32, String, String) {
        let mut command = assert_cmd::cargo::cargo_bin_cmd!("tilepack");
        let command = command.current_dir(self.0.path()).args(args.split_whitespace());
        let output = command.output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
    }

    #[track_caller]
    fn exits(&self, code: i32, args: &str) -> String {
        let (is, stdout, stderr) = self.run(args);
        assert_eq!(is, code, "{args}: {stdout}{stderr}");
        stdout + &stderr
    }

    #[track_caller]
    fn refused(&self, args: &str, words: &str) {
        let told = self.exits(2, args);
        assert!(told.contains(words), "{args}: {told}");
    }

    fn picture(&self, file: &str) -> Image {
        read_png(Cursor::new(fs::read(self.path(file)).unwrap()), 1 << 30).unwrap()
    }

    fn write_picture(&self, file: &str, image: &Image) {
        let mut bytes = Vec::new();
        write_png(&mut bytes, image, &[]).unwrap();
        fs::write(self.path(file), bytes).unwrap();
    }
}

fn with_packings() -> Place {
    let place = Place::new();
    place.exits(0, "find --kind corner --colors 2 --quiet -o two.json");
    place.exits(0, "find --kind corner --colors 3 --quiet -o three.json");
    place.exits(0, "find --kind wang --colors 2 --quiet -o wang.json");
    place
}

#[test]
fn an_atlas_its_levels_and_tables() {
    let place = with_packings();
    let told = place.exits(
        0,
        "atlas three.json -o a.png --mips --tables t --check --json --fill noise --tile-size 32",
    );
    let json: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(json["result"], "made");
    assert_eq!(json["exact_to_lod"], 2);
    assert_eq!(json["errors"].as_array().unwrap().len(), 6);
    assert_eq!(json["files"].as_array().unwrap().len(), 6);
    for (file, side) in [("a.png", 288), ("a.1.png", 144), ("a.5.png", 9)] {
        let image = place.picture(file);
        assert_eq!((image.width(), image.height()), (side, side));
    }
    for file in ["atlas.json", "atlas.csv", "atlas.h", "tiles.png", "cells.png"] {
        assert!(place.path("t").join(file).exists(), "{file}");
    }
    let header = fs::read_to_string(place.path("t/atlas.h")).unwrap();
    assert!(header.contains("atlas_cells[81]") && header.contains("#define ATLAS_COLUMNS 9"));
}

/// The same bytes for any number of threads, and whether drawn at once or row by row.
#[test]
fn equal_arguments_give_equal_bytes() {
    let place = with_packings();
    for fill in ["marks", "noise", "truchet"] {
        let make = |more: &str| {
            let command = format!("atlas three.json --fill {fill} --mips -o a.png {more}");
            place.exits(0, &command);
            ["a.png", "a.2.png"].map(|file| fs::read(place.path(file)).unwrap())
        };
        let one = make("--threads 1");
        assert!(one == make("--threads 2") && one == make("--check"), "{fill}");
    }
}

#[test]
fn the_picture_says_what_it_is() {
    let place = with_packings();
    place.exits(0, "atlas two.json -o a.png --fill noise --seed 5 --tile-size 16");
    let bytes = fs::read(place.path("a.png")).unwrap();
    let reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
    let text: Vec<&str> =
        reader.info().uncompressed_latin1_text.iter().map(|text| text.text.as_str()).collect();
    assert_eq!(text[1], "tilepack atlas two.json --fill noise --tile-size 16 --strip 4 --seed 5");
}

/// The pictures on the pages are those that the program makes.
#[test]
fn pictures_of_the_pages() {
    let place = with_packings();
    let pages = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/pictures"));
    for (packing, side, picture) in
        [("three", 64, "three-truchet.png"), ("wang", 96, "wang-truchet.png")]
    {
        let command = format!("atlas {packing}.json --fill truchet --tile-size {side}");
        place.exits(0, &format!("{command} --channels rgb -o a.png"));
        let shown = read_png(Cursor::new(fs::read(pages.join(picture)).unwrap()), 1 << 30);
        assert!(shown.unwrap() == place.picture("a.png"), "{picture}");
    }
}

/// Depths, channels and light as asked.
#[test]
fn samples_as_asked() {
    let place = with_packings();
    for channels in ["gray", "gray-alpha", "rgb", "rgba"] {
        for depth in [8, 16] {
            for linear in ["", "--linear"] {
                let options = format!("--channels {channels} --depth {depth} {linear}");
                place.exits(0, &format!("atlas two.json -o a.png --tile-size 8 {options} --check"));
                let format = place.picture("a.png").format();
                assert_eq!(format.sample_bytes() * 8, depth);
                assert_eq!(format.light == tilepack::atlas::Light::Linear, !linear.is_empty());
            }
        }
    }
}

/// A sheet and a folder of the tiles of an atlas give the atlas again.
#[test]
fn pictures_of_others() {
    let place = with_packings();
    place.exits(0, "atlas two.json -o a.png --fill noise --tile-size 16 --arrange by-number");
    place.exits(0, "atlas two.json -o b.png --fill noise --tile-size 16");
    let sides = |tile: usize| [tile >> 3 & 1, tile >> 2 & 1, tile >> 1 & 1, tile & 1];
    let list: Vec<String> =
        (0..16).map(sides).map(|[ne, se, sw, nw]| format!("[{nw},{ne},{se},{sw}]")).collect();
    let set = format!("{{\"kind\":\"corner\",\"tiles\":[{}]}}", list.join(","));
    fs::write(place.path("set.json"), set).unwrap();
    place.exits(0, "atlas two.json -o c.png --fill a.png --sheet set.json --check");
    assert_eq!(place.picture("c.png"), place.picture("b.png"));
    // The same from a folder, half of it named by colors.
    let whole = place.picture("a.png");
    fs::create_dir(place.path("tiles")).unwrap();
    for tile in 0..16 {
        let part = whole.part(tile % 4 * 16, tile / 4 * 16, 16, 16);
        let name = match tile % 2 {
            0 => tile.to_string(),
            _ => sides(tile).map(|color| color.to_string()).join("-"),
        };
        place.write_picture(&format!("tiles/{name}.png"), &part);
    }
    place.exits(0, "atlas two.json -o d.png --fill tiles");
    assert_eq!(place.picture("d.png"), place.picture("b.png"));
    place.refused("atlas two.json -o e.png --fill tiles --strip 5", "differ at column");
    place.exits(0, "atlas two.json -o e.png --fill tiles --strip 0");
    place.refused("atlas three.json -o e.png --fill tiles", "second picture of tile 10");
    place.refused("atlas two.json -o e.png --fill a.png", "--sheet");
    fs::rename(place.path("tiles/4.png"), place.path("tiles/99.png")).unwrap();
    place.refused("atlas two.json -o e.png --fill tiles", "tile 99 is none of 0 to 15");
    fs::remove_file(place.path("tiles/99.png")).unwrap();
    place.refused("atlas two.json -o e.png --fill tiles", "no picture of tile 4");
    place.write_picture("tiles/4.png", &whole.part(0, 0, 8, 8));
    place.refused("atlas two.json -o e.png --fill tiles", "4.png: is 8 x 8 texels");
    fs::write(place.path("tiles/4.png"), "no picture").unwrap();
    place.refused("atlas two.json -o e.png --fill tiles", "4.png: expected a PNG");
    assert!(fs::read_dir(place.0.path()).unwrap().count() < 12);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let place = with_packings();
    place.exits(0, "find --kind domino --colors 2 --quiet -o ring.json");
    fs::write(place.path("bad.txt"), "kind=corner colors=2\n0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 0\n")
        .unwrap();
    for (args, words) in [
        ("two.json", "nothing to do"),
        ("bad.txt -o a.png", "not a packing"),
        ("ring.json -o a.png", "not of dominoes"),
        ("none.json -o a.png", "no such file"),
        ("two.json -o a.png --fill waves", "expected marks, noise, truchet"),
        ("two.json -o a.png --tile-size 8 --strip 5", "at most half a tile, 4 of 8"),
        ("two.json -o a.png --tile-size 0", "tiles of 0 texels"),
        ("two.json -o a.png --tile-size 8 --gutter 9", "a gutter of 9 texels"),
        ("two.json -o a.png --depth 12", "expected 8 or 16"),
        ("two.json -o a.png --channels cmyk", "gray-alpha"),
        ("two.json -o no/folder/a.png", "no/folder"),
        ("two.json --mips --check", "--output"),
    ] {
        place.refused(&format!("atlas {args}"), words);
        assert!(!place.path("a.png").exists(), "{args}");
    }
}

/// More texels than a PNG can have, and more than memory should.
#[test]
fn sizes_are_told_with_their_numbers() {
    let place = with_packings();
    place.exits(0, "find --kind wang --colors 16 --quiet -o many.json");
    place.refused("atlas many.json --check --tile-size 256", "65536 x 65536 texels takes");
    place.refused("atlas many.json --check --tile-size 5000", "expected 1 to 4096");
    place.refused("atlas many.json -o a.png --tile-size 4096", "a row of 256 tiles of 4096 texels");
}

#[test]
fn a_spoilt_sheet() {
    let place = with_packings();
    place.exits(0, "atlas wang.json -o w.png --fill truchet --tile-size 32");
    let fits = place.exits(0, "lint w.png --tiles wang.json --strip 4 --filter --complete");
    assert!(fits.contains("all fits") && fits.contains("exact through LOD"), "{fits}");
    let mut image = place.picture("w.png");
    let sample = image.sample(33, 40, 0);
    image.set_sample(33, 40, 0, sample ^ 128);
    place.write_picture("w.png", &image);
    let off = place
        .exits(1, "lint w.png --tiles wang.json --strip 4 --filter --heat h.png --seams s.csv");
    assert!(off.contains("west side: by up to 128/255 at texel 1, 8"), "{off}");
    assert!(off.contains("draw again first: tile") && off.contains("exact through LOD 0"), "{off}");
    assert_eq!(place.picture("h.png").width(), 128);
    let seams = fs::read_to_string(place.path("s.csv")).unwrap();
    assert_eq!(seams.lines().count(), 1 + 2 * 16 * 8);
    let json: Value =
        serde_json::from_str(&place.exits(1, "lint w.png --tiles wang.json --strip 4 --json"))
            .unwrap();
    assert_eq!(json["result"], "off");
    assert_eq!(json["off"][0]["cell"]["column"], 1);
    assert_eq!(json["redraw"][0]["row"], 1);
    place.exits(0, "lint w.png --tiles wang.json --strip 4 --tolerance 128");
    place.refused("lint w.png --tiles wang.json --strip 17", "at most half a tile, 16");
    place.refused("lint w.png --tiles wang.json --columns 5", "do not divide into 5 columns");
    place.refused("lint w.png --tiles none.json", "none.json");
    place.refused("lint none.png --tiles wang.json", "none.png");
    place.refused("lint wang.json --tiles wang.json", "expected a PNG");
    place.refused("lint w.png --tiles three.json", "128 texels do not divide into 9 columns");
}
