//! Certificates as files: written, checked, changed, refused.

use crate::naive::fills;
use assert_cmd::cargo::cargo_bin_cmd;
use proptest::prelude::*;
use serde_json::{Value, json};
use tempfile::TempDir;
use tilepack::tiles::Kind;
use tilepack::verify::{Claim, ClaimFault, check_claim};

struct Place(TempDir);

impl Place {
    fn run(&self, args: &str) -> (i32, String, String) {
        let mut command = cargo_bin_cmd!("tilepack");
        let output = command.current_dir(self.0.path()).args(args.split(' ')).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
    }

    fn write(&self, name: &str, value: &Value) {
        std::fs::write(self.0.path().join(name), value.to_string()).unwrap();
    }

    fn read(&self, name: &str) -> Value {
        serde_json::from_str(&std::fs::read_to_string(self.0.path().join(name)).unwrap()).unwrap()
    }
}

#[test]
fn decide_writes_what_verify_accepts() {
    let place = Place(TempDir::new().unwrap());
    let periodic = json!({"kind": "corner", "tiles": [[0,1,2,1],[1,2,0,2],[2,0,1,0],[0,0,1,1]]});
    place.write("a.json", &periodic);
    let (code, out, err) = place.run("aperiodic decide a.json --certificate p.json --json");
    let answer: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}{err}"));
    assert_eq!((code, &answer["verdict"]), (0, &json!("periodic")), "{answer}");
    let (code, out, _) = place.run("verify p.json");
    assert!(code == 0 && out.contains("valid: 4 corner tiles fill the plane"), "{out}");
    let mut changed = place.read("p.json");
    changed["torus"][0][0] = json!(3);
    place.write("p.json", &changed);
    let (code, out, _) = place.run("verify p.json");
    assert!(code == 1 && out.contains("does not fit"), "{out}");
    changed["torus"][0].as_array_mut().unwrap().pop();
    place.write("p.json", &changed);
    assert_eq!(place.run("verify p.json").0, 2);

    let none = json!({"kind": "wang", "tiles": [[0,0,1,0],[1,0,2,0]]});
    place.write("b.json", &none);
    let (code, out, err) = place.run("aperiodic decide b.json --certificate n.json");
    assert_eq!((code, out.starts_with("no-tiling: no 3 x 3 square")), (1, true), "{out}");
    assert!(err.contains("warning: tile 0 [0, 0, 1, 0] has no neighbor to the north"), "{err}");
    assert_eq!(place.run("verify n.json").0, 0);
    let mut changed = place.read("n.json");
    changed["square"] = json!(2);
    place.write("n.json", &changed);
    let (code, out, _) = place.run("verify n.json");
    assert!(code == 1 && out.contains("a square of 2 x 2 can be filled"), "{out}");

    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/data/aperiodic/culik13.json");
    let (code, out, _) = place.run(&format!("aperiodic decide {data} --certificate c.json"));
    assert!(code == 0 && out.starts_with("aperiodic: the published set \"Culik 1996"), "{out}");
    assert_eq!(place.run("verify c.json").0, 0);
    let mut changed = place.read("c.json");
    changed["images"][0] = changed["images"][1].clone();
    place.write("c.json", &changed);
    assert_eq!(place.run("verify c.json").0, 1);
}

#[test]
fn bad_input_is_refused_with_its_place() {
    let place = Place(TempDir::new().unwrap());
    place.write("twice.json", &json!({"kind": "wang", "tiles": [[0,0,0,0],[0,0,0,0]]}));
    place.write("domino.json", &json!({"kind": "domino", "tiles": [[0,0]]}));
    for (args, said) in [
        ("aperiodic decide twice.json", "is listed twice"),
        ("aperiodic decide domino.json", "not dominoes"),
        ("aperiodic decide none.json", "none.json"),
        ("aperiodic classify --kind wang", "--tiles"),
        ("aperiodic classify --kind wang --tiles 8", "at most 7"),
        ("aperiodic classify --kind wang --tiles 3 --part 3/3", "R/M"),
        ("aperiodic classify --merge twice.json", "the result of a part"),
    ] {
        let (code, out, err) = place.run(args);
        assert!(code == 2 && err.contains(said) && out.is_empty(), "{args}: {code} {out} {err}");
    }
}

