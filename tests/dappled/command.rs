//! `dapple make` and `brick` as users meet them.

use crate::program;
use serde_json::Value;
use tempfile::TempDir;

/// A folder to work in.
struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    /// Runs the program: exit code, standard output, standard error.
    fn run(&self, args: &str) -> (i32, String, String) {
        program::run(&self.0, args)
    }

    fn json(&self, args: &str) -> Value {
        serde_json::from_str(&self.run(args).1).unwrap()
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.path().join(name), text).unwrap();
    }

    fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.0.path().join(name)).unwrap()
    }

    /// The command is refused; its message says this.
    fn refused(&self, args: &str, says: &str) {
        let (code, out, message) = self.run(args);
        assert_eq!((code, &*out), (2, ""), "{args}: {message}");
        assert!(message.contains(says), "{args}: {message}");
    }
}

#[test]
fn tilings_are_made_checked_and_kept() {
    let place = Place::new();
    let (code, out, remark) = place.run("dapple make --size 24x10 --seed 3");
    assert_eq!((code, out.lines().count()), (0, 10));
    assert!(remark.contains("24x10 cells") && remark.contains("algorithm 1"), "{remark}");
    place.write("a.txt", &out);
    assert_eq!(place.run("dapple check a.txt").0, 0);
    // As text and as a picture, again: nothing changes.
    place.run("dapple make --from a.txt -o a.png --quiet");
    let again = place.json("dapple make --from a.png --json -o b.txt");
    assert_eq!((&again["result"], &again["changed"]), (&"found".into(), &0.into()));
    assert!(String::from_utf8(place.read("b.txt")).unwrap().ends_with(&out));
    // Free cells begin as told.
    place.write("free.txt", "....\n....\n....\n");
    let (_, out, _) = place.run("dapple make --from free.txt --start empty --quiet");
    assert_eq!(out, "0010\n0010\n1101\n");
    for threads in [1, 3] {
        let args = "dapple make --size 1200x90 --order wavefront --quiet --threads";
        assert_eq!(place.run(&format!("{args} {threads} -o {threads}.png")).0, 0);
    }
    assert!(place.read("1.png") == place.read("3.png"));
    let made = place.json("dapple make --size 5x5 --tiles 3 --limits 1,1 --cyclic --json");
    assert_eq!(made["rows"].as_array().unwrap().len(), 5);
    let (code, out, _) = place.run("dapple make --size 5x4 --limits 1,1 --cyclic");
    assert_eq!((code, &*out), (1, "none: no tiling of this size keeps these limits\n"));
}

#[test]
fn walls_are_built() {
    let place = Place::new();
    let (code, _, remark) = place.run("brick --size 9x7 --cyclic --positions 4 -o wall.txt");
    assert_eq!(code, 0, "{remark}");
    let (code, out, _) = place.run("verify wall.txt");
    assert!(code == 0 && out.contains("9x7 torus"), "{out}");
    place.run("brick --size 9x7 --cyclic -o wall.json");
    assert_eq!(place.run("verify wall.json").0, 0);
    assert_eq!(place.run("brick --size 9x7").1.lines().count(), 7);
    for file in ["wall.svg", "wall.png"] {
        assert_eq!(place.run(&format!("brick --size 5x4 --seed 2 -o {file}")).0, 0);
    }
    assert!(place.read("wall.svg").starts_with(b"<svg "));
    place.write("region.txt", "###\n#.#\n###\n");
    place.write("all.txt", "north 0 1 2\neast 0 0 1\n1 0 east 2\n");
    let built = place.json("brick --region region.txt --boundary all.txt --json");
    assert_eq!(built["tiles"][1][1], Value::Null);
    // A single row whose ends differ, all h-tiles.
    place.write("labels.txt", "000\n");
    place.write("ends.txt", "west 0\neast 1\n");
    let (code, out, _) = place.run("brick --labels labels.txt --boundary ends.txt");
    assert_eq!(code, 1);
    assert!(out.contains("row 0: from position 0 to 1 in 0 moves"), "{out}");
    assert_eq!(place.run("brick --size 3x3 --positions 3 --count").1, "191102976 walls\n");
    let counted = place.json("brick --labels labels.txt --positions 3 --count --json");
    assert_eq!(counted["walls"], (3 * 6 * 6 * 6).to_string());
}

#[test]
fn brick_tiles_are_a_texture() {
    let place = Place::new();
    let made =
        place.json("brick --positions 3 --set-out b.json --tiles-out b --tile-size 16 --json");
    assert_eq!(made["set_size"], 36);
    assert_eq!(place.run("find --set b.json --values random -o p.json --quiet").0, 0);
    let (code, _, message) =
        place.run("atlas p.json --fill b --strip 2 -o atlas.png --check --quiet");
    assert_eq!(code, 0, "{message}");
    place.run("brick --positions 3 --tiles-out sheet.png --tile-size 16");
    let sheet = "atlas p.json --fill sheet.png --sheet b.json --strip 2 -o other.png --quiet";
    assert_eq!(place.run(sheet).0, 0);
    assert!(place.read("atlas.png") == place.read("other.png"));
    place.run("brick --positions 3 --size 16x16 --cyclic -o map.txt");
    let shader = "export p.json --to glsl-es-300 --coloring map:map.txt -o wall.glsl";
    let (code, _, message) = place.run(shader);
    assert_eq!(code, 0, "{message}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let place = Place::new();
    place.write("ragged.txt", "01\n0\n");
    place.write("strange.txt", "01\n02\n");
    place.write("map.txt", "1 2\n0 3\n");
    place.write("small.txt", "1 2\n");
    place.write("broken.png", "this is no picture");
    place.write("free.txt", "0.\n");
    place.refused("dapple make", "Expected --size WxH or --from FILE");
    place.refused("dapple make --size 0x3", "at least 1");
    place.refused("dapple make --size 70000x70000", "cells");
    place.refused("dapple make --size 3x3 --limits 0,2", "a limit of 0");
    place.refused("dapple make --size 3x3 --limits 5:2,2", "tile 5");
    place.refused("dapple make --size 2x2 --limits @map.txt,2", "map.txt:2:1");
    place.refused("dapple make --size 2x2 --limits @small.txt,2", "expected 2x2");
    place.refused("dapple make --size 2x2 --limits @none.txt,2", "no such file");
    place.refused("dapple make --from ragged.txt", "ragged.txt:2:1");
    place.refused("dapple make --from strange.txt", "strange.txt:2:2");
    place.refused("dapple make --from broken.png", "expected a PNG");
    place.refused("dapple make --from free.txt --size 3x1", "2x1 cells, but --size 3x1");
    place.refused("dapple make --size 4x4 -o no/where.txt", "no/where.txt");
    place.refused("brick", "which wall?");
    place.refused("brick --size 4x4 --limits 2", "expected P,Q");
    place.refused("brick --size 4x4 --limits 0,2", "expected P,Q");
    place.refused("brick --size 4x4 -o wall.json", "expected --cyclic");
    place.refused("brick --labels free.txt", "no label");
    place.refused("brick --labels strange.txt", "strange.txt:2:2");
    place.refused("brick --size 2x2 --boundary ragged.txt", "ragged.txt:1:1");
    place.refused("brick --size 4x4 --region ragged.txt", "cannot be used with");
}
