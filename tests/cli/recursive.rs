//! Recursive packings: `verify --recursive`, `--ring wei`, `find --recursive`, pins for the beam.

use crate::{CORNER_2, Place, run};

const PUBLISHED: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/solutions/published/lagae-dutre-2006-corner-4.txt");

#[test]
fn the_published_packing_is_recursive() {
    let place = Place::new();
    let args = ["verify", "--recursive", "--kind", "corner", "--colors", "4", PUBLISHED];
    let told = place.run_with(args, "").exits(0).stdout;
    let blocks = "; recursive: 9x9 block over 3 colors at row 7, column 0; 4x4 block over 2 colors \
                  at row 12, column 0; 1x1 block over 1 color at row 15, column 0\n";
    assert!(told.ends_with(blocks), "{told}");
    let args = [&args[..], &["--json"]].concat();
    let object = place.run_with(args, "").exits(0).json();
    assert_eq!(object["files"][0]["recursive"], 3);
    // One column moved: still a packing.
    let grid = std::fs::read_to_string(PUBLISHED).unwrap();
    let moved: Vec<String> = grid
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split_once(' ').map(|(a, rest)| format!("{rest} {a}")).unwrap())
        .collect();
    place.write("moved", moved.join("\n"));
    let verify = "verify --kind corner --colors 4 moved";
    place.run(verify).exits(0);
    let told = place.run(&format!("{verify} --recursive")).exits(1).stdout;
    let fault = "moved: a packing, but not recursive: the 9x9 block over 3 colors at row 7, column \
                 0 has color 3 (";
    assert!(told.starts_with(fault), "{told}");
    let object = place.run(&format!("{verify} --recursive --json")).exits(1).json();
    let file = &object["files"][0];
    assert_eq!((&file["valid"], &file["recursive"]), (&false.into(), &0.into()));
    assert!(file["error"].as_str().unwrap().starts_with("not recursive: the 9x9 block"));
}

#[test]
fn several_packings() {
    let place = Place::new();
    place.run("list --kind corner --colors 2 -o all.jsonl").exits(0);
    place.run("verify --recursive all.jsonl").exits(0);
    place.run("find --kind wang --colors 3 -o least.json").exits(0);
    place.run("find --kind wang --colors 3 --ring wei -o wei.json").exits(0);
    place.write("both", place.read("wei.json") + &place.read("least.json"));
    let told = place.run("verify --recursive both").exits(1).stdout;
    assert!(told.contains("both: packing 2, line 22: not recursive: "), "{told}");
    assert!(told.ends_with("both: 1 of 2 packings are valid\n"), "{told}");
    place.run("verify both").exits(0);
}

#[test]
fn locate_in_weis_order() {
    for problem in ["--kind wang --colors 3,4", "--kind domino --colors 5 --size 1x25"] {
        let find = format!("find {problem} --ring wei --json");
        let object = run(&find).exits(0).json();
        for (row, tiles) in object["tiles"].as_array().unwrap().iter().enumerate().step_by(4) {
            let tile = &tiles[0];
            let said = run(&format!("locate {problem} --ring wei {tile}")).exits(0).stdout;
            assert!(said.ends_with(&format!(": row {row}, column 0\n")), "{said}");
        }
    }
}

#[test]
fn found_around_given_cells() {
    let place = Place::new();
    let found = place.run("find --kind corner --colors 3 --recursive --seed 4").exits(0);
    assert!(found.stdout.starts_with("# found by beam search around a packing"), "{found:#?}");
    place.write("r.txt", &found.stdout).run("verify --recursive r.txt").exits(0);
    place.run("find --kind corner --colors 3 --recursive --seed 4 -o r.json").exits(0);
    place.run("verify --recursive r.json").exits(0);
    // The same with pins.
    let mut pins = String::new();
    for (at, row) in found.stdout.lines().skip(3).enumerate() {
        let keep = if at == 0 || at > 4 { 9 } else { 0 };
        let free = |(i, color)| if i < keep { color } else { "." };
        let row: Vec<&str> = row.split(' ').take(5).enumerate().map(free).collect();
        pins += &format!("{} . . . .\n", row.join(" "));
    }
    place.write("pins.txt", pins);
    let find = "find --kind corner --colors 3 --method beam --pin pins.txt";
    let pinned = place.run(find).exits(0).stdout;
    place.write("p.txt", pinned).run("verify --recursive p.txt").exits(0);
}

#[test]
fn mistakes() {
    let place = Place::new();
    place.write("twice.txt", "0 0 0 .\n0 0 0 .\n. . . .\n. . . .\n").write("c", CORNER_2);
    for (args, complaint) in [
        ("find --kind corner --colors 3 --ring wei", "for all dominoes or all Wang tiles"),
        ("find --kind wang --colors 3 --set compact --ring wei", "for all dominoes or all Wang"),
        ("find --kind wang --colors 3 --ring wei --seed 2", "a seed chooses other rings"),
        ("find --kind wang --colors 3 --ring wei --method search", "use --method construct"),
        ("find --kind wang --colors 3 --ring wei --order row", "--order is for a search"),
        ("locate --kind corner --colors 3 --ring wei 1", "for all dominoes or all Wang tiles"),
        ("locate --kind wang --colors 3 --ring wei --seed 2 1", "a seed chooses other rings"),
        ("find --kind wang --colors 3 --recursive", "--recursive is for corner tiles"),
        ("find --kind corner --colors 3 --recursive --method search", "needs --method beam"),
        ("find --kind corner --colors 3 --recursive --size 27x3", "C^2 x C^2"),
        ("find --kind corner --colors 3 --recursive --set compact", "C^2 x C^2"),
        ("find --kind corner --colors 2 --method beam --pin twice.txt", "use a tile twice"),
    ] {
        let run = place.run(args).exits(2);
        assert!(run.stderr.contains(complaint) && run.stdout.is_empty(), "{args}: {run:#?}");
    }
}
