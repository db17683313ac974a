//! The examples of the documentation, and what files look like that are written.

use crate::{bare, corner_2, input, written};
use serde_json::{Value, json};
use tilepack::dappled::brick::{Wall, boundary};
use tilepack::dappled::{FREE, notation};
use tilepack::store::{
    Claim, Layout, PartResult, SearchPlan, holds_cubes, read_border, read_cubes, read_pins,
    read_probabilities, read_solution, read_tile_set, solutions, write_cubes, write_grid,
    write_solution,
};
use tilepack::tiles::Kind;
use tilepack::torus::{Shape, Topology};
use tilepack::verify::{check, check_cube_packing};

/// The fenced blocks of a page, each with the words after its fence.
fn examples(page: &str) -> Vec<(&str, &str)> {
    let blocks = page.split("```").skip(1).step_by(2);
    blocks.map(|block| block.split_once('\n').unwrap()).collect()
}

/// A file that is read only from the disk.
fn on_disk(text: &str) -> tempfile::NamedTempFile {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    file
}

#[test]
fn every_example_in_the_documentation_is_read() {
    let mut seen = Vec::new();
    let mut name = String::new();
    for (language, text) in examples(include_str!("../../docs/formats.md")) {
        let input = input(text);
        let claim = match language {
            "text bare-corner-2" => bare(Kind::Corner, 2),
            _ => Claim::default(),
        };
        match language {
            "json solution" | "text grid" | "text bare-corner-2" => {
                let packing = read_solution(&input, &claim).unwrap().packing;
                assert_eq!(check(&packing).to_string(), "valid", "{text}");
            }
            "json solutions" => {
                let all: Vec<_> = solutions(&input, &claim).map(Result::unwrap).collect();
                assert_eq!(all.iter().map(|s| s.line).collect::<Vec<_>>(), [1, 2]);
                assert!(all.iter().all(|solution| check(&solution.packing).is_valid()));
            }
            "text pins-corner-2-4x4" | "json pins-corner-2-4x4" => {
                let (lattice, set) = corner_2();
                assert!(read_pins(&input, lattice, &set).unwrap().pinned() >= 5, "{text}");
            }
            "text border-3x2" => {
                let shape = Shape::new(3, 2).unwrap();
                let border = read_border(&input, Topology::Rectangle, shape).unwrap();
                assert_eq!(border.side(3), [Some(0), None]);
            }
            "text probabilities" => {
                let grid = read_probabilities(&input).unwrap();
                assert_eq!((grid.shape.to_string(), grid.colors), ("3x2".to_owned(), 2));
            }
            "text field" => {
                let field = notation::field(text, 3).unwrap();
                assert_eq!((field.width(), field.at(1, 1), field.at(2, 1)), (3, FREE, 2));
            }
            "text limits-3x2" => {
                assert_eq!(notation::map(text, (3, 2)).unwrap()[2..4], [u32::MAX, 3]);
            }
            "text boundary-3x2" => {
                boundary::read(text, &mut Wall::rectangle((3, 2), 3)).unwrap();
            }
            "text region" => {
                assert_eq!(
                    boundary::region(text).unwrap().1.iter().filter(|&&tile| tile).count(),
                    8
                );
            }
            "json cubes" => {
                assert!(holds_cubes(&input));
                let cubes = read_cubes(&input).unwrap().packing;
                assert_eq!(check_cube_packing(&cubes), Ok(()));
                // It is written as it is shown, but for the palettes.
                let shown = text.replace("[1, 2, 1]", "[1,2,1]");
                assert_eq!(written(|out| write_cubes(out, &cubes, &Value::Null)), shown.as_bytes());
            }
            "json tile-set" => {
                assert_eq!(read_tile_set(&input, None).unwrap().set.size(), 3, "{text}");
            }
            "json plan" => {
                let file = on_disk(text);
                let plan = SearchPlan::read(file.path()).unwrap();
                assert_eq!((plan.parts, plan.frontier.depth), (7, 9));
                // It is written as it is shown.
                plan.write(file.path()).unwrap();
                assert_eq!(std::fs::read_to_string(file.path()).unwrap(), text);
                name = plan.name;
            }
            "json part" => {
                let file = on_disk(text);
                let part = PartResult::read(file.path()).unwrap();
                assert_eq!((part.plan.as_str(), part.number, part.of), (name.as_str(), 0, 7));
                part.write(file.path()).unwrap();
                assert_eq!(std::fs::read_to_string(file.path()).unwrap(), text);
            }
            other => panic!("an example of an unknown sort: {other}"),
        }
        seen.push(language);
    }
    assert_eq!(seen.len(), 26);
}

#[test]
fn pretty_solutions_look_like_this() {
    let text = "kind=wang colors=2,1 set=pruned:0-1 cover\n0\n3\n";
    let packing = read_solution(&input(text), &Claim::default()).unwrap().packing;
    let pretty = written(|out| write_solution(out, &packing, &json!({"seed": 1}), Layout::Pretty));
    let expected = r#"{
  "format": "tilepack/1",
  "kind": "wang",
  "colors": [2,1],
  "set": {"pruned":[[0,1]]},
  "cover": true,
  "width": 1,
  "height": 2,
  "topology": "torus",
  "tiles": [
    [0],
    [3]
  ],
  "provenance": {"seed":1}
}
"#;
    assert_eq!(String::from_utf8(pretty).unwrap(), expected);
    let line = written(|out| write_solution(out, &packing, &Value::Null, Layout::Line));
    let expected = concat!(
        r#"{"format":"tilepack/1","kind":"wang","colors":[2,1],"set":{"pruned":[[0,1]]},"#,
        r#""cover":true,"width":1,"height":2,"topology":"torus","tiles":[[0],[3]]}"#,
        "\n"
    );
    assert_eq!(String::from_utf8(line).unwrap(), expected);
    let grid = written(|out| write_grid(out, &packing));
    assert_eq!(String::from_utf8(grid).unwrap(), text);
}
