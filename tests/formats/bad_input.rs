//! The command `export`: what it refuses, and that it then writes nothing.

use crate::Place;
use serde_json::Value;

const CORNER: &str = "kind=corner colors=2\n0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 1\n";

fn place() -> Place {
    let place = Place::new();
    place.write("p.txt", CORNER);
    place.write("ring.txt", "kind=domino colors=2\n0 1 3 2\n");
    place.write("wrong.txt", CORNER.replace("1 0 1 1", "1 0 1 0"));
    place.write("board.txt", "kind=wang colors=2 set=tiles:1 topology=rectangle\n1\n");
    place.write("turned.txt", "kind=wang colors=2 set=tiles:0 rotations\n0/0\n");
    place
}

#[test]
fn what_makes_no_sense_is_refused() {
    let place = place();
    let cases = [
        ("p.txt --to nothing", "preview-svg, preview-png, contact-sheet"),
        (
            "p.txt --to preview-svg --margin 2",
            "--margin: preview-svg does not know it; it knows --tile-size, --indices",
        ),
        ("p.txt --to tiled-tsx --size 3x3", "--size: tiled-tsx does not know it"),
        ("p.txt --to ktx2", "ktx2 needs -o FILE"),
        ("p.txt --to obj", "obj needs -o FILE"),
        ("p.txt --to preview-svg --json", "--json needs -o FILE"),
        ("p.txt --to ktx2 -o out", "ktx2 needs --image FILE"),
        ("p.txt --to ktx2 --image none.png -o out", "none.png: "),
        ("p.txt --to dds --image p.txt -o out", "p.txt: "),
        ("p.txt --to obj -o out.mtl", "out.mtl: the material of the model goes there"),
        (
            "p.txt --to demo-svg --size 1000x1000 -o out",
            "--size 1000x1000: 1000000 tiles, expected 65536 or fewer",
        ),
        ("p.txt --to tiled-tmx --size 0x1 -o out", "size 0x1: both sides must be at least 1"),
        (
            "p.txt --to demo-png --size 200x200 --tile-size 100 -o out",
            "a picture of 20000x20000 texels: expected 67108864 or fewer",
        ),
        ("p.txt --to puzzle-svg --tile-size 9 -o out", "pieces of 9 mm: expected 10 mm or more"),
        ("p.txt --to preview-svg --tile-size 0 -o out", "1..=16384"),
        ("ring.txt --to preview-svg -o out", "ring.txt: a ring of dominoes has no square tiles"),
        (
            "board.txt --to tiled-tsx -o out",
            "board.txt: on a rectangle the tiles at opposite sides need not fit",
        ),
        ("turned.txt --to tiled-tsx -o out", "turned.txt: squares that may be turned"),
        ("wrong.txt --to tiled-tsx -o out", "wrong.txt: not a packing: "),
        ("none.txt --to tiled-tsx -o out", "none.txt: no such file"),
        ("p.txt --to tiled-tsx -o no/where", "no/where: cannot be written"),
    ];
    for (args, expected) in cases {
        let run = place.run(&format!("export {args}"));
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{args}: {run:?}");
        assert!(run.stderr.contains(expected), "{args}: {run:?}");
        assert!(!place.path("out").exists() && !place.path("out.mtl").exists(), "{args}");
    }
}

#[test]
fn what_is_written_is_told() {
    let place = place();
    let run = place
        .run("export p.txt --to tiled-tsx --tile-size 8 --margin 2 --spacing 4 --json -o a.tsx");
    let told: Value = serde_json::from_str(&run.stdout).unwrap();
    let expected = serde_json::json!({
        "result": "written", "format": "tiled-tsx", "file": "a.tsx", "image": "a.png",
        "image_width": 48, "image_height": 48,
    });
    assert_eq!((run.code, told), (0, expected));
    assert_eq!(run.stderr, "tilepack: for a picture a.png of 48x48 texels; written to a.tsx\n");
    // The same bytes, to a file and to standard output.
    let args = "export p.txt --to tiled-tsx --tile-size 8 --margin 2 --spacing 4 --image a.png";
    let printed = place.run(args).stdout.replace("\"tilepack\"", "\"a\"");
    assert_eq!(printed, place.read("a.tsx"));
    let run = place.run("export p.txt --to obj --json --quiet -o m.obj");
    let told: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((&told["tiling"], &told["material"]), (&"by random colors".into(), &"m.mtl".into()));
    assert!(place.read("m.obj").contains("\nmtllib m.mtl\n"));
    assert!(place.read("m.mtl").ends_with("map_Kd m.png\n"));
}

/// A picture goes through the formats of graphics cards.
#[test]
fn pictures_become_textures() {
    let place = place();
    // A demo without lines around it has the size of a packing.
    let run = place.run("export p.txt --to demo-png --size 4x4 --tile-size 16 --quiet -o a.png");
    assert_eq!(run.code, 0, "{run:?}");
    for (format, begin) in [("ktx2", &b"\xabKTX 20\xbb"[..]), ("dds", b"DDS ")] {
        let run =
            place.run(&format!("export p.txt --to {format} --image a.png --linear -o a.{format}"));
        assert_eq!(run.code, 0, "{run:?}");
        assert_eq!(
            run.stderr,
            format!("tilepack: 64x64 texels, 5 levels; written to a.{format}\n")
        );
        let bytes = std::fs::read(place.path(&format!("a.{format}"))).unwrap();
        assert!(bytes.starts_with(begin) && bytes.len() > 64 * 64 * 4);
    }
    place.run("export p.txt --to demo-png --size 4x3 --tile-size 16 --quiet -o b.png");
    let run = place.run("export p.txt --to dds --image b.png -o b.dds");
    assert!(run.stderr.contains("b.png: 64x48 texels are not 4x4 square tiles"), "{run:?}");
    assert_eq!(run.code, 2);
}