#[test]
fn parts_add_up() {
    let place = Place(TempDir::new().unwrap());
    for part in 0..3 {
        let args =
            format!("aperiodic classify --kind wang --tiles 4 --part {part}/3 -o {part}.json");
        assert_eq!(place.run(&args).0, 0);
    }
    let (code, out, _) = place.run("aperiodic classify --merge 2.json 0.json 1.json");
    assert_eq!(code, 0);
    assert_eq!(out, "998 sets: 713 periodic, 285 without a tiling, 0 undecided\n");
    assert_eq!(place.run("aperiodic classify --merge 2.json 0.json").0, 75);
    assert_eq!(place.run("aperiodic classify --merge 2.json 2.json").0, 2);
}

#[test]
fn claims_that_say_nothing_or_too_much() {
    let tiles = [[0, 0, 0, 0]];
    let check = |claim: &Claim| check_claim(Kind::Wang, &tiles, claim, 100);
    assert_eq!(check(&Claim::NoSquare { side: 0 }), Err(ClaimFault::Nothing));
    assert_eq!(check(&Claim::NoSquare { side: 1 << 40 }), Err(ClaimFault::TooLarge(100)));
    assert_eq!(check(&Claim::NoSquare { side: 5 }), Err(ClaimFault::Filled(5)));
    assert!(matches!(
        check(&Claim::NoStrip { rows: true, power: 3 }),
        Err(ClaimFault::Left { power: 3, arcs: 1, .. })
    ));
    let empty = Claim::Torus { width: 0, height: 0, cells: Vec::new() };
    assert!(matches!(check(&empty), Err(ClaimFault::Cells { .. })));
    // One row can be continued for ever, and fits below no other.
    let one = [[0, 0, 1, 0]];
    for rows in [true, false] {
        let claim = Claim::NoStrip { rows, power: 1 };
        assert_eq!(check_claim(Kind::Wang, &one, &claim, 100), Ok(()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// What is said of a square or a torus is accepted just when it is true.
    #[test]
    fn claims_are_accepted_just_when_true(
        tiles in prop::collection::btree_set(prop::array::uniform4(0u32..3), 1..7),
        side in 1usize..5,
        (width, height) in (1usize..4, 1usize..4),
        picks in prop::collection::vec(any::<prop::sample::Index>(), 9),
        corner: bool,
    ) {
        let tiles: Vec<[u32; 4]> = tiles.into_iter().collect();
        let kind = if corner { Kind::Corner } else { Kind::Wang };
        let said = check_claim(kind, &tiles, &Claim::NoSquare { side }, 1 << 20);
        let can = fills(&tiles, corner, (side, side), true);
        prop_assert_eq!(said, if can { Err(ClaimFault::Filled(side)) } else { Ok(()) });
        let cells: Vec<usize> =
            picks[..width * height].iter().map(|pick| pick.index(tiles.len())).collect();
        let fits = |one: usize, other: usize, east: bool| {
            let (one, other) = (tiles[one], tiles[other]);
            match (corner, east) {
                (false, true) => one[1] == other[3],
                (false, false) => one[2] == other[0],
                (true, true) => one[1] == other[0] && one[2] == other[3],
                (true, false) => one[3] == other[0] && one[2] == other[1],
            }
        };
        let right = (0..cells.len()).all(|at| {
            let (row, column) = (at / width, at % width);
            fits(cells[at], cells[row * width + (column + 1) % width], true)
                && fits(cells[at], cells[(row + 1) % height * width + column], false)
        });
        let said = check_claim(kind, &tiles, &Claim::Torus { width, height, cells }, 0);
        prop_assert_eq!(said.is_ok(), right);
    }

    /// An empty power is claimed of no set that fills a torus.
    #[test]
    fn no_power_of_a_periodic_set_is_empty(
        tiles in prop::collection::btree_set(prop::array::uniform4(0u32..2), 1..7),
        power in 1usize..4,
        rows: bool,
    ) {
        let tiles: Vec<[u32; 4]> = tiles.into_iter().collect();
        let claim = Claim::NoStrip { rows, power };
        let empty = check_claim(Kind::Wang, &tiles, &claim, 1 << 20).is_ok();
        let periodic = crate::naive::smallest_torus(&tiles, false, 6).is_some();
        prop_assert!(!(empty && periodic));
    }
}
