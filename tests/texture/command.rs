//! `fill` as users meet it.

use crate::{GRAY, RGB, noise};
use serde_json::Value;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use tempfile::TempDir;
use tilepack::atlas::{Channels, Depth, Format, Image, Light, read_png, write_png};

struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    fn names(&self, folder: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(folder)).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
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
        let before = self.names("");
        let told = self.exits(2, args);
        assert!(told.contains(words), "{args}: {told}");
        assert_eq!(told.lines().count(), 1, "{args}: {told}");
        assert_eq!(before, self.names(""), "{args} left something");
    }

    fn json(&self, args: &str) -> Value {
        let (code, stdout, stderr) = self.run(args);
        assert_eq!(code, 0, "{args}: {stderr}");
        assert_eq!(stdout.lines().count(), 1);
        serde_json::from_str(&stdout).unwrap()
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

/// A place with an example.
fn with_example() -> Place {
    let place = Place::new();
    place.write_picture("a.png", &noise(72, 64, RGB, 1));
    place
}

const SMALL: &str = "--tile-size 32 --candidates 2 --tries 2 --quiet";

#[test]
fn a_folder_goes_on_to_an_atlas_that_filters_exactly() {
    let place = with_example();
    place.exits(0, &format!("fill a.png --kind corner --colors 2 {SMALL} -o tiles"));
    assert_eq!(place.names("tiles").len(), 16);
    assert_eq!(place.names(""), ["a.png", "tiles"]);
    place.exits(0, "find --kind corner --colors 2 --quiet -o two.json");
    let atlas = place.json("atlas two.json --fill tiles --strip 4 --check --json --quiet");
    assert_eq!(atlas["exact_to_lod"], 2);
    // A strip of 5 was not promised, and is not there.
    place.refused("atlas two.json --fill tiles --strip 5 -o no.png", "strip");
}

#[test]
fn sheets_say_what_they_show_and_pass_lint() {
    let place = with_example();
    for (kind, colors, method) in
        [("corner", "2", "ng"), ("wang", "2", "cohen"), ("corner", "2", "schlomer")]
    {
        let set = format!("--kind {kind} --colors {colors} --method {method}");
        place.exits(0, &format!("fill a.png {set} {SMALL} -o s.png"));
        let (_, found, _) =
            place.run("lint s.png --tiles s.tiles.json --strip 4 --complete --json");
        let found: Value = serde_json::from_str(&found).unwrap();
        assert_eq!((&found["tiles"], &found["tile_size"]), (&16.into(), &32.into()), "{set}");
        assert_eq!(found["off"], Value::Array(vec![]), "{set}");
        assert_eq!(found["missing"], Value::Array(vec![]), "{set}");
        place.exits(0, &format!("find --kind {kind} --colors {colors} --quiet -o p.json"));
        let args = "atlas p.json --fill s.png --sheet s.tiles.json --check --json --quiet";
        assert_eq!(place.json(args)["exact_to_lod"], 2, "{set}");
    }
}

#[test]
fn the_sheet_of_a_packing_is_its_atlas() {
    let place = with_example();
    place.exits(0, "find --kind wang --colors 2 --quiet -o wang.json");
    place.exits(0, &format!("fill a.png --packing wang.json {SMALL} -o sheet.png"));
    assert_eq!(place.names(""), ["a.png", "sheet.png", "wang.json"]);
    place.exits(0, "atlas wang.json --fill sheet.png --sheet wang.json -o atlas.png --quiet");
    assert_eq!(place.picture("sheet.png"), place.picture("atlas.png"));
}

#[test]
fn compact_and_listed_sets() {
    let place = with_example();
    place.exits(0, &format!("fill a.png --kind corner --colors 2 --set compact {SMALL} -o c"));
    place.exits(0, "find --kind corner --colors 2 --set compact --quiet -o c.json");
    assert_eq!(place.json("atlas c.json --fill c --check --json --quiet")["exact_to_lod"], 2);
    let set = r#"{"kind":"wang","colors":2,"tiles":[[0,0,0,0],[1,0,1,0],[0,1,0,1]]}"#;
    fs::write(place.path("set.json"), set).unwrap();
    let made = place.json(&format!("fill a.png --set set.json {SMALL} -o l.png --json"));
    assert_eq!(made["tiles"], 3);
    let (_, found, _) = place.run("lint l.png --tiles l.tiles.json --strip 4 --json");
    let found: Value = serde_json::from_str(&found).unwrap();
    assert_eq!(found["off"], Value::Array(vec![]));
}

#[test]
fn maps_and_depths_come_out_as_they_went_in() {
    let place = Place::new();
    let deep = Format { channels: Channels::Rgb, depth: Depth::Sixteen, light: Light::Srgb };
    place.write_picture("a.png", &noise(64, 64, deep, 1));
    let heights = Format { channels: Channels::Gray, depth: Depth::Sixteen, light: Light::Linear };
    place.write_picture("height.png", &noise(64, 64, heights, 2));
    place.write_picture("normal.png", &noise(64, 64, RGB, 3));
    let args = "fill a.png --map normal.png --map height.png --kind corner --colors 2";
    let made = place.json(&format!("{args} {SMALL} -o t --json"));
    assert_eq!(made["files"], serde_json::json!(["t", "t-normal", "t-height"]));
    assert_eq!(place.picture("t/3.png").format(), deep);
    assert_eq!(place.picture("t-height/3.png").format(), heights);
    let linear = Format { light: Light::Linear, ..RGB };
    assert_eq!(place.picture("t-normal/3.png").format(), linear);
    place.exits(0, &format!("{args} {SMALL} -o t.png"));
    let names = place.names("");
    let sheets = ["t-height.png", "t-normal.png", "t.png", "t.tiles.json"];
    assert!(sheets.iter().all(|name| names.contains(&(*name).to_owned())), "{names:?}");
}

#[test]
fn equal_arguments_give_equal_bytes() {
    let place = with_example();
    for (threads, out) in [(1, "one.png"), (3, "three.png")] {
        let args = format!("fill a.png --kind corner --colors 2 {SMALL} --threads {threads}");
        place.exits(0, &format!("{args} -o {out}"));
    }
    assert_eq!(
        fs::read(place.path("one.png")).unwrap(),
        fs::read(place.path("three.png")).unwrap()
    );
}

#[test]
fn a_report_with_what_others_would_have_made() {
    let place = with_example();
    let args = "fill a.png --kind corner --colors 2 --tile-size 32 --candidates 2 --tries 1";
    let told = place.exits(0, &format!("{args} --baselines --report r.json -o t"));
    for words in ["tiles: mismatch at seams", "periodic: ", "quilting: ", "written to t"] {
        assert!(told.contains(words), "{told}");
    }
    let report: Value = serde_json::from_slice(&fs::read(place.path("r.json")).unwrap()).unwrap();
    let number = |pointer: &str| report.pointer(pointer).unwrap().as_f64().unwrap();
    assert_eq!(number("/strip_differences"), 0.0);
    assert_eq!(number("/candidates"), 2.0);
    for of in ["/quality", "/baselines/periodic", "/baselines/quilting"] {
        assert!(number(&format!("{of}/seams/mean")) > 0.1);
        assert!(number(&format!("{of}/reuse/share")) <= 1.0);
        assert!(number(&format!("{of}/likeness/patches")) >= 0.0);
    }
    // One tile comes back always, a quilt never.
    let tiles = number("/baselines/periodic/period/tiles");
    assert!((number("/baselines/periodic/period/comb") - tiles).abs() < 1e-3);
    assert!((number("/baselines/periodic/period/correlation/0") - 1.0).abs() < 1e-3);
    assert!(number("/baselines/quilting/period/comb") < 3.0);
    let comb = number("/quality/period/comb");
    assert!(comb > 1.0 && comb < 0.9 * number("/quality/period/tiles"), "{comb}");
}

#[test]
fn no_time_gives_tiles_all_the_same() {
    let place = with_example();
    let args = format!("fill a.png --kind corner --colors 2 {SMALL} --time-limit 0 -o t --json");
    let (code, stdout, stderr) = place.run(&args);
    let made: Value = serde_json::from_str(&stdout).unwrap();
    assert_eq!(
        (code, &made["stopped_by"], &made["candidates"]),
        (0, &"time-limit".into(), &1.into())
    );
    assert!(stderr.contains("1 of 2 candidates tried"), "{stderr}");
    assert_eq!(place.names("t").len(), 16);
}

#[test]
fn opacity_has_to_be_explained() {
    let place = Place::new();
    let format = Format { channels: Channels::Rgba, depth: Depth::Eight, light: Light::Srgb };
    place.write_picture("a.png", &noise(64, 64, format, 1));
    let args = format!("fill a.png --kind corner --colors 2 {SMALL}");
    place.refused(&format!("{args} -o t"), "expected --alpha straight or --alpha premultiplied");
    place.exits(0, &format!("{args} --alpha straight -o straight"));
    place.exits(0, &format!("{args} --alpha premultiplied -o premultiplied"));
    assert_eq!(place.picture("straight/0.png").format(), format);
}

#[test]
fn bad_input_is_told_with_its_numbers() {
    let place = with_example();
    place.write_picture("b.png", &noise(70, 64, GRAY, 1));
    place.write_picture("c.png", &noise(72, 64, GRAY, 1));
    place.write_picture("narrow.png", &noise(300, 40, RGB, 1));
    fs::create_dir(place.path("there")).unwrap();
    fs::write(place.path("no.png"), "no picture").unwrap();
    let two = "--kind corner --colors 2";
    for (args, words) in [
        (
            format!("a.png {two} -o t"),
            "is 72 x 64 texels: expected at least 88 x 88, for tiles of 64",
        ),
        (format!("narrow.png {two} -o t"), "example 1 is 300 x 40 texels"),
        (format!("a.png b.png {two} --tile-size 32 -o t"), "example 2: 1 channels of 8 bits"),
        (
            format!("a.png {two} --map b.png -o t"),
            "b.png is 70 x 64 texels: expected 72 x 64, as a.png",
        ),
        (format!("a.png {two} --map c.png,c.png -o t"), "2 files for 1 examples"),
        (format!("a.png {two} --map c.png --map c.png -o t"), "expected files of different names"),
        (format!("a.png {two} --tile-size 33 -o t"), "tiles of 33 texels: expected an even number"),
        (format!("a.png {two} --tile-size 4 -o t"), "tiles of 4 texels"),
        (format!("a.png {two} --strip 17 -o t"), "a strip of 17 texels: expected 1 to 16"),
        (format!("a.png {two} --strip 0 -o t"), "a strip of 0 texels"),
        (
            "a.png --kind corner --colors 1 --tile-size 32 -o t".into(),
            "1 colors: expected at least 2",
        ),
        (
            "a.png --kind wang --colors 3,1 --tile-size 32 -o t".into(),
            "3,1 colors: expected at least 2",
        ),
        ("a.png --kind corner --colors 60 -o t".into(), "12960000 tiles of 64 x 64 texels"),
        ("a.png --kind domino --colors 3 -o t".into(), "not dominoes"),
        (format!("a.png {two} --method cohen --tile-size 32 -o t"), "cohen is for Wang tiles"),
        (format!("a.png {two} --tile-size 32 -o there"), "is already there"),
        (format!("a.png {two} --tile-size 32 -o no/where"), "no/"),
        (format!("no.png {two} -o t"), "expected a PNG"),
        (format!("none.png {two} -o t"), "none.png"),
        ("a.png -o t".into(), "--kind"),
        ("--example gold -o t.png".into(), "expected stone, grass, bricks, leaves"),
        ("--example stone --size 8x8 -o t.png".into(), "8 x 8 texels: expected 16 to 4096"),
        ("--example stone --kind corner -o t.png".into(), "--kind does not go with it"),
    ] {
        place.refused(&format!("fill {args}"), words);
    }
}

#[test]
fn an_example_is_drawn_as_asked() {
    let place = Place::new();
    let told = place.json("fill --example bricks-height --size 40x24 --seed 7 -o b.png --json");
    assert_eq!((&told["width"], &told["height"]), (&40.into(), &24.into()));
    let image = place.picture("b.png");
    assert_eq!((image.width(), image.height()), (40, 24));
    assert_eq!(image.format(), Format { light: Light::Linear, ..GRAY });
}
