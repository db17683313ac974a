//! `export-cnf` and `export-xcc`: files, sizes, refusals, and the way back from a model.

use crate::{Place, names, run};

/// The colors of the one packing over two colors, as a solver prints them.
const MODEL: &str = "c solved\ns SATISFIABLE\nv 1 -2 3 -4 5 -6 -7 8 9 -10 11 -12 -13 14 15 -16\n\
                     v -17 18 19 -20 -21 22 -23 24 25 -26 -27 28 -29 30 -31 32 0\n";

const CORNER: &str = "export-cnf --kind corner --colors 2";

#[test]
fn problems_go_to_standard_output_or_a_file() {
    let place = Place::new();
    let text = place.run(CORNER).exits(0);
    assert!(text.stdout.starts_with("c tilepack "), "{text:?}");
    assert!(text.stdout.contains("complete corner set over 2 colors, 4x4 torus\n"));
    assert!(text.stdout.contains("\nc 9 to 10: row 1, column 0\n"));
    assert!(text.stderr.contains("512 variables, "), "{}", text.stderr);
    let object = place.run(&format!("{CORNER} --quiet --json -o c.cnf")).exits(0);
    assert_eq!(object.stderr, "");
    let object = object.json();
    assert_eq!(names(&object), ["clauses", "file", "format", "result", "variables"]);
    assert_eq!((&object["format"], &object["variables"]), (&"cnf".into(), &512.into()));
    assert_eq!(place.read("c.cnf"), text.stdout);
    let clauses = format!("\np cnf 512 {}\n", object["clauses"]);
    assert!(text.stdout.contains(&clauses), "{clauses}");

    let xcc = "export-xcc --kind corner --colors 2";
    let text = place.run(xcc).exits(0);
    assert!(text.stdout.contains("for DLX2;"), "{text:?}");
    let object = place.run(&format!("{xcc} --json -o c.xcc")).exits(0).json();
    let fields = ["file", "format", "items", "options", "result", "secondary_items"];
    assert_eq!(names(&object), fields);
    assert_eq!((&object["items"], &object["options"]), (&32.into(), &256.into()));
    assert_eq!(place.read("c.xcc"), text.stdout);
}

#[test]
fn a_model_becomes_a_packing() {
    let place = Place::new();
    let place = place.write("model", MODEL);
    let grid = place.run(&format!("{CORNER} --model model --quiet")).exits(0);
    assert_eq!(
        grid.stdout,
        "# model of a SAT solver\nkind=corner colors=2 set=complete\n\
         0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 1\n"
    );
    assert_eq!(
        place.feed(&format!("{CORNER} --model - --quiet"), MODEL).exits(0).stdout,
        grid.stdout
    );
    place.run(&format!("{CORNER} --model model -o found.json")).exits(0);
    place.run("verify found.json").exits(0);
    let object = place.run(&format!("{CORNER} --model model --json")).exits(0).json();
    assert_eq!((&object["result"], &object["method"]), (&"found".into(), &"model".into()));
}

#[test]
fn other_answers_of_a_solver() {
    let place = Place::new();
    let said = |text: &str| place.feed(&format!("{CORNER} --model -"), text);
    assert!(said("s UNSATISFIABLE\n").exits(1).stdout.starts_with("none: "));
    said("s UNKNOWN\n").exits(75);
    for (text, error) in [
        ("", "no answer and no literals"),
        ("v 1 two 0\n", "line 1: 'two' is neither"),
        ("s SATISFIABLE\nv 1 9999 0\n", "line 2: there is no variable 9999"),
        ("v 1 2 0\n", "2 of the variables 1 to 2 hold: row 0, column 0"),
        ("v 1 0\n", "0 of the variables 3 to 4 hold: row 0, column 1"),
        (&MODEL.replace("-31 32", "31 -32"), "not a packing"),
    ] {
        let run = said(text).exits(2);
        assert!(run.stderr.contains(error), "{text}: {run:?}");
    }
    place.write("pin", "kind=corner colors=2\n1 . . .\n. . . .\n. . . .\n. . . .\n");
    let run = place.feed(&format!("{CORNER} --pin pin --model -"), MODEL).exits(2);
    assert!(run.stderr.contains("row 0, column 0 is not as given beforehand"), "{run:?}");
}

#[test]
fn refusals() {
    let place = Place::new();
    let run_in = |args: &str| place.run(args).exits(2).stderr;
    assert!(run_in(&format!("{CORNER} --json")).contains("--json needs -o"));
    assert!(run_in(&format!("{CORNER} -o no/such/folder")).contains("no/such"));
    let compact = "export-xcc --kind wang --colors 2 --set compact --size 3x3 --cover";
    assert!(run_in(compact).contains("exact cover with colors cannot say it"));
    let large = run("export-cnf --kind corner --colors 14").exits(2).stderr;
    assert!(large.contains("38416 tiles make 1475789056 ways"), "{large}");
    assert!(std::fs::read_dir(place.path(".")).unwrap().next().is_none());
}
